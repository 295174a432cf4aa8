#include "gallery_animation.h"

#include <cmath>
#include <numbers>

#include <lobelia/host/write.h>

#include "gallery_sheet.h"

namespace lobelia::cli {

using host::FrameLight;
using host::Image;
using host::Outcome;

namespace {

constexpr std::size_t FRAMES = 24;
constexpr std::uint32_t FRAME_SIZE = 512; // pixels
constexpr int HUNDREDTHS = 8;             // of a second, for which a frame is shown

/// From one environment to another, in equal brightness.
Image between(const GalleryLight& from, const GalleryLight& to, float share) {
    Image mixed = from.large;
    const float scale = std::exp2(to.exposure - from.exposure);
    for (std::size_t i = 0; i < mixed.texels.size(); ++i)
        mixed.texels[i] = (1.0f - share) * mixed.texels[i] + share * scale * to.large.texels[i];
    return mixed;
}

Outcome<GalleryAnimation> animate(host::Gpu& gpu, const std::string& folder,
                                  const std::string& name, const std::string& text, float exposure,
                                  const std::function<FrameLight(std::size_t)>& light) {
    std::vector<std::string> pictures;
    const auto times =
        host::draw_frames(gpu,
                          {.view = {.material = {{0.3f, 0.3f, 0.3f}, {0.6f, 0.6f, 0.6f}, 4.8f},
                                    .width = FRAME_SIZE,
                                    .height = FRAME_SIZE}},
                          FRAMES, light, [&](std::size_t frame, Image picture) -> Outcome<Done> {
                              pictures.push_back(folder + "/pictures/" + name + "-" +
                                                 std::to_string(frame + 1) + ".png");
                              for (std::size_t i = 3; i < picture.texels.size(); i += 4)
                                  picture.texels[i] = 1.0f;
                              return host::write_png(pictures.back(), picture, exposure);
                          });
    if (!times) return times.error();
    if (const auto written = write_animation(folder, name, pictures, HUNDREDTHS); !written)
        return written.error();
    return GalleryAnimation{name, text, *times};
}

} // namespace

Outcome<std::vector<GalleryAnimation>> gallery_animations(host::Gpu& gpu,
                                                          const std::vector<GalleryLight>& lights,
                                                          const std::string& folder,
                                                          ProgressLine& progress) {
    const GalleryLight& first = lights.front();
    progress.begin("figure 5, turning");
    auto turning =
        animate(gpu, folder, "figure5-turning", first.name + " turns", first.exposure,
                [&](std::size_t frame) {
                    return FrameLight{first.large, float(2.0 * std::numbers::pi * double(frame) /
                                                         double(FRAMES))};
                });
    if (!turning) return turning.error();

    progress.begin("figure 5, changing");
    auto changing = animate(
        gpu, folder, "figure5-changing",
        lights.size() > 1 ? "the environments change into one another" : "the light dims and turns",
        first.exposure, [&](std::size_t frame) {
            const double along = double(frame * lights.size()) / double(FRAMES);
            const auto from = std::size_t(along);
            const GalleryLight& next = lights[(from + 1) % lights.size()];
            Image mixed = between(lights[from], next, float(along - double(from)));
            const float scale = std::exp2(lights[from].exposure - first.exposure);
            for (float& value : mixed.texels) value *= scale;
            return FrameLight{std::move(mixed), 0.0f};
        });
    if (!changing) return changing.error();
    return std::vector<GalleryAnimation>{std::move(*turning), std::move(*changing)};
}

} // namespace lobelia::cli
