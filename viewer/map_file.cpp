#include "map_file.h"

#include "numbers.h"

namespace lobelia::cli {

using host::Failure;

namespace {

const char* format_name(FileKind kind) {
    return kind == FileKind::ktx2 ? "ktx2" : "exr";
}

bool holds_maps(std::optional<FileKind> kind) {
    return kind == FileKind::exr || kind == FileKind::ktx2;
}

} // namespace

Outcome<FileKind> parse_map_format(std::string_view text) {
    for (const FileKind kind : {FileKind::exr, FileKind::ktx2})
        if (text == format_name(kind)) return kind;
    return Failure{"\"" + std::string(text) + "\" is no format; there are exr and ktx2"};
}

Outcome<OutputFile> map_file(const std::string& path, std::optional<FileKind> format) {
    const std::optional<FileKind> ending = kind_of(path);
    if (!format && !holds_maps(ending))
        return Failure{"\"" + path + "\" ends in neither .exr nor .ktx2"};
    if (format && ending && *format != *ending)
        return Failure{"\"" + path + "\" has another format's ending than --format " +
                       format_name(*format) + ", leave --format out or end the name in ." +
                       format_name(*format)};
    return OutputFile{path, format ? *format : *ending};
}

Outcome<Done> write_maps(const OutputFile& file, const std::vector<host::Image>& maps,
                         const std::vector<float>& exponents, const host::Metadata& metadata) {
    if (file.kind == FileKind::ktx2) return host::write_ktx2(file.path, maps, metadata);
    std::vector<host::Part> parts;
    for (std::size_t i = 0; i < maps.size(); ++i)
        parts.push_back({maps.size() > 1 ? "n=" + number_text(exponents[i]) : "", &maps[i]});
    return host::write_exr(file.path, parts, host::Content::environment, metadata);
}

} // namespace lobelia::cli
