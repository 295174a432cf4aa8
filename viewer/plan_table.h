#pragma once

#include <string>

#include <lobelia/host/plan.h>

namespace lobelia::cli {

/// The passes with their bytes and times, and the images, as text in columns.
std::string plan_table(const host::WorkPlan& plan);

/// Why each effect is in or out.
std::string reasons_table(const host::WorkPlan& plan);

} // namespace lobelia::cli
