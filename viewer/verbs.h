#pragma once

#include <CLI/CLI.hpp>

namespace lobelia::cli {

/// Each adds a verb to `program`. When the verb is given, parsing runs it and its exit status comes
/// to lie in `status`, which must outlive the parsing.
void add_render(CLI::App& program, int& status);
void add_prefilter(CLI::App& program, int& status);
void add_view(CLI::App& program, int& status);
void add_plan(CLI::App& program, int& status);
void add_measure(CLI::App& program, int& status);
void add_gallery(CLI::App& program, int& status);
void add_devices(CLI::App& program, int& status);

} // namespace lobelia::cli
