#include "judged.h"

#include <algorithm>

#include "small_sphere.h"
#include "support/error_measures.h"

namespace lobelia::test {
namespace {

constexpr int DIRECTIONS = 150;
constexpr float DIFFUSE = -1; // stands for the diffuse sphere among exponents

Material white(std::optional<float> exponent) {
    Material material{.exponent = exponent.value_or(1.0f)};
    (exponent ? material.specular : material.diffuse) = {1, 1, 1};
    return material;
}

} // namespace

Judged::Judged(host::Gpu& gpu, std::string name, host::Image panorama, std::string references)
    : gpu_(gpu), name_(std::move(name)), panorama_(std::move(panorama)),
      references_(std::move(references)), exact_(value_of(Exact::create(gpu.device()))),
      prefilter_(value_of(Prefilter::create(gpu.device()))),
      reader_(value_of(MapReader::create(gpu.device()))) {}

std::uint32_t Judged::face(Quality quality) const {
    return host::default_face(panorama_.width, quality);
}

std::vector<double> Judged::map_errors(Quality quality, std::span<const float> exponents) {
    static const Directions directions = oracle::test_directions(DIRECTIONS, 7);
    const Environment environment = load(gpu_, panorama_, face(quality));
    const Maps maps = bind_maps(gpu_, prefilter_, environment.cube, exponents, true, quality);
    value_of(gpu_.submit(
        [&](VkCommandBuffer commands) { maps.job.record(commands, 0, maps.plan.pass_count()); }));
    std::vector<double> errors;
    for (std::size_t i = 0; i < maps.plan.maps().size(); ++i) {
        const float exponent = maps.plan.maps()[i].exponent;
        auto known = std::find_if(map_truths_.begin(), map_truths_.end(),
                                  [&](const auto& truth) { return truth.first == exponent; });
        if (known == map_truths_.end())
            known = map_truths_.insert(
                known, {exponent, truth(gpu_, exact_, environment.lent, exponent, directions)});
        errors.push_back(
            oracle::measure_error(read(gpu_, reader_, maps, i, directions), known->second)
                .pointwise_rms);
    }
    return errors;
}

const host::GpuEnvironment& Judged::upload(Quality quality) {
    for (const auto& known : uploads_)
        if (known.first == quality) return known.second;
    uploads_.emplace_back(quality, value_of(host::upload_environment(gpu_, panorama_, 0, quality)));
    return uploads_.back().second;
}

std::vector<double> Judged::sphere_colours(SphereMethod method, Quality quality,
                                           std::optional<float> exponent) {
    const host::RenderSettings settings{
        .view = small_sphere(name_, white(exponent)), .method = method, .quality = quality};
    return test::sphere_colours(value_of(host::render(gpu_, upload(quality), settings)).picture);
}

const std::vector<double>& Judged::sphere_truth(std::optional<float> exponent) {
    const float key = exponent.value_or(DIFFUSE);
    for (const auto& known : sphere_truths_)
        if (known.first == key) return known.second;
    sphere_truths_.emplace_back(key, kept_reference(references_, name_, white(exponent), [&] {
                                    return sphere_colours(SphereMethod::reference, Quality::normal,
                                                          exponent);
                                }));
    return sphere_truths_.back().second;
}

double Judged::sphere_error(SphereMethod method, Quality quality, std::optional<float> exponent) {
    const std::vector<double> truth = sphere_truth(exponent);
    return oracle::measure_error(sphere_colours(method, quality, exponent), truth).pointwise_rms;
}

} // namespace lobelia::test
