#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <lobelia/host/gpu.h>

namespace lobelia::cli {

/// Which device works, and what is told about it.
struct GpuChoice {
    std::string device; // index or part of the name; empty: the best there is
    bool verbose = false;
};

/// Adds --device and --verbose, which write to `choice`.
void add_gpu_options(CLI::App& verb, GpuChoice& choice);

/// Starts the chosen device, where asked for with a window to present to; with --verbose says which
/// one and why.
host::Outcome<host::Gpu>
start_gpu(const GpuChoice& choice,
          const std::optional<host::Presentation>& presentation = std::nullopt);

} // namespace lobelia::cli
