#include "light.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include <lobelia/clipped_tables.h>

#include "vulkan_failure.h"

namespace lobelia::cli {

using host::GpuBuffer;
using host::GpuImage;
using host::Memory;
using host::Outcome;

namespace {

constexpr std::uint32_t KURT2019_FACE = 64; // texels, of the paper's blurred map
constexpr std::size_t SUN_COUNT_OFFSET = 8; // bytes, in PrefilterState of lobelia/suns.glsl
constexpr VkImageUsageFlags MAP_USAGE = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT;

CubeMap lend(const GpuImage& image) {
    const host::GpuImageDescription& shape = image.description();
    return {image.handle(), shape.format, shape.width, shape.levels};
}

Outcome<GpuImage> make_clipped_tables(host::Gpu& gpu) {
    const auto tables = ClippedTables::create(gpu.device());
    if (!tables) return core_failure(tables.error());
    auto image =
        gpu.create_image({.format = ClippedTables::FORMAT,
                          .width = ClippedTables::WIDTH,
                          .height = ClippedTables::HEIGHT,
                          .layers = ClippedTables::LAYERS,
                          .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
    if (!image) return image.error();
    const auto buffer = gpu.create_buffer(
        ClippedTables::BUFFER_BYTES,
        VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, Memory::device);
    if (!buffer) return buffer.error();
    const auto done = gpu.submit([&](VkCommandBuffer commands) {
        tables->record(commands, buffer->handle(), image->handle());
    });
    if (!done) return done.error();
    return image;
}

VkFormat filterable_format(const host::Gpu& gpu) {
    VkFormatProperties found{};
    vkGetPhysicalDeviceFormatProperties(gpu.physical_device(), VK_FORMAT_R32G32B32A32_SFLOAT,
                                        &found);
    return found.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT
               ? VK_FORMAT_R32G32B32A32_SFLOAT
               : VK_FORMAT_R16G16B16A16_SFLOAT;
}

/// The lobes that stand for the specular one; nothing for methods without a ladder.
std::optional<Taps> taps_of(SphereMethod method) {
    switch (method) {
    case SphereMethod::one_tap: return Taps::one;
    case SphereMethod::two_tap: return Taps::two;
    case SphereMethod::hybrid: return Taps::five;
    default: return std::nullopt;
    }
}

bool reads_nothing_of_an_exponent(SphereMethod method) {
    return method == SphereMethod::kurt2019 || method == SphereMethod::importance ||
           method == SphereMethod::reference;
}

} // namespace

LightRequest light_request(SphereMethod method, Quality quality, float exponent) {
    if (reads_nothing_of_an_exponent(method)) return {method, Quality::normal, 0.0f};
    return {method, quality, exponent};
}

Outcome<LightPasses> LightPasses::create(host::Gpu& gpu) {
    auto prefilter = Prefilter::create(gpu.device());
    if (!prefilter) return core_failure(prefilter.error());
    auto irradiance = Irradiance::create(gpu.device());
    if (!irradiance) return core_failure(irradiance.error());
    auto mips = Mips::create(gpu.device());
    if (!mips) return core_failure(mips.error());
    auto tables = make_clipped_tables(gpu);
    if (!tables) return tables.error();
    return LightPasses{std::move(*prefilter), std::move(*irradiance), std::move(*mips),
                       std::move(*tables)};
}

Outcome<const GpuImage*> Light::keep(Outcome<GpuImage> image) {
    if (!image) return image.error();
    images_.push_back(std::make_unique<GpuImage>(std::move(*image)));
    return images_.back().get();
}
Outcome<const GpuBuffer*> Light::keep(Outcome<GpuBuffer> buffer) {
    if (!buffer) return buffer.error();
    buffers_.push_back(std::make_unique<GpuBuffer>(std::move(*buffer)));
    return buffers_.back().get();
}

Outcome<Light> Light::create(host::Gpu& gpu, const LightPasses& passes, const GpuImage& source,
                             const LightRequest& request) {
    Light light(request);
    const std::span<const float> exponent(&request.exponent, 1);
    Outcome<Done> made = Done{};
    if (const auto taps = taps_of(request.method)) {
        light.sources_.clipped_tables = passes.clipped_tables.view();
        made = light.prefilter(gpu, passes, source,
                               {.lambert = true,
                                .ladder = ladder_for(*taps, request.exponent, request.exponent),
                                .quality = request.quality});
    } else if (request.method == SphereMethod::split_sum) {
        made =
            light.prefilter(gpu, passes, source,
                            {.exponents = exponent, .lambert = true, .quality = request.quality});
    } else if (request.method == SphereMethod::sh2 || request.method == SphereMethod::sh4) {
        made = light.add_irradiance(gpu, passes, source);
        if (made)
            made = light.prefilter(gpu, passes, source,
                                   {.exponents = exponent, .quality = request.quality});
    } else if (request.method == SphereMethod::kurt2019) {
        made = light.add_mips(gpu, passes, source, KURT2019_FACE, MipWeights::equal,
                              &SphereSources::blurred);
    } else if (request.method == SphereMethod::importance) {
        made =
            light.add_mips(gpu, passes, source, 1, MipWeights::solid_angle, &SphereSources::mips);
    }
    if (!made) return made.error();
    return light;
}

Outcome<Done> Light::prefilter(host::Gpu& gpu, const LightPasses& passes, const GpuImage& source,
                               PrefilterRequest request) {
    request.source_size = source.description().width;
    const auto plan = PrefilterPlan::make(request);
    if (!plan) return core_failure(plan.error());
    std::vector<CubeMap> maps;
    for (const PrefilteredMap& map : plan->maps()) {
        const auto image = keep(gpu.create_image({.format = request.map_format,
                                                  .width = map.size,
                                                  .height = map.size,
                                                  .layers = 6,
                                                  .usage = MAP_USAGE,
                                                  .cube = true}));
        if (!image) return image.error();
        maps.push_back(lend(**image));
        const bool is_diffuse = request.lambert && maps.size() == plan->maps().size();
        (is_diffuse ? sources_.diffuse : sources_.specular) = (*image)->view();
        if (!is_diffuse) specular_filter_ = map.filter;
    }
    VkImage ladder = VK_NULL_HANDLE;
    if (plan->ladder().rungs) {
        const auto image = keep(gpu.create_image({.format = request.map_format,
                                                  .width = plan->ladder_size(),
                                                  .height = plan->ladder_size(),
                                                  .layers = 6 * plan->ladder().rungs,
                                                  .usage = MAP_USAGE}));
        if (!image) return image.error();
        ladder = (*image)->handle();
        sources_.ladder = (*image)->view();
    }
    const auto scratch = keep(gpu.create_buffer(plan->scratch_size(),
                                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                                    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT,
                                                Memory::device));
    if (!scratch) return scratch.error();
    const auto state = keep(gpu.create_buffer(
        plan->state_size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
        Memory::host));
    if (!state) return state.error();
    state_ = *state;
    sources_.prefilter_state = state_->handle();
    auto bound = passes.prefilter.bind(*plan, lend(source), maps, (*scratch)->handle(),
                                       state_->handle(), ladder);
    if (!bound) return core_failure(bound.error());
    const auto job = std::make_shared<PrefilterJob>(std::move(*bound));
    for (std::uint32_t i = 0; i < plan->pass_count(); ++i) {
        add_pass(plan->pass(i),
                 [job, i](VkCommandBuffer commands) { job->record(commands, i, 1); });
    }
    return Done{};
}

Outcome<Done> Light::add_mips(host::Gpu& gpu, const LightPasses& passes, const GpuImage& source,
                              std::uint32_t last_face, MipWeights weights,
                              VkImageView SphereSources::*view) {
    const std::uint32_t size = source.description().width;
    const auto image = keep(
        gpu.create_image({.format = filterable_format(gpu),
                          .width = size,
                          .height = size,
                          .layers = 6,
                          .levels = std::uint32_t(std::bit_width(std::max(size / last_face, 1u))),
                          .usage = MAP_USAGE,
                          .cube = true}));
    if (!image) return image.error();
    auto bound = passes.mips.bind(lend(source), lend(**image), weights);
    if (!bound) return core_failure(bound.error());
    const auto job = std::make_shared<MipsJob>(std::move(*bound));
    const std::uint64_t texels = std::uint64_t(8) * size * size; // a third of them below the first
    add_pass({"mips", texels, 16 * texels, 16 * texels},
             [job](VkCommandBuffer commands) { job->record(commands); });
    sources_.*view = (*image)->view();
    return Done{};
}

Outcome<Done> Light::add_irradiance(host::Gpu& gpu, const LightPasses& passes,
                                    const GpuImage& source) {
    const CubeMap cube = lend(source);
    const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const auto scratch =
        keep(gpu.create_buffer(Irradiance::scratch_size(cube), storage, Memory::device));
    if (!scratch) return scratch.error();
    const auto buffer =
        keep(gpu.create_buffer(Irradiance::COEFFICIENTS_SIZE,
                               storage | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, Memory::device));
    if (!buffer) return buffer.error();
    auto bound = passes.irradiance.bind(cube, (*scratch)->handle(), (*buffer)->handle());
    if (!bound) return core_failure(bound.error());
    const auto job = std::make_shared<IrradianceJob>(std::move(*bound));
    const std::uint64_t rows = std::uint64_t(6) * cube.size;
    add_pass({"irradiance", rows, 16 * rows * cube.size, (*scratch)->size()},
             [job](VkCommandBuffer commands) { job->record(commands); });
    sources_.irradiance = (*buffer)->handle();
    return Done{};
}

void Light::add_pass(const PrefilterPass& pass, std::function<void(VkCommandBuffer)> record) {
    Pass& added = passes_.emplace_back();
    added.report.name = pass.name;
    added.report.invocations = pass.invocations;
    added.report.bytes_read = pass.bytes_read;
    added.report.bytes_written = pass.bytes_written;
    added.record = std::move(record);
}

Outcome<host::PassReport> Light::run_pass(host::Gpu& gpu) {
    Pass& pass = passes_[next_];
    const auto milliseconds = gpu.submit_timed(pass.record);
    if (!milliseconds) return milliseconds.error();
    pass.report.gpu_ms = *milliseconds;
    ++next_;
    return pass.report;
}

bool Light::has_suns() const {
    std::uint32_t suns = 0;
    if (state_) std::memcpy(&suns, state_->data() + SUN_COUNT_OFFSET, sizeof suns);
    return suns > 0;
}

std::uint64_t Light::bytes() const {
    std::uint64_t bytes = 0;
    for (const auto& image : images_) {
        const host::GpuImageDescription& shape = image->description();
        const std::uint64_t texel = shape.format == VK_FORMAT_R16G16B16A16_SFLOAT ? 8 : 16;
        for (std::uint32_t level = 0; level < shape.levels; ++level)
            bytes += texel * shape.layers * std::max(shape.width >> level, 1u) *
                     std::max(shape.height >> level, 1u);
    }
    for (const auto& buffer : buffers_) bytes += buffer->size();
    return bytes;
}

} // namespace lobelia::cli
