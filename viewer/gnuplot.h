#pragma once

#include <string>

#include <lobelia/host/outcome.h>

namespace lobelia::cli {

/// Whether the program gnuplot can be run.
bool has_gnuplot();

/// What gnuplot draws by a script, in the format that `terminal` sets up. Fails with the reason
/// that gnuplot gives.
host::Outcome<std::string> run_gnuplot(const std::string& terminal, const std::string& script);

} // namespace lobelia::cli
