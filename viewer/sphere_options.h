#pragma once

#include <array>
#include <optional>

#include <CLI/CLI.hpp>

#include <lobelia/host/work.h>

namespace lobelia::cli {

/// What is drawn and how, as options say it; the defaults are those of the command line.
struct SphereOptions {
    std::optional<std::array<float, 3>> diffuse;  // kd
    std::optional<std::array<float, 3>> specular; // ks
    float exponent = 64.0f;                       // n
    bool allow_energy_gain = false;
    Camera camera;
    float rotation = 0.0f; // of the environment, degrees
    bool no_background = false;
    std::optional<float> blur; // exponent of the lobe that blurs the background; else it is sharp
    std::uint32_t width = 512;
    std::uint32_t height = 512;
    std::optional<SphereMethod> method;   // else by the quality
    std::optional<std::uint32_t> samples; // of each lobe
    std::optional<Quality> quality;       // else normal
    std::optional<double> tolerance;      // else none; see meet()
    std::uint32_t face = 0; // of the environment's cube map, texels; 0: as the panorama needs
};

/// Adds the options of the material, the camera, the environment and the method.
void add_sphere_options(CLI::App& verb, SphereOptions& options);

/// Refuses options that do not go together, as wrong usage.
void check_usage(const SphereOptions& options);

/// The settings that the options stand for.
host::RenderSettings settings_of(const SphereOptions& options);

/// As on the command line.
const char* method_name(SphereMethod method);

} // namespace lobelia::cli
