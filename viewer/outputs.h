#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <lobelia/host/outcome.h>

namespace lobelia::cli {

enum class FileKind { exr, png, ktx2 };

/// A file to write, and as what.
struct OutputFile {
    std::string path;
    FileKind kind = FileKind::exr;
};

/// Tells the kind by the ending, in capitals or not; nothing where it is none that is known.
std::optional<FileKind> kind_of(std::string_view path);

/// A picture to write, .exr or .png.
host::Outcome<OutputFile> parse_output(std::string_view path);

/// Why writing to `outputs` cannot succeed, as far as can be known before the work.
host::Outcome<Done> check_outputs(const std::vector<OutputFile>& outputs);

/// Calls `write` on each. When one fails, those that were not there before are removed again.
host::Outcome<Done>
write_outputs(const std::vector<OutputFile>& outputs,
              const std::function<host::Outcome<Done>(const OutputFile&)>& write);

} // namespace lobelia::cli
