#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <lobelia/host/plan.h>
#include <lobelia/host/read.h>

namespace lobelia::cli {

/// Adds --tolerance, for verbs that plan before they work.
void add_tolerance(CLI::App& verb, std::optional<double>& tolerance);

/// Two digits, or "not promised" where it is infinite.
std::string error_text(double error);

/// What `host::plan_render` and `plan_prefilter` take: that of the file, or the built-in one's.
host::EnvironmentShape shape_of(const std::optional<host::Environment>& source);

/// Changes method and quality to the cheapest whose expected error meets `tolerance`, if there is
/// one, and says which and why. Refuses what none can promise, naming the least that one can.
host::Outcome<Done> meet(std::optional<double> tolerance, const host::Gpu& gpu,
                         const host::EnvironmentShape& environment, host::RenderSettings& settings);
host::Outcome<Done> meet(std::optional<double> tolerance, const host::Gpu& gpu,
                         const host::EnvironmentShape& environment,
                         host::PrefilterSettings& settings);

} // namespace lobelia::cli
