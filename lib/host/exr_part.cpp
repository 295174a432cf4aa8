#include "host/exr_part.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/exr_colour.h"

namespace lobelia::host {

namespace {

std::string size_text(const ExrWindow& window) {
    return std::to_string(window.width()) + " x " + std::to_string(window.height());
}

Outcome<Done> check_window(const char* name, const ExrWindow& window, const ReadLimits& limits) {
    if (window.width() < 1 || window.height() < 1)
        return Failure{std::string("has an empty ") + name + " window, export it again"};
    if (window.width() > limits.side || window.height() > limits.side ||
        std::uint64_t(window.width() * window.height()) > limits.texels)
        return Failure{std::string("has a ") + name + " window of " + size_text(window) +
                       ", above the limit of " + std::to_string(limits.side) + " a side and " +
                       std::to_string(limits.texels) + " texels, reduce it"};
    return Done{};
}

ExrWindow window_of(const exr_attr_box2i_t& box) {
    return {box.min.x, box.min.y, box.max.x, box.max.y};
}

// OpenEXR defines an environment map over its data window (ImfEnvmap.h); any other image is what
// its display window shows.
Outcome<Done> read_windows(const ExrCore& core, const ReadLimits& limits, ExrPart& part) {
    exr_attr_box2i_t data{};
    exr_attr_box2i_t display{};
    if (exr_get_data_window(core.context(), part.index, &data) != EXR_ERR_SUCCESS ||
        exr_get_display_window(core.context(), part.index, &display) != EXR_ERR_SUCCESS)
        return Failure{"has no data or display window" + core.reason() + ", export it again"};
    exr_envmap_t envmap = EXR_ENVMAP_LATLONG;
    const bool stated =
        exr_attr_get_envmap(core.context(), part.index, "envmap", &envmap) == EXR_ERR_SUCCESS;
    part.cube = stated && envmap == EXR_ENVMAP_CUBE;
    part.data = window_of(data);
    part.map = stated ? part.data : window_of(display);

    const Outcome<Done> data_fits = check_window("data", part.data, limits);
    if (!data_fits) return data_fits.error();
    const Outcome<Done> map_fits = check_window("display", part.map, limits);
    if (!map_fits) return map_fits.error();
    if (part.data.min_x > part.map.max_x || part.data.max_x < part.map.min_x ||
        part.data.min_y > part.map.max_y || part.data.max_y < part.map.min_y)
        return Failure{"has no texel inside its display window, move its data window there"};
    if (part.cube && part.map.height() != 6 * part.map.width())
        return Failure{"says that it is a cube map but is " + size_text(part.map) +
                       ", a cube map is six times as high as wide"};
    return Done{};
}

Outcome<Done> read_storage(const ExrCore& core, ExrPart& part) {
    exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
    if (exr_get_storage(core.context(), part.index, &storage) != EXR_ERR_SUCCESS ||
        exr_get_compression(core.context(), part.index, &part.compression) != EXR_ERR_SUCCESS)
        return Failure{"has an unreadable header" + core.reason() + ", export it again"};
    if (int(part.compression) >= int(EXR_COMPRESSION_LAST_TYPE))
        return Failure{"is compressed by the unknown method " +
                       std::to_string(int(part.compression)) + ", export it with ZIP"};
    part.tiled = storage == EXR_STORAGE_TILED;
    if (!part.tiled) return Done{};
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    exr_tile_level_mode_t levels{};
    exr_tile_round_mode_t rounding{};
    if (exr_get_tile_descriptor(core.context(), part.index, &width, &height, &levels, &rounding) !=
            EXR_ERR_SUCCESS ||
        width == 0 || height == 0)
        return Failure{"has unusable tiles" + core.reason() + ", export it again"};
    part.tile_width = width;
    part.tile_height = height;
    return Done{};
}

void note_shape(const ExrPart& part, std::vector<std::string>& notices) {
    if (!part.cube && part.map.width() != 2 * part.map.height())
        notices.push_back("is " + size_text(part.map) +
                          ", not twice as wide as high; it covers the whole sphere all the same");
}

// Values are never converted, only the file's claim about them is reported.
void note_chromaticities(const ExrCore& core, const ExrPart& part,
                         std::vector<std::string>& notices) {
    exr_attr_chromaticities_t stated{};
    if (exr_attr_get_chromaticities(core.context(), part.index, "chromaticities", &stated) !=
        EXR_ERR_SUCCESS)
        return;
    const std::array<float, 8> values{stated.red_x,  stated.red_y,  stated.green_x, stated.green_y,
                                      stated.blue_x, stated.blue_y, stated.white_x, stated.white_y};
    constexpr std::array<float, 8> REC_709{0.64f, 0.33f, 0.30f,   0.60f,
                                           0.15f, 0.06f, 0.3127f, 0.3290f};
    if (std::all_of(values.begin(), values.end(), [](float value) { return value == 0.0f; })) {
        notices.push_back("states no usable primaries; they are ignored");
        return;
    }
    constexpr float ROUNDING = 1e-3f; // files state three or four digits
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::abs(values[i] - REC_709[i]) <= ROUNDING) continue;
        notices.push_back("states other primaries than Rec. 709; the values are kept as they are");
        return;
    }
}

} // namespace

std::uint64_t ExrPart::bytes_per_texel() const {
    std::uint64_t bytes = 0;
    for (const ExrChannel& channel : channels) bytes += channel.type == EXR_PIXEL_HALF ? 2 : 4;
    return bytes;
}

Outcome<ExrPart> choose_exr_part(const ExrCore& core, const ReadLimits& limits,
                                 std::vector<std::string>& notices) {
    Outcome<ExrPart> part = choose_exr_colour(core, limits, notices);
    if (!part) return part;
    const Outcome<Done> windows = read_windows(core, limits, *part);
    if (!windows) return windows.error();
    const Outcome<Done> storage = read_storage(core, *part);
    if (!storage) return storage.error();
    note_shape(*part, notices);
    note_chromaticities(core, *part, notices);
    return part;
}

} // namespace lobelia::host
