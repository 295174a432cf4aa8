#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <lobelia/host/outcome.h>

namespace lobelia::host {

/// Makes `bytes` the content of the file at `path` in one step: they are written to a file beside
/// it
/// (`.lobelia-<process>-<number>.tmp`), brought to the disk and read back, and that file takes the
/// name. On failure the file at `path` is as it was and nothing else is left. A new file has the
/// permissions of any new file, a replaced one keeps its own.
///
/// A symbolic link stays and the file that it points to is replaced. A device or pipe is written
/// straight into. A folder is refused. The message of a failure names `path`.
Outcome<Done> replace_file(const std::string& path, std::span<const std::byte> bytes);

} // namespace lobelia::host
