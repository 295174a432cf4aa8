#include "bench.h"

#include <sstream>

namespace lobelia::hard {

host::Gpu& Bench::gpu() {
    if (!gpu_) gpu_.emplace(value_of(host::Gpu::create({.validation = true})));
    return *gpu_;
}

const Exact& Bench::exact() {
    if (!exact_) exact_.emplace(value_of(Exact::create(gpu().device())));
    return *exact_;
}

std::vector<Average> Bench::exact(const host::Image& image, float exponent,
                                  const Directions& axes) {
    return test::ask(gpu(), exact(), test::on_device(gpu(), image), {.exponent = exponent},
                     test::unclipped(axes))
        .averages;
}

test::Prefiltered Bench::maps(const host::Image& cube, const test::Wanted& wanted) {
    if (!prefilter_) prefilter_.emplace(value_of(Prefilter::create(gpu().device())));
    return test::make_maps(gpu(), *prefilter_, test::on_device(gpu(), cube), wanted);
}

std::vector<Average> Bench::read(const test::Prefiltered& maps, std::size_t index,
                                 const Directions& axes) {
    if (!reader_) reader_.emplace(value_of(MapReader::create(gpu().device())));
    const host::GpuBuffer directions = test::storage(gpu(), axes.size() * sizeof(Average));
    const host::GpuBuffer results = test::storage(gpu(), axes.size() * sizeof(Average));
    auto* direction = reinterpret_cast<Average*>(directions.data());
    for (const Direction& d : axes) *direction++ = {float(d.x), float(d.y), float(d.z), 0};
    const MapReaderJob job = value_of(reader_->bind({.map = maps.plan.maps()[index],
                                                     .view = maps.maps[index].view(),
                                                     .state = maps.state.handle(),
                                                     .directions = directions.handle(),
                                                     .results = results.handle(),
                                                     .count = std::uint32_t(axes.size())}));
    value_of(gpu().submit([&](VkCommandBuffer commands) { job.record(commands); }));
    std::vector<Average> values(axes.size());
    std::memcpy(values.data(), results.data(), values.size() * sizeof(Average));
    return values;
}

host::Image Bench::stored(const test::Prefiltered& maps, std::size_t index) {
    return value_of(gpu().download(maps.maps[index], VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
}

host::Image Bench::cube(const host::Image& panorama, std::uint32_t face) {
    if (!to_cube_) to_cube_.emplace(value_of(PanoramaToCube::create(gpu().device())));
    const host::GpuImage source = test::on_device(gpu(), panorama);
    const host::GpuImage target = value_of(
        gpu().create_image({.width = face,
                            .height = face,
                            .layers = 6,
                            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                     VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                            .cube = true}));
    const PanoramaToCubeJob job =
        value_of(to_cube_->bind(test::panorama_of(source), test::cube_of(target)));
    value_of(gpu().submit([&](VkCommandBuffer commands) { job.record(commands); }));
    return value_of(gpu().download(target, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));
}

host::Image EvenSphere::draw(const SphereView& view, float light) const {
    const host::GpuImage map = test::on_device(bench_.gpu(), even_cube(1, light, light, light));
    SphereView sized = view;
    sized.width = width_;
    sized.height = height_;
    return picture_.draw({.background = map.view(), .diffuse = map.view(), .specular = map.view()},
                         sized);
}

namespace {

std::optional<Bench> the_bench;

} // namespace

Bench& bench() {
    if (!the_bench) the_bench.emplace();
    return *the_bench;
}

void close_bench() {
    the_bench.reset();
}

std::vector<float> colours(const std::vector<Average>& averages) {
    std::vector<float> values;
    for (const Average& average : averages)
        values.insert(values.end(), average.begin(), average.begin() + 3);
    return values;
}

Directions axes(int count, std::uint64_t seed) {
    Directions rounded;
    for (const Direction& d : oracle::test_directions(count, seed))
        rounded.push_back({float(d.x), float(d.y), float(d.z)});
    return rounded;
}

std::string text(float value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

} // namespace lobelia::hard
