// Lobelia's part of an engine: a sky, and what shading with it reads.
#pragma once

#include <cstdint>
#include <utility>

#include <lobelia/clipped_tables.h>
#include <lobelia/panorama.h>
#include <lobelia/prefilter.h>
#include <lobelia/sky.h>
#include <lobelia/sphere.h>

#include "engine.h"

/// The value of a call that may fail.
template <class Value>
Value expect(lobelia::Result<Value> result) {
    if (!result) fail(result.error().step);
    return *std::move(result);
}

/// What `lobelia render --size 96x96` shows.
inline lobelia::SphereView default_view() {
    return {
        .material = {.diffuse = {0.3f, 0.3f, 0.3f}, .specular = {0.6f, 0.6f, 0.6f}, .exponent = 64},
        .width = 96,
        .height = 96};
}

/// Reads P_n for exponents from `least` to `most`. All that lives as long as the scene.
struct Lighting {
    static constexpr std::uint32_t FACE = 256; // texels, of the environment's cube map

    lobelia::PrefilterPlan plan;
    Image panorama, cube, diffuse, ladder, tables;
    Buffer scratch, state, tables_upload;
    lobelia::SkyJob draw_sky;
    lobelia::PanoramaToCubeJob resample;
    lobelia::PrefilterJob prefilter;
    lobelia::ClippedTables clipped_tables;

    static Lighting create(const Engine& engine, const lobelia::Device& device, float least,
                           float most);
    /// The sky in the cube map, and the tables.
    void record_environment(VkCommandBuffer commands) const;
    /// All of it. Afterwards every image is in SHADER_READ_ONLY_OPTIMAL.
    void record(VkCommandBuffer commands) const;
    /// What Lobelia's own sphere reads of it.
    lobelia::SphereSources sphere_sources() const;
    void destroy(const Engine& engine) const;
};
