#include "gallery_figures.h"

#include <map>

#include <lobelia/host/error_measures.h>

#include "numbers.h"

namespace lobelia::cli {

using host::Image;
using host::Outcome;

namespace {

constexpr std::uint32_t SIZE = 128;    // of a sphere's picture, pixels
constexpr std::uint32_t MAP_FACE = 32; // of figure 1's maps
constexpr float MAP_EXPONENT = 64.0f;  // of figure 1's maps
constexpr float PAPER_EXPONENT = 4.8f; // of figure 5
constexpr float DIFFUSE = 0.3f, SPECULAR = 0.6f;

std::string error_text(const std::vector<float>& values, const std::vector<float>& exact) {
    const double per_cent = 100.0 * host::measure_error(values, exact).rms;
    char text[48];
    std::snprintf(text, sizeof text, per_cent < 100.0 ? "error %.2g %%" : "error %.0f %%",
                  per_cent);
    return text;
}

std::vector<float> colours(const Image& image, bool covered_alone) {
    std::vector<float> values;
    for (std::size_t i = 0; i < image.texels.size(); i += 4)
        if (!covered_alone || image.texels[i + 3] == 1.0f)
            values.insert(values.end(), &image.texels[i], &image.texels[i] + 3);
    return values;
}

/// The face towards +Z.
Image front_face(const Image& cube) {
    const std::size_t count = std::size_t(4) * cube.width * cube.height;
    const auto begin = cube.texels.begin() + std::ptrdiff_t(4 * count);
    return {
        host::Layout::latlong, cube.width, cube.height, 1, {begin, begin + std::ptrdiff_t(count)}};
}

/// Blurred by "a standard averaging operation": every texel of a block counts the same.
Image averaged(const Image& cube, std::uint32_t size) {
    const std::uint32_t block = cube.width / size;
    Image result{host::Layout::cube, size, size, 6,
                 std::vector<float>(std::size_t(24) * size * size, 0.0f)};
    for (std::uint32_t face = 0; face < 6; ++face)
        for (std::uint32_t y = 0; y < block * size; ++y)
            for (std::uint32_t x = 0; x < block * size; ++x)
                for (std::size_t i = 0; i < 4; ++i)
                    result.texel(face, x / block, y / block)[i] +=
                        cube.texel(face, x, y)[i] / float(block * block);
    return result;
}

Outcome<GalleryFigure> environments(host::Gpu& gpu, const std::vector<GalleryLight>& lights,
                                    ProgressLine& progress) {
    GalleryFigure figure{.name = "figure1",
                         .title = "Figure 1: environments and their blurred versions",
                         .text = "One face of each cube map, towards +Z. From the top: the "
                                 "environment; averaged down to 64 texels a face as the paper "
                                 "does, its error against averages by solid angle; the light of a "
                                 "Phong lobe of n = 64 by the default prefilter; the same exactly. "
                                 "Errors over all six faces.",
                         .columns = lights.size()};
    std::vector<GalleryCell> rows[4];
    for (const GalleryLight& light : lights) {
        progress.begin("figure 1, " + light.name);
        const auto map = [&](host::PrefilterMethod method) {
            return host::prefilter(
                gpu, light.light,
                {.method = method, .exponents = {MAP_EXPONENT}, .width = MAP_FACE},
                progress.listener());
        };
        const auto chain = map(host::PrefilterMethod::chain);
        if (!chain) return chain.error();
        const auto exact = map(host::PrefilterMethod::exact);
        if (!exact) return exact.error();
        const Image blurred = averaged(light.large, GALLERY_FACE);
        const Image& smooth = chain->maps.front();
        rows[0].push_back({light.name, front_face(light.large), light.exposure});
        rows[1].push_back({"kurt2019's average\n" +
                               error_text(colours(blurred, false), colours(light.small, false)),
                           front_face(blurred), light.exposure});
        rows[2].push_back({"lobe n = 64, chain\n" + error_text(colours(smooth, false),
                                                               colours(exact->maps.front(), false)),
                           front_face(smooth), light.exposure});
        rows[3].push_back(
            {"lobe n = 64, exact\n ", front_face(exact->maps.front()), light.exposure});
    }
    for (const auto& row : rows) figure.cells.insert(figure.cells.end(), row.begin(), row.end());
    return figure;
}

/// Spheres in one light. Light adds up: the reference is integrated once for each lobe.
class Spheres {
public:
    Spheres(host::Gpu& gpu, const GalleryLight& light, ProgressLine& progress)
        : gpu_(gpu), light_(light), progress_(progress) {}

    Outcome<Image> draw(float diffuse, float specular, float exponent, SphereMethod method) {
        const auto rendering =
            host::render(gpu_, light_.light,
                         {.view = {.material = {.diffuse = {diffuse, diffuse, diffuse},
                                                .specular = {specular, specular, specular},
                                                .exponent = exponent},
                                   .background = false,
                                   .width = SIZE,
                                   .height = SIZE},
                          .method = method},
                         progress_.listener());
        if (!rendering) return rendering.error();
        return rendering->picture;
    }

    Outcome<Image> reference(float diffuse, float specular, float exponent) {
        const auto matte = lobe(1.0f, 0.0f, -1.0f, exponent);
        if (!matte) return matte.error();
        const auto gloss = lobe(0.0f, 1.0f, exponent, exponent);
        if (!gloss) return gloss.error();
        Image sum = **matte;
        for (std::size_t i = 0; i < sum.texels.size(); ++i)
            if (i % 4 != 3)
                sum.texels[i] = diffuse * sum.texels[i] + specular * (*gloss)->texels[i];
        return sum;
    }

    float exposure() const { return light_.exposure; }
    const std::string& name() const { return light_.name; }

private:
    host::Gpu& gpu_;
    const GalleryLight& light_;
    ProgressLine& progress_;
    std::map<float, Image> lobes_; // by exponent; -1 for the diffuse one

    Outcome<const Image*> lobe(float diffuse, float specular, float key, float exponent) {
        auto known = lobes_.find(key);
        if (known == lobes_.end()) {
            progress_.begin("reference in " + light_.name +
                            (key < 0.0f ? ", diffuse" : ", n = " + number_text(exponent)));
            auto made = draw(diffuse, specular, exponent, SphereMethod::reference);
            if (!made) return made.error();
            known = lobes_.emplace(key, std::move(*made)).first;
        }
        return &known->second;
    }
};

/// One material, three times: the default method, the paper's, the reference.
struct Looks {
    GalleryCell cells[3];
};

Outcome<Looks> looks(Spheres& spheres, float diffuse, float specular, float exponent,
                     const std::string& caption) {
    const auto exact = spheres.reference(diffuse, specular, exponent);
    if (!exact) return exact.error();
    Looks result;
    const SphereMethod usual = host::method_for(Quality::normal);
    for (const SphereMethod method : {usual, SphereMethod::kurt2019}) {
        auto picture = spheres.draw(diffuse, specular, exponent, method);
        if (!picture) return picture.error();
        const std::string name = method == usual ? "default" : "kurt2019";
        const std::string error = error_text(colours(*picture, true), colours(*exact, true));
        result.cells[method == usual ? 0 : 1] = {name + ", " + caption + "\n" + error,
                                                 std::move(*picture), spheres.exposure()};
    }
    result.cells[2] = {"reference, " + caption + "\n ", std::move(*exact), spheres.exposure()};
    return result;
}

/// What varies from column to column.
struct Variation {
    float diffuse, specular, exponent;
    std::string caption;
};

Outcome<GalleryFigure> variations(Spheres& spheres, GalleryFigure figure,
                                  const std::vector<Variation>& columns) {
    figure.columns = columns.size();
    std::vector<Looks> all;
    for (const Variation& one : columns) {
        auto made = looks(spheres, one.diffuse, one.specular, one.exponent, one.caption);
        if (!made) return made.error();
        all.push_back(std::move(*made));
    }
    for (const std::size_t row : {0u, 1u, 2u})
        for (const Looks& one : all) figure.cells.push_back(one.cells[row]);
    return figure;
}

std::string named(const char* name, float value) {
    return name + std::string(" = ") + number_text(value);
}

Outcome<GalleryFigure> lit_by(std::vector<Spheres>& spheres) {
    GalleryFigure figure{.name = "figure5",
                         .title = "Figure 5: environments changed, n = 4.8",
                         .text = "kd 0.3, ks 0.6.",
                         .columns = 3};
    for (Spheres& one : spheres) {
        auto made = looks(one, DIFFUSE, SPECULAR, PAPER_EXPONENT, one.name());
        if (!made) return made.error();
        for (GalleryCell& cell : made->cells) figure.cells.push_back(std::move(cell));
    }
    return figure;
}

} // namespace

Outcome<std::vector<GalleryFigure>>
gallery_figures(host::Gpu& gpu, const std::vector<GalleryLight>& lights, ProgressLine& progress) {
    std::vector<Spheres> spheres;
    for (const GalleryLight& light : lights) spheres.emplace_back(gpu, light, progress);
    // The paper's own figures 2 to 4 are in the second of its environments.
    Spheres& one = spheres[spheres.size() / 2];

    std::vector<Variation> diffuse, specular, exponents;
    for (const float value : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f}) {
        diffuse.push_back({value, 0.2f, MAP_EXPONENT, named("kd", value)});
        specular.push_back({0.2f, value, MAP_EXPONENT, named("ks", value)});
    }
    for (const float value : {1.0f, PAPER_EXPONENT, 16.0f, 64.0f, 256.0f})
        exponents.push_back({DIFFUSE, SPECULAR, value, named("n", value)});
    const std::string rows = " From the top: the default method, the paper's, the reference.";

    std::vector<GalleryFigure> figures;
    for (const auto& make : std::vector<std::function<Outcome<GalleryFigure>()>>{
             [&] { return environments(gpu, lights, progress); },
             [&] {
                 return variations(one,
                                   {.name = "figure2",
                                    .title = "Figure 2: the diffuse reflectance kd varied",
                                    .text = "ks 0.2, n = 64, in " + one.name() + "." + rows},
                                   diffuse);
             },
             [&] {
                 return variations(one,
                                   {.name = "figure3",
                                    .title = "Figure 3: the specular reflectance ks varied",
                                    .text = "kd 0.2, n = 64, in " + one.name() + "." + rows},
                                   specular);
             },
             [&] {
                 return variations(one,
                                   {.name = "figure4",
                                    .title = "Figure 4: the exponent n varied",
                                    .text = "kd 0.3, ks 0.6, in " + one.name() + "." + rows},
                                   exponents);
             },
             [&] { return lit_by(spheres); }}) {
        auto figure = make();
        if (!figure) return figure.error();
        figures.push_back(std::move(*figure));
    }
    return figures;
}

} // namespace lobelia::cli
