#pragma once

#include <string_view>

#include <lobelia/host/scene_maps.h>

namespace lobelia::host {

/// Why render() refuses these settings, or nothing.
Outcome<Done> check_render(const Gpu& gpu, const RenderSettings& settings);

/// The plan's pass or resource of that name, or null.
const ScenePass* find_pass(const ScenePlan& plan, std::string_view name);
const SceneResource* find_resource(const ScenePlan& plan, std::string_view name);

/// What a report says of a pass, before its times are known, and of an image.
PassReport report_of(const ScenePass& pass);
std::vector<ImageReport> image_reports(const ScenePlan& plan);

/// The averages that SphereMethod::reference integrates before its draw, one pass for each lobe.
std::vector<PassReport> reference_passes(const ScenePlan& plan, const SphereView& view,
                                         std::uint64_t source_bytes);

} // namespace lobelia::host
