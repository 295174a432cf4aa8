#include "judged.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "support/error_measures.h"
#include "support/real_panoramas.h"

namespace lobelia::test {
namespace {

constexpr int DIRECTIONS = 150;
constexpr std::uint32_t SIZE = 20; // of the sphere's picture, pixels
constexpr float DIFFUSE = -1;      // stands for the diffuse sphere among exponents

/// From where measure_sphere sees the panorama, whose references are the same.
oracle::Direction side_of(const std::string& panorama) {
    const auto known = std::find(REAL_PANORAMAS.begin(), REAL_PANORAMAS.end(), panorama);
    const auto sides = oracle::test_directions(int(REAL_PANORAMAS.size()) + 7, 11);
    return sides[6 + std::size_t(known - REAL_PANORAMAS.begin())];
}

std::string kept_name(const std::string& panorama, std::optional<float> exponent) {
    if (!exponent) return panorama + "-diffuse";
    char text[32];
    std::snprintf(text, sizeof text, "-n%g", double(*exponent));
    return panorama + text;
}

std::vector<double> read_kept(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    std::vector<double> values(std::filesystem::file_size(path) / sizeof(double));
    file.read(reinterpret_cast<char*>(values.data()),
              std::streamsize(values.size() * sizeof(double)));
    return values;
}

void keep(const std::string& path, const std::vector<double>& values) {
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path + ".part", std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()),
               std::streamsize(values.size() * sizeof(double)));
    std::filesystem::rename(path + ".part", path);
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
    const oracle::Direction side = side_of(name_);
    Material material{.exponent = exponent.value_or(1.0f)};
    (exponent ? material.specular : material.diffuse) = {1, 1, 1};
    const auto picture =
        value_of(host::render(gpu_, upload(quality),
                              {.view = {.camera = {.eye = {float(4 * side.x), float(4 * side.y),
                                                           float(4 * side.z)}},
                                        .material = material,
                                        .background = false,
                                        .width = SIZE,
                                        .height = SIZE},
                               .method = method,
                               .quality = quality}))
            .picture;
    std::vector<double> values;
    for (std::size_t i = 0; i < picture.texels.size(); i += 4)
        if (picture.texels[i + 3] == 1.0f)
            values.insert(values.end(), &picture.texels[i], &picture.texels[i + 3]);
    return values;
}

const std::vector<double>& Judged::sphere_truth(std::optional<float> exponent) {
    const float key = exponent.value_or(DIFFUSE);
    for (const auto& known : sphere_truths_)
        if (known.first == key) return known.second;
    const std::string path = references_ + "/" + kept_name(name_, exponent);
    std::vector<double> colours;
    if (!references_.empty()) colours = read_kept(path);
    if (colours.empty()) {
        colours = sphere_colours(SphereMethod::reference, Quality::normal, exponent);
        if (!references_.empty()) keep(path, colours);
    }
    sphere_truths_.emplace_back(key, std::move(colours));
    return sphere_truths_.back().second;
}

double Judged::sphere_error(SphereMethod method, Quality quality, std::optional<float> exponent) {
    const std::vector<double> truth = sphere_truth(exponent);
    return oracle::measure_error(sphere_colours(method, quality, exponent), truth).pointwise_rms;
}

} // namespace lobelia::test
