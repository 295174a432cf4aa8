#pragma once

#include <nlohmann/json.hpp>

#include "panel.h"

namespace lobelia::cli {

/// What one frame showed and cost, for scripts: one line of `lobelia view --json`.
struct FrameReport {
    std::uint64_t frame = 0;
    double seconds = 0.0; // since the start
    VkExtent2D size{};
    FrameWork work;                 // before it
    std::uint64_t environments = 0; // shown so far
    bool busy = false;              // the next frame would differ though nobody does anything
};
std::string as_json_line(const FrameReport& report, const ViewState& state, const Status& status,
                         const Places& places);

} // namespace lobelia::cli
