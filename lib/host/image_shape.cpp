#include "host/image_shape.h"

namespace lobelia::host {

Outcome<Done> check_texels(const Image& image) {
    const std::uint64_t floats =
        std::uint64_t(image.width) * image.height * image.layers * std::uint64_t(4);
    if (floats == 0 || image.texels.size() != floats)
        return Failure{"cannot be written: the image's texels do not fit its size"};
    return Done{};
}

Outcome<Done> check_environment(const Image& image) {
    if (const Outcome<Done> fits = check_texels(image); !fits) return fits.error();
    if (image.layout == Layout::cube && (image.layers != 6 || image.width != image.height))
        return Failure{"cannot be written: a cube map has six square layers"};
    if (image.layout == Layout::latlong && image.layers != 1)
        return Failure{"cannot be written: a latitude-longitude map has one layer"};
    return Done{};
}

} // namespace lobelia::host
