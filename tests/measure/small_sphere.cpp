#include "small_sphere.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "support/environments.h"
#include "support/real_panoramas.h"

namespace lobelia::test {

namespace {

constexpr std::uint32_t SIZE = 20; // pixels a side

std::string file_name(const std::string& panorama, const Material& material) {
    char exponent[32];
    std::snprintf(exponent, sizeof exponent, "n%g", double(material.exponent));
    return panorama + "-" + (material.specular[0] > 0.0f ? exponent : "diffuse");
}

} // namespace

SphereView small_sphere(const std::string& panorama, const Material& material) {
    const auto known = std::find(REAL_PANORAMAS.begin(), REAL_PANORAMAS.end(), panorama);
    const auto sides = oracle::test_directions(int(REAL_PANORAMAS.size()) + 7, 11);
    const oracle::Direction side = sides[6 + std::size_t(known - REAL_PANORAMAS.begin())];
    return {.camera = {.eye = {float(4 * side.x), float(4 * side.y), float(4 * side.z)}},
            .material = material,
            .background = false,
            .width = SIZE,
            .height = SIZE};
}

std::vector<double> sphere_colours(const host::Image& picture) {
    std::vector<double> values;
    for (std::size_t i = 0; i < picture.texels.size(); i += 4)
        if (picture.texels[i + 3] == 1.0f)
            values.insert(values.end(), &picture.texels[i], &picture.texels[i + 3]);
    return values;
}

std::vector<double> kept_reference(const std::string& folder, const std::string& panorama,
                                   const Material& material,
                                   const std::function<std::vector<double>()>& make) {
    if (folder.empty()) return make();
    std::filesystem::create_directories(folder);
    const std::string path = folder + "/" + file_name(panorama, material);
    if (std::ifstream file(path, std::ios::binary); file) {
        std::vector<double> values(std::filesystem::file_size(path) / sizeof(double));
        file.read(reinterpret_cast<char*>(values.data()),
                  std::streamsize(values.size() * sizeof(double)));
        return values;
    }
    const std::vector<double> values = make();
    std::ofstream(path + ".part", std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data()),
               std::streamsize(values.size() * sizeof(double)));
    std::filesystem::rename(path + ".part", path);
    return values;
}

} // namespace lobelia::test
