#include "view_state.h"

#include <cmath>
#include <numbers>

namespace lobelia::cli {

SphereView shown_view(const ViewState& state, VkExtent2D extent) {
    SphereView view = state.settings.view;
    if (state.lobes == Lobes::specular) view.material.diffuse = {};
    if (state.lobes == Lobes::diffuse) view.material.specular = {};
    view.environment_rotation =
        float(std::fmod(double(state.rotation), 360.0) * std::numbers::pi / 180.0);
    view.background = state.background != Background::off;
    view.width = extent.width;
    view.height = extent.height;
    return view;
}

} // namespace lobelia::cli
