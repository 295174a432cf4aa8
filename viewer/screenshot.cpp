#include "screenshot.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>

#include "command_line.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

/// Linear radiance as it is seen: side by side where it is split.
Outcome<host::Image> seen_radiance(Stage& stage, const ViewState& state) {
    auto left = stage.download(state, false);
    if (!left || !state.split) return left;
    const auto right = stage.download(state, true);
    if (!right) return right.error();
    const auto first = std::uint32_t(std::round(state.divider * float(left->width)));
    for (std::uint32_t y = 0; y < left->height; ++y)
        for (std::uint32_t x = first; x < left->width; ++x)
            std::copy_n(right->texel(0, x, y), 4, left->texel(0, x, y));
    return left;
}

/// As the window shows it, without panel: sRGB in [0, 1].
Outcome<host::Image> seen_colours(host::Gpu& gpu, Stage& stage, const ViewState& state,
                                  VkExtent2D extent) {
    const VkDevice device = gpu.device().handle;
    const auto pass = make_colour_pass(device, Picture::FORMAT, Picture::LAYOUT);
    if (!pass) return pass.error();
    auto display = Display::create(device, pass->get());
    if (!display) return display.error();
    const auto picture = Picture::create(gpu, pass->get(), extent);
    if (!picture) return picture.error();
    const auto bound = display->bind(stage.display_sources(state), stage.display_variant(state));
    if (!bound) return bound.error();
    const auto drawn = gpu.submit([&](VkCommandBuffer commands) {
        picture->record(commands, pass->get(), [&](VkCommandBuffer inside) {
            display->record(inside, stage.display_params(state, extent), extent);
        });
    });
    if (!drawn) return drawn.error();
    return picture->download(gpu);
}

/// In the current folder, of the time.
std::string new_file_name(const std::string& ending) {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char stamp[32];
    std::strftime(stamp, sizeof stamp, "lobelia-%Y%m%d-%H%M%S", &local);
    std::error_code ignored;
    std::string name = stamp + ending;
    for (int i = 2; std::filesystem::exists(name, ignored); ++i)
        name = std::string(stamp) + "-" + std::to_string(i) + ending;
    return name;
}

} // namespace

Outcome<std::string> save_screenshot(host::Gpu& gpu, Stage& stage, const ViewState& state,
                                     VkExtent2D extent, const std::string& ending) {
    const bool as_exr = ending == ".exr";
    const auto image =
        as_exr ? seen_radiance(stage, state) : seen_colours(gpu, stage, state, extent);
    if (!image) return image.error();
    std::string path = new_file_name(ending);
    const host::Metadata metadata = metadata_of(state, extent);
    const host::Part part{.image = &*image};
    const auto written = as_exr
                             ? host::write_exr(path, {&part, 1}, host::Content::picture, metadata)
                             : host::write_display_png(path, *image, metadata);
    if (!written) return written.error();
    return path;
}

} // namespace lobelia::cli
