#pragma once

#include <string>

#include <lobelia/host/work.h>

namespace lobelia::cli {

/// Which of the material's lobes are shown.
enum class Lobes { both, diffuse, specular };

enum class Background { sharp, blurred, off };

/// What the window shows and how: everything that a person can change.
struct ViewState {
    std::string environment;       // path; empty: the built-in one
    std::uint32_t face = 0;        // of its cube map; 0: as it needs
    host::RenderSettings settings; // of the picture, or the left one of two; neither its size,
                                   // its rotation nor its background
    SphereMethod other = SphereMethod::reference; // of the right one
    bool split = false;
    float divider = 0.5f; // where the right one begins, as a fraction of the width
    bool errors = false;  // false colour in place of the pictures
    Lobes lobes = Lobes::both;
    Background background = Background::sharp;
    float blur = 16.0f;       // exponent of the lobe that blurs the background
    float rotation = 0.0f;    // of the environment, degrees
    float exposure = 0.0f;    // stops
    float turning = 0.0f;     // of the environment, degrees a second
    bool energy_gain = false; // kd + ks may exceed 1
    bool panel = true;
    bool help = false;
    float zoom = 1.0f; // of the panel, beyond what the monitor asks for

    Material& material() { return settings.view.material; }
    const Material& material() const { return settings.view.material; }
};

constexpr float DEGREES_A_SECOND = 20.0f; // where it turns by itself

inline bool is_black(const std::array<float, 3>& colour) {
    return colour == std::array<float, 3>{};
}

/// What is drawn in a picture of that size: the lobes that are not shown made black.
SphereView shown_view(const ViewState& state, VkExtent2D extent);

} // namespace lobelia::cli
