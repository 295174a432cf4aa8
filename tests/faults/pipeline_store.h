#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include <vulkan/vulkan.h>

namespace lobelia::test {

/// Keeps pipelines after they are destroyed and gives them again to who makes the same: compiling
/// them takes longer than all else that a fault needs. Told apart by their shaders and constants.
class PipelineStore {
public:
    bool on = false;

    void shader_made(const VkShaderModuleCreateInfo& info, VkShaderModule module) {
        code_[module] = std::string(reinterpret_cast<const char*>(info.pCode), info.codeSize);
    }

    template <class Info, class Create>
    VkResult make(VkDevice device, const Info& info, VkPipeline& pipeline, Create create) {
        if (!on) return create();
        VkPipeline& kept = kept_[device][key(info)];
        if (kept) {
            pipeline = kept;
            return VK_SUCCESS;
        }
        const VkResult code = create();
        if (code == VK_SUCCESS) kept = pipeline;
        return code;
    }

    /// Whether the pipeline is to stay alive now that its maker destroys it.
    bool keeps(VkDevice device, VkPipeline pipeline) const;
    void device_dies(VkDevice device);

private:
    using Key = std::size_t;
    Key stage_key(const VkPipelineShaderStageCreateInfo& stage) const;
    Key key(const VkComputePipelineCreateInfo& info) const { return stage_key(info.stage); }
    Key key(const VkGraphicsPipelineCreateInfo& info) const {
        return 31 * stage_key(info.pStages[0]) + stage_key(info.pStages[1]);
    }

    std::map<VkShaderModule, std::string> code_;
    std::map<VkDevice, std::map<Key, VkPipeline>> kept_;
};

} // namespace lobelia::test
