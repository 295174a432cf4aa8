// Writes a portable float map, as the engines of tests/examples draw them, for people to look at:
// float_map_png FILE.pfm FILE.png [EV]. docs/knot.png is of such a map.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <lobelia/host/write.h>

int main(int count, char** arguments) {
    if (count < 3) {
        std::fputs("float_map_png FILE.pfm FILE.png [EV]\n", stderr);
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    std::string format;
    std::uint32_t width = 0, height = 0;
    float endian = 0;
    file >> format >> width >> height >> endian;
    file.get();
    if (!file || format != "PF" || endian != -1 || width > 16384 || height > 16384) {
        std::fprintf(stderr, "%s is no little-endian float map of three channels\n", arguments[1]);
        return 1;
    }
    lobelia::host::Image picture{.width = width,
                                 .height = height,
                                 .texels = std::vector<float>(std::size_t(4) * width * height, 1)};
    for (std::uint32_t y = height; y-- > 0;) // from the lowest row up
        for (std::uint32_t x = 0; x < width; ++x)
            file.read(reinterpret_cast<char*>(picture.texel(0, x, y)), 3 * sizeof(float));
    const float exposure = count > 3 ? float(std::atof(arguments[3])) : 0;
    const auto written = lobelia::host::write_png(arguments[2], picture, exposure);
    if (!file || !written) {
        std::fprintf(stderr, "%s\n",
                     written ? "the map ends early" : written.error().message.c_str());
        return 1;
    }
}
