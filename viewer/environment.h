#pragma once

#include <optional>
#include <string>

#include <lobelia/host/read.h>
#include <lobelia/host/work.h>

#include "progress.h"

namespace lobelia::cli {

/// Reads the environment map at `path`; says what is odd about it and how many texels had to be
/// replaced. Nothing where `path` is empty, which stands for the built-in environment.
host::Outcome<std::optional<host::Environment>> read_source(const std::string& path,
                                                            ProgressLine& progress);

/// Refuses a face size for environments that are cube maps already.
host::Outcome<Done> check_face(const std::optional<host::Environment>& source, std::uint32_t face);

/// Brings it to the device, or makes the built-in one there. `face` 0 is what `quality` needs.
host::Outcome<host::GpuEnvironment> upload_source(host::Gpu& gpu,
                                                  const std::optional<host::Environment>& source,
                                                  std::uint32_t face, Quality quality,
                                                  ProgressLine& progress);

} // namespace lobelia::cli
