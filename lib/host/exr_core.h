#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <OpenEXR/openexr.h>

#include <lobelia/host/read.h>

#include "host/input_file.h"

namespace lobelia::host {

/// What OpenEXRCore may still allocate. Bytes count what it holds, blocks how often it asks, which
/// bounds the time that its sorted lists take.
struct ExrBudget {
    std::uint64_t bytes = 0;
    std::uint64_t blocks = 0;
};

/// An OpenEXR file open in OpenEXRCore. All its limits, its memory and its reads belong to this
/// object, none to the process. Use it from the thread that made it: Core's allocation callback is
/// told no context, so the budget in force is the thread's.
class ExrCore {
public:
    ExrCore(const InputFile& file, const ReadLimits& limits);
    ~ExrCore();
    ExrCore(const ExrCore&) = delete;
    ExrCore& operator=(const ExrCore&) = delete;

    /// Parses every part's header, within a small fixed budget and the first bytes of the file.
    Outcome<Done> open();

    /// What decoding may allocate, once the header is known to be worth it.
    void allow(std::uint64_t bytes) { budget_ = {bytes, UINT64_MAX}; }

    exr_context_t context() const { return context_; }
    std::uint64_t file_bytes() const { return file_.size(); }

    /// Core's account of what went wrong last, as " (account)", or nothing.
    std::string reason() const;

private:
    static std::int64_t read(exr_const_context_t, void* self, void* into, std::uint64_t bytes,
                             std::uint64_t offset, exr_stream_error_func_ptr_t);
    static std::int64_t size(exr_const_context_t, void* self);
    static void remember(exr_const_context_t context, exr_result_t, const char* message);

    const InputFile& file_;
    const ReadLimits& limits_;
    ExrBudget budget_;
    ExrBudget* outer_budget_;
    std::uint64_t readable_;
    bool header_too_long_ = false;
    bool unknown_compression_ = false;
    std::string message_;
    exr_context_t context_ = nullptr;
};

} // namespace lobelia::host
