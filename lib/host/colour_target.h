#pragma once

#include <functional>
#include <memory>

#include <lobelia/host/gpu.h>

namespace lobelia::host {

/// A picture that a render pass with one subpass draws into, R32G32B32A32_SFLOAT.
class ColourTarget {
public:
    static Outcome<ColourTarget> create(Gpu& gpu, std::uint32_t width, std::uint32_t height);
    ColourTarget(ColourTarget&&) noexcept;
    ColourTarget& operator=(ColourTarget&&) noexcept;
    ~ColourTarget();

    VkRenderPass render_pass() const;
    const GpuImage& image() const;

    /// Records the render pass around `draw`, which must write every pixel. Leaves the image in
    /// TRANSFER_SRC_OPTIMAL, ready for Gpu::download.
    void record(VkCommandBuffer commands, const std::function<void(VkCommandBuffer)>& draw) const;

private:
    struct State;
    explicit ColourTarget(std::unique_ptr<State> state) noexcept;
    std::unique_ptr<State> state_;
};

} // namespace lobelia::host
