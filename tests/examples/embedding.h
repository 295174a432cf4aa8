// The README's embedding sample, compiled and run by embedding_test.cpp.
#pragma once

#include <array>
#include <cstdio>
#include <functional>
#include <optional>
#include <vector>

#include <lobelia/prefilter.h>

struct Engine { // what any engine has, in its own words
    VkDevice device;
    PFN_vkGetDeviceProcAddr get_device_proc_addr;
    std::function<lobelia::CubeMap(const lobelia::PrefilteredMap&)> create_map;
    std::function<VkBuffer(VkDeviceSize)> create_buffer;
};

// clang-format off
// [sample]
std::optional<lobelia::PrefilterJob> light_scene(Engine& engine, const lobelia::CubeMap& sky) {
    const std::array exponents = {16.0f, 64.0f, 700.0f}; // a map for each material, and Lambert's
    const auto plan = lobelia::PrefilterPlan::make({.exponents = exponents, .lambert = true, .source_size = sky.size});
    if (!plan) return std::nullopt;

    std::vector<lobelia::CubeMap> maps; // the engine creates what the plan says
    for (const lobelia::PrefilteredMap& map : plan->maps()) maps.push_back(engine.create_map(map));
    const VkBuffer scratch = engine.create_buffer(plan->scratch_size());
    const VkBuffer state = engine.create_buffer(plan->state_size());

    const auto prefilter = lobelia::Prefilter::create({engine.device, engine.get_device_proc_addr});
    if (!prefilter) {
        std::fprintf(stderr, "could not %s\n", prefilter.error().step);
        return std::nullopt;
    }
    auto job = prefilter->bind(*plan, sky, maps, scratch, state);
    if (!job) return std::nullopt;
    return std::move(*job); // then, whenever the sky changes: job.record(commands, 0, plan.pass_count())
}
// [sample]
// clang-format on
