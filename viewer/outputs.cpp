#include "outputs.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <unistd.h>

#include "interrupts.h"

namespace lobelia::cli {

namespace fs = std::filesystem;
using host::Failure;
using host::Outcome;

namespace {

std::string small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return char(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return text;
}

Outcome<Done> check_output(const std::string& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        return Failure{path + ": is a folder, give a file name in it"};
    if (fs::exists(path, ignored)) return Done{}; // may be replaced, or written to as a device
    const fs::path folder = fs::path(path).parent_path();
    const std::string place = folder.empty() ? "." : folder.string();
    if (::access(place.c_str(), W_OK | X_OK) == 0) return Done{};
    return Failure{path + ": cannot be created (" + std::generic_category().message(errno) +
                   "), choose a folder that is there and may be written to"};
}

} // namespace

std::optional<FileKind> kind_of(std::string_view path) {
    const std::string name = small_letters(std::string(path));
    if (name.ends_with(".exr")) return FileKind::exr;
    if (name.ends_with(".png")) return FileKind::png;
    if (name.ends_with(".ktx2")) return FileKind::ktx2;
    return std::nullopt;
}

Outcome<OutputFile> parse_output(std::string_view path) {
    const std::optional<FileKind> kind = kind_of(path);
    if (kind && *kind != FileKind::ktx2) return OutputFile{std::string(path), *kind};
    return Failure{"\"" + std::string(path) + "\" ends in neither .exr nor .png"};
}

Outcome<Done> check_outputs(const std::vector<OutputFile>& outputs) {
    for (const OutputFile& output : outputs)
        if (const Outcome<Done> checked = check_output(output.path); !checked)
            return checked.error();
    return Done{};
}

Outcome<Done> write_outputs(const std::vector<OutputFile>& outputs,
                            const std::function<Outcome<Done>(const OutputFile&)>& write) {
    const DeferredInterrupts whole_files_only;
    std::vector<std::string> created;
    for (const OutputFile& output : outputs) {
        std::error_code ignored;
        const bool is_new = !fs::exists(output.path, ignored);
        if (const Outcome<Done> written = write(output); !written) {
            for (const std::string& path : created) fs::remove(path, ignored);
            return written.error();
        }
        if (is_new) created.push_back(output.path);
    }
    return Done{};
}

} // namespace lobelia::cli
