#include "gallery_sheet.h"

#include <lobelia/host/write.h>

#include "program.h"

namespace lobelia::cli {

using host::Outcome;

namespace {

constexpr std::uint32_t SHOWN = 128; // pixels of a picture in a sheet

// A per cent sign begins an escape of ImageMagick's, in labels as in file names.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char character : text)
        result += character == '%' ? std::string("%%") : std::string(1, character);
    return result;
}

Outcome<Done> run_to_file(const std::vector<std::string>& words, const std::string& path) {
    const auto bytes = run_program(words, "");
    if (!bytes) return bytes.error();
    return host::replace_file(path, std::as_bytes(std::span(*bytes)));
}

} // namespace

Outcome<Done> write_sheet(const std::string& folder, const GalleryFigure& figure) {
    std::vector<std::string> words{"montage",     "-background", "white", "-font",
                                   "DejaVu-Sans", "-pointsize",  "12"};
    for (std::size_t i = 0; i < figure.cells.size(); ++i) {
        const GalleryCell& cell = figure.cells[i];
        const std::string path =
            folder + "/pictures/" + figure.name + "-" + std::to_string(i + 1) + ".png";
        if (const auto written = host::write_png(path, cell.picture, cell.exposure); !written)
            return written.error();
        // Maps of few texels are shown as they are.
        const bool small = cell.picture.width < SHOWN;
        words.insert(words.end(), {"-label", escaped(cell.caption), "(", escaped(path), "-filter",
                                   small ? "point" : "Lanczos", "-resize",
                                   std::to_string(SHOWN) + "x" + std::to_string(SHOWN), ")"});
    }
    // What comes after the number would not fit above a few columns; the page says it.
    const std::string title = figure.title.substr(0, figure.title.find(':'));
    words.insert(words.end(), {"-tile", std::to_string(figure.columns) + "x", "-geometry", "+8+6",
                               "-title", escaped(title), "png:-"});
    return run_to_file(words, folder + "/" + figure.name + ".png");
}

Outcome<Done> write_animation(const std::string& folder, const std::string& name,
                              const std::vector<std::string>& pictures, int hundredths) {
    std::vector<std::string> words{"convert", "-delay", std::to_string(hundredths), "-loop", "0"};
    for (const std::string& path : pictures) words.push_back(escaped(path));
    words.insert(words.end(), {"-resize", "256x256", "-layers", "optimize", "gif:-"});
    return run_to_file(words, folder + "/" + name + ".gif");
}

} // namespace lobelia::cli
