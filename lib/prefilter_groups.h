#pragma once

#include "prefilter_plan.h"
#include "vk/compute_pass.h"

namespace lobelia {

/// The workgroups of a pass. A piece of it is one row of them, or one group where there is one row.
struct Groups {
    std::uint32_t x, y, z;

    std::uint32_t pieces() const { return y * z > 1 ? y * z : x; }
};
Groups groups_of(const PrefilterPlan::State& plan, const PlannedPass& planned);

/// Dispatches pieces [first, first + count) of the bound pass.
void dispatch_pieces(const vk::Context& context, VkCommandBuffer commands, const Groups& groups,
                     std::uint32_t first, std::uint32_t count);

} // namespace lobelia
