#pragma once

#include "prefilter_plan.h"
#include "vk/compute_pass.h"

namespace lobelia {

/// The workgroups of a pass.
vk::Groups groups_of(const PrefilterPlan::State& plan, const PlannedPass& planned);

} // namespace lobelia
