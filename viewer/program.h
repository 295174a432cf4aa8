#pragma once

#include <string>
#include <vector>

#include <lobelia/host/outcome.h>

namespace lobelia::cli {

/// Whether the system has the program `name` and it runs.
bool has_program(const std::string& name);

/// Runs a program with its arguments and `input` on its standard input; gives what it wrote to its
/// standard output. Fails with what it wrote to standard error.
host::Outcome<std::string> run_program(const std::vector<std::string>& words,
                                       const std::string& input);

} // namespace lobelia::cli
