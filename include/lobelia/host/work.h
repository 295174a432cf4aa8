#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <lobelia/host/gpu.h>
#include <lobelia/host/outcome.h>
#include <lobelia/host/read.h>
#include <lobelia/prefilter.h>
#include <lobelia/sphere.h>

namespace lobelia::host {

/// Told now and then while work goes on, `done` in [0, 1]. Answer false to cancel: the work then
/// fails with the message "cancelled".
using Progress = std::function<bool(double done)>;

/// One pass as it was run. `invocations` of the shader; bytes count each texel once a pass (its
/// footprint), never fetches. Times are absent where they were not or cannot be measured.
struct PassReport {
    std::string name;
    std::uint64_t invocations = 0;
    std::uint64_t bytes_read = 0;
    std::uint64_t bytes_written = 0;
    std::optional<double> cpu_ms; // process CPU time
    std::optional<double> gpu_ms; // device timestamps
};

/// One image that the work made.
struct ImageReport {
    std::string name;
    std::uint32_t width = 0, height = 0, layers = 0, levels = 0;
    std::string format;
    std::uint64_t bytes = 0;
    std::string lifetime; // "kept" or "scratch"
};

struct WorkReport {
    std::vector<PassReport> passes;
    std::vector<ImageReport> images;
    std::optional<std::uint32_t> suns; // taken out of the maps, where there was a prefilter
    double expected_error = 0;         // as in lobelia/expected_error.h, of maps and sphere
};

/// An environment on the device: the panorama as it was read, if it was one, and the cube map made
/// of it. All in SHADER_READ_ONLY_OPTIMAL.
struct GpuEnvironment {
    std::optional<GpuImage> panorama;
    GpuImage cube;                   // R32G32B32A32_SFLOAT, one level
    std::optional<GpuImage> resized; // the same in another size, where source() calls for it
    WorkReport report;
    bool constant = false; // all texels are known to be equal: nothing need be averaged

    /// What Prefilter and Mips read: faces of a power of two from 16 to 1024 texels.
    const GpuImage& source() const { return resized ? *resized : cube; }
};

/// The faces of the cube map that a panorama is made into where nothing else is asked for: the next
/// power of two >= width / 4, twice that for Quality::high.
std::uint32_t default_face(std::uint32_t panorama_width, Quality quality = Quality::normal);

/// Uploads `image` and makes the cube map: `face` texels, or default_face() where `face` is 0.
Outcome<GpuEnvironment> upload_environment(Gpu& gpu, const Image& image, std::uint32_t face = 0,
                                           Quality quality = Quality::normal);

constexpr std::uint32_t BUILTIN_WIDTH = 1024;

/// The built-in environment, made on the device from formulas: a clear sky, a ground, soft boxes
/// and a small bright sun, BUILTIN_WIDTH texels wide and half as high.
Outcome<GpuEnvironment> make_builtin_environment(Gpu& gpu, std::uint32_t face = 0,
                                                 Quality quality = Quality::normal);

/// A method that render() knows, as the command line names and explains it.
struct RenderMethod {
    SphereMethod method;
    const char* name;
    const char* what; // it does, for a list of methods
};
/// All of them, from the least exact on.
std::vector<RenderMethod> render_methods();

/// What each quality shades with: one-tap, two-tap, hybrid.
SphereMethod method_for(Quality quality);

struct RenderSettings {
    SphereView view;
    SphereMethod method = SphereMethod::two_tap;
    Quality quality = Quality::normal; // of Prefilter's maps, where the method reads them
    std::uint32_t samples = 64;        // of each lobe, for SphereMethod::importance: 1 to 1024
    /// Of the lobe that blurs the background, in [0, 1e6]. Infinite: sharp.
    float background_exponent = std::numeric_limits<float>::infinity();
};

struct Rendering {
    Image picture; // R G B A, colour premultiplied by the coverage A where there is no background
    WorkReport report;
};

/// Shades the sphere offscreen. Refuses materials, cameras and sizes that are not valid with a
/// message that names the value.
Outcome<Rendering> render(Gpu& gpu, const GpuEnvironment& environment,
                          const RenderSettings& settings, const Progress& progress = {});

/// Why a material is refused, or nothing. `allow_energy_gain` lets kd + ks exceed 1.
std::optional<Failure> check_material(const Material& material, bool allow_energy_gain);
/// The same of a camera, a size and a rotation; the material is not looked at.
std::optional<Failure> check_view(const SphereView& view, const VkPhysicalDeviceLimits& limits);

enum class PrefilterMethod {
    chain,               // Prefilter, read at the map's texel centres by MapReader
    importance,          // Importance at the map's texel centres, plain
    filtered_importance, // the same, filtered
    exact,               // Exact at the map's texel centres
};

struct PrefilterSettings {
    PrefilterMethod method = PrefilterMethod::chain;
    Quality quality = Quality::normal; // of the chain
    std::uint32_t samples = 64;        // of a texel, for the two importance methods: 1 to 65535
    std::vector<float> exponents;      // one map each; 1 is the Lambert lobe
    Layout layout = Layout::cube;
    std::uint32_t width = 0;  // edge of a cube's face, or width of the panorama; 0: what lobes need
    std::uint32_t height = 0; // of the panorama; 0: half its width
    bool levels = false;      // the maps are one cube's levels: each is half as wide as the one
                              // before, rounded down; more than `width` has are refused
};

struct Prefiltering {
    std::vector<Image> maps; // one for each exponent
    WorkReport report;
};

/// Averages the environment over Phong lobes: P_n of the README for each exponent.
Outcome<Prefiltering> prefilter(Gpu& gpu, const GpuEnvironment& environment,
                                const PrefilterSettings& settings, const Progress& progress = {});

} // namespace lobelia::host
