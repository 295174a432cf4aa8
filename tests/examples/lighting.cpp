#include "lighting.h"

// [create]
Lighting Lighting::create(const Engine& engine, const lobelia::Device& device, float least,
                          float most) {
    // What is needed: a map for the diffuse lobe, and a ladder of exponents for the specular one.
    const lobelia::PrefilterRequest request{
        .lambert = true,
        .ladder = lobelia::ladder_for(lobelia::Taps::two, least, most),
        .source_size = FACE};
    const auto plan = expect(lobelia::PrefilterPlan::make(request));

    // The engine makes what the plan says, from its own memory.
    const auto cube_of = [&](VkFormat format, std::uint32_t size) {
        return engine.make_image({.format = format,
                                  .width = size,
                                  .height = size,
                                  .layers = 6,
                                  .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                           VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                  .view = VK_IMAGE_VIEW_TYPE_CUBE});
    };
    const VkFormat half = VK_FORMAT_R16G16B16A16_SFLOAT, whole = VK_FORMAT_R32G32B32A32_SFLOAT;
    const std::uint32_t map = plan.maps()[0].size, rung = plan.ladder_size();
    const Image panorama = engine.make_image({.width = 4 * FACE, .height = 2 * FACE});
    const Image cube = cube_of(whole, FACE), diffuse = cube_of(half, map);
    const Image ladder = engine.make_image({.format = half,
                                            .width = rung,
                                            .height = rung,
                                            .layers = 6 * plan.ladder().rungs,
                                            .view = VK_IMAGE_VIEW_TYPE_2D_ARRAY});
    const Image tables =
        engine.make_image({.format = lobelia::ClippedTables::FORMAT,
                           .width = lobelia::ClippedTables::WIDTH,
                           .height = lobelia::ClippedTables::HEIGHT,
                           .layers = lobelia::ClippedTables::LAYERS,
                           .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                           .view = VK_IMAGE_VIEW_TYPE_2D_ARRAY});
    const Buffer scratch =
        engine.make_buffer(plan.scratch_size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                                    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
    const Buffer state = engine.make_buffer(
        plan.state_size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    const Buffer upload =
        engine.make_buffer(lobelia::ClippedTables::BUFFER_BYTES,
                           VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);

    // Pipelines, then views and descriptors. A job needs the object that it came from no longer.
    const auto sky = expect(lobelia::Sky::create(device));
    const auto resample = expect(lobelia::PanoramaToCube::create(device));
    const auto prefilter = expect(lobelia::Prefilter::create(device));
    const lobelia::CubeMap source{cube.handle, whole, FACE};
    const lobelia::CubeMap maps[] = {{diffuse.handle, half, map}};
    return {plan,
            panorama,
            cube,
            diffuse,
            ladder,
            tables,
            scratch,
            state,
            upload,
            expect(sky.bind({panorama.handle, panorama.view, 4 * FACE, 2 * FACE})),
            expect(resample.bind({panorama.handle, whole, 4 * FACE, 2 * FACE}, source)),
            expect(prefilter.bind(plan, source, maps, scratch.handle, state.handle, ladder.handle)),
            expect(lobelia::ClippedTables::create(device))};
}
// [create]

// [record]
void Lighting::record_environment(VkCommandBuffer commands) const {
    draw_sky.record(commands);
    resample.record(commands);
    clipped_tables.record(commands, tables_upload.handle, tables.handle);
}

void Lighting::record(VkCommandBuffer commands) const {
    record_environment(commands);
    prefilter.record(commands, 0, plan.pass_count());
}
// [record]

lobelia::SphereSources Lighting::sphere_sources() const {
    return {.background = cube.view,
            .diffuse = diffuse.view,
            .prefilter_state = state.handle,
            .ladder = ladder.view,
            .clipped_tables = tables.view};
}

void Lighting::destroy(const Engine& engine) const {
    for (const Image& image : {panorama, cube, diffuse, ladder, tables}) engine.destroy(image);
    for (const Buffer& buffer : {scratch, state, tables_upload}) engine.destroy(buffer);
}
