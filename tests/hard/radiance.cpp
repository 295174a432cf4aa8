#include "files.h"

// C26 to C28: Radiance pictures.
namespace lobelia::hard {
namespace {

using host::Environment;
using test::TemporaryFolder;

std::string radiance(const std::string& resolution, const std::string& variables = "") {
    // Each texel another mantissa, in file order.
    std::string bytes = "#?RADIANCE\n" + variables + "\n" + resolution + "\n";
    for (int i = 0; i < 2 * 3; ++i) bytes += {char(10 + i), char(50 + i), char(90 + i), char(128)};
    return bytes;
}

void orientations(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const auto of = [&](const std::string& resolution) {
        test::write_bytes(folder / "a.hdr", radiance(resolution));
        return read(folder / "a.hdr").image;
    };
    // Of the picture's texel (x, y), the number in file order.
    const auto look = [&](const std::string& resolution, std::uint32_t width, std::uint32_t height,
                          auto number) {
        found.at(resolution);
        const host::Image image = of(resolution);
        found.holds(image.width == width && image.height == height, "size");
        for (std::uint32_t y = 0; y < height; ++y)
            for (std::uint32_t x = 0; x < width; ++x)
                found.holds(*image.texel(0, x, y) == float(10 + number(x, y)) / 256, "texel");
    };
    look("-Y 2 +X 3", 3, 2, [](auto x, auto y) { return y * 3 + x; });
    look("-Y 2 -X 3", 3, 2, [](auto x, auto y) { return y * 3 + 2 - x; });
    look("+Y 2 +X 3", 3, 2, [](auto x, auto y) { return (1 - y) * 3 + x; });
    look("+Y 2 -X 3", 3, 2, [](auto x, auto y) { return (1 - y) * 3 + 2 - x; });
    look("+X 3 -Y 2", 3, 2, [](auto x, auto y) { return x * 2 + y; });
    look("-X 3 -Y 2", 3, 2, [](auto x, auto y) { return (2 - x) * 2 + y; });
    look("+X 3 +Y 2", 3, 2, [](auto x, auto y) { return x * 2 + 1 - y; });
    look("-X 3 +Y 2", 3, 2, [](auto x, auto y) { return (2 - x) * 2 + 1 - y; });
    found.at("XYZE");
    test::write_bytes(folder / "a.hdr", radiance("-Y 2 +X 3", "FORMAT=32-bit_rle_xyze\n"));
    cheaply_refused(found, folder / "a.hdr", "XYZ");
}

void variables(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& lines) {
        test::write_bytes(folder / "a.hdr", radiance("-Y 2 +X 3", lines));
        return folder / "a.hdr";
    };
    const double plain = plain_mean(read(with("")).image);
    found.at("EXPOSURE, twice");
    found.near(plain_mean(read(with("EXPOSURE=4\nEXPOSURE=0.5\n")).image), plain / 2, 1e-6);
    for (const char* name : {"GAMMA", "COLORCORR", "PRIMARIES"}) {
        found.at(name);
        const Environment noted = read(with(std::string(name) + "=2.2\n"));
        found.near(plain_mean(noted.image), plain, 1e-6);
        found.holds(noted.notices.size() >= 1, "a notice says that it is ignored");
    }
    found.at("10000 lines");
    std::string many;
    for (int i = 0; i < 10000; ++i) many += "VIEW=-vp 0 0 0\n";
    found.near(plain_mean(read(with(many)).image), plain, 1e-6);
    for (const std::string& bad :
         {std::string("EXPOSURE=0\n"), std::string("EXPOSURE=nan\n"), std::string("EXPOSURE=-1\n"),
          std::string("A=") + std::string(5000, 'x') + "\n", std::string("FORMAT=png\n")}) {
        found.at(bad.substr(0, 20));
        cheaply_refused(found, with(bad));
    }
}

void broken_runs(Bench&, Findings& found) {
    const TemporaryFolder folder;
    const std::string head = "#?RADIANCE\n\n-Y 1 +X 16\n";
    const std::string line("\2\2\0\20", 4);
    for (const auto& [name, bytes] :
         {std::pair<const char*, std::string>{"a run of nothing", line + std::string("\0\1", 2)},
          {"a run past the line", line + std::string("\xff\1", 2)},
          {"literals past the line", line + std::string("\x11") + std::string(17, 'a')},
          {"a line of another length", std::string("\2\2\0\10", 4) + std::string(64, '\1')},
          {"a repeat at the beginning", std::string("\1\1\1\7", 4) + std::string(64, '\1')},
          {"cut in a line", line + std::string("\x90\1\x90\1", 4)},
          {"cut before the line", std::string()}}) {
        found.at(name);
        test::write_bytes(folder / "a.hdr", head + bytes);
        cheaply_refused(found, folder / "a.hdr", "truncated or damaged");
    }
}

} // namespace

Kind radiance_forms() {
    return {"Forms of Radiance pictures",
            {
                {"C26", "Radiance's eight orientations; XYZE", "each texel in its place; refused",
                 orientations},
                {"C27", "Radiance's variables, many, long, unusable", "applied, noted or refused",
                 variables},
                {"C28", "Radiance runs that are empty, too long, cut", "refused", broken_runs},
            }};
}

} // namespace lobelia::hard
