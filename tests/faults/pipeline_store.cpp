#include "pipeline_store.h"

#include <algorithm>

namespace lobelia::test {

PipelineStore::Key PipelineStore::stage_key(const VkPipelineShaderStageCreateInfo& stage) const {
    std::string content = code_.at(stage.module);
    if (const VkSpecializationInfo* const constants = stage.pSpecializationInfo)
        content.append(static_cast<const char*>(constants->pData), constants->dataSize);
    return std::hash<std::string>()(content);
}

bool PipelineStore::keeps(VkDevice device, VkPipeline pipeline) const {
    const auto kept = kept_.find(device);
    return kept != kept_.end() &&
           std::any_of(kept->second.begin(), kept->second.end(),
                       [&](const auto& one) { return one.second == pipeline; });
}

void PipelineStore::device_dies(VkDevice device) {
    for (const auto& [key, pipeline] : kept_[device])
        ::vkDestroyPipeline(device, pipeline, nullptr);
    kept_.erase(device);
}

} // namespace lobelia::test
