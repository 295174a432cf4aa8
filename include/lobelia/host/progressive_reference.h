#pragma once

#include <cstdint>
#include <memory>

#include <lobelia/host/work.h>

namespace lobelia::host {

/// The averages that SphereMethod::reference shows, for a picture that a person looks at meanwhile:
/// pixels COARSEST apart first, then those between, until every pixel that the sphere may cover has
/// its own.
class ProgressiveReference {
public:
    static constexpr std::uint32_t COARSEST = 16; // pixels, a power of two

    /// For this view, at the exponent of its material; a lobe whose reflectance is black is left
    /// out. `gpu` and `environment` outlive this. Takes two buffers of 16 bytes and one of 4 a
    /// pixel, and about 0.1 microseconds a pixel.
    static Outcome<ProgressiveReference> create(Gpu& gpu, const GpuEnvironment& environment,
                                                const SphereView& view);
    ProgressiveReference(ProgressiveReference&&) noexcept;
    ProgressiveReference& operator=(ProgressiveReference&&) noexcept;
    ~ProgressiveReference();

    /// Goes on for about that long, at least by one dispatch; waits for the device.
    Outcome<Done> advance(double milliseconds);
    /// The fraction of the pixels that is there, 1 when all are.
    double done() const;
    /// Sees to this pixel before all others, at once. Does nothing where the sphere is not.
    Outcome<Done> integrate(std::uint32_t x, std::uint32_t y);

    /// As SphereSources takes them; null for a lobe that is left out. 0 where not known.
    VkBuffer diffuse() const;
    VkBuffer specular() const;
    /// A 32-bit word a pixel, row by row: 1 where the averages are there, else 0. Storage buffer.
    VkBuffer known() const;
    bool is_known(std::uint32_t x, std::uint32_t y) const;
    /// The mean of the averages that are there: what errors of black may be held against.
    double mean_light() const;

private:
    struct State;
    explicit ProgressiveReference(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace lobelia::host
