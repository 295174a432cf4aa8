#pragma once

#include <memory>

#include <lobelia/host/work.h>

namespace lobelia::host {

/// upload_environment() a part at a time, for programs that draw meanwhile.
class EnvironmentUpload {
public:
    /// Makes the images; nothing runs yet. `gpu` and `image` outlive this. Refuses what
    /// upload_environment() refuses.
    static Outcome<EnvironmentUpload> begin(Gpu& gpu, const Image& image, std::uint32_t face = 0,
                                            Quality quality = Quality::normal);
    EnvironmentUpload(EnvironmentUpload&&) noexcept;
    EnvironmentUpload& operator=(EnvironmentUpload&&) noexcept;
    ~EnvironmentUpload();

    double done() const; // in [0, 1]
    /// Runs a part and waits for it: of a quarter of a million texels at most, some hundredths of a
    /// second on two CPU cores.
    Outcome<Done> go_on();
    /// The environment, once, when all is done.
    GpuEnvironment take();

private:
    struct State;
    explicit EnvironmentUpload(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace lobelia::host
