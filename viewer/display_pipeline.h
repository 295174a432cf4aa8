#pragma once

#include "display.h"

namespace lobelia::cli {

/// Compiles display.frag for one variant.
host::Outcome<OwnedPipeline> make_display_pipeline(VkDevice device, VkRenderPass pass,
                                                   VkPipelineLayout layout,
                                                   const DisplayVariant& variant);

} // namespace lobelia::cli
