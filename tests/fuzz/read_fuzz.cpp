#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

#include <lobelia/host/read.h>

// Environment maps of any bytes: refused, or radiance.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const int file = ::memfd_create("fuzz", MFD_CLOEXEC);
    static const std::string path = "/proc/self/fd/" + std::to_string(file);
    if (::ftruncate(file, off_t(size)) != 0 || ::pwrite(file, bytes, size, 0) != ssize_t(size))
        std::abort();
    const auto read = lobelia::host::read_environment(
        path, {.texels = 1 << 14, .decoder_bytes = std::uint64_t(4) << 20});
    if (!read) return 0;
    const lobelia::host::Image& image = read->image;
    if (image.texels.size() != std::size_t(4) * image.width * image.height * image.layers)
        std::abort();
    for (const float value : image.texels)
        if (!(std::isfinite(value) && value >= 0.0f)) std::abort();
    return 0;
}
