#include "host/exr_core.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "host/message.h"

namespace lobelia::host {

namespace {

// A header within its limit needs less: Core keeps each attribute once, in a block of its own.
constexpr std::uint64_t HEADER_BLOCKS = 8192;
constexpr std::uint64_t HEADER_COPIES = 4;
constexpr std::uint64_t HEADER_BASE_BYTES = std::uint64_t(1) << 20;

thread_local ExrBudget* budget_in_force = nullptr;

// In front of each block: free() is told no size and no context.
struct alignas(std::max_align_t) BlockHead {
    ExrBudget* budget;
    std::size_t bytes;
};

void* allocate(std::size_t bytes) {
    ExrBudget* budget = budget_in_force;
    if (!budget || budget->blocks == 0 || bytes > budget->bytes ||
        bytes > std::numeric_limits<std::size_t>::max() - sizeof(BlockHead))
        return nullptr;
    // Zeroed, so that a decoder that stops short can show nothing of what lay there before.
    auto* head = static_cast<BlockHead*>(std::calloc(1, sizeof(BlockHead) + bytes));
    if (!head) return nullptr;
    *head = {budget, bytes};
    budget->bytes -= bytes;
    --budget->blocks;
    return head + 1;
}

void release(void* block) {
    if (!block) return;
    BlockHead* head = static_cast<BlockHead*>(block) - 1;
    head->budget->bytes += head->bytes;
    std::free(head);
}

} // namespace

ExrCore::ExrCore(const InputFile& file, const ReadLimits& limits)
    : file_(file),
      limits_(limits), budget_{HEADER_BASE_BYTES + HEADER_COPIES * limits.attribute_bytes,
                               HEADER_BLOCKS},
      outer_budget_(budget_in_force),
      readable_(std::min<std::uint64_t>(file.size(), limits.attribute_bytes)) {
    budget_in_force = &budget_;
}

ExrCore::~ExrCore() {
    exr_finish(&context_);
    budget_in_force = outer_budget_;
}

Outcome<Done> ExrCore::open() {
    const int side =
        int(std::min<std::uint32_t>(limits_.side, std::numeric_limits<int>::max() / 2));
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    initializer.error_handler_fn = &ExrCore::remember;
    initializer.alloc_fn = &allocate;
    initializer.free_fn = &release;
    initializer.user_data = this;
    initializer.read_fn = &ExrCore::read;
    initializer.size_fn = &ExrCore::size;
    initializer.max_image_width = initializer.max_image_height = side;
    initializer.max_tile_width = initializer.max_tile_height = side;
    initializer.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    const exr_result_t code = exr_start_read(&context_, "image", &initializer);
    if (code != EXR_ERR_SUCCESS && header_too_long_)
        return Failure{"has headers of more than " + std::to_string(limits_.attribute_bytes) +
                       " bytes, remove attributes that are not needed"};
    if (unknown_compression_)
        return Failure{"is compressed by a method that this OpenEXR does not know" + reason() +
                       ", export it with ZIP"};
    if (code == EXR_ERR_OUT_OF_MEMORY)
        return Failure{"has headers of unreasonable cost" + reason() + ", export it again"};
    if (code != EXR_ERR_SUCCESS)
        return Failure{"has a damaged, truncated or too large OpenEXR header" + reason() +
                       ", export it again"};
    readable_ = file_.size();
    message_.clear();
    return Done{};
}

std::string ExrCore::reason() const {
    return message_.empty() ? "" : " (" + printable(message_) + ")";
}

// Until the header is accepted nothing beyond its limit is read, whatever sizes it states.
std::int64_t ExrCore::read(exr_const_context_t, void* self, void* into, std::uint64_t bytes,
                           std::uint64_t offset, exr_stream_error_func_ptr_t) {
    auto& core = *static_cast<ExrCore*>(self);
    const std::uint64_t left = offset < core.readable_ ? core.readable_ - offset : 0;
    if (bytes > left && core.readable_ < core.file_.size()) core.header_too_long_ = true;
    const auto count = std::size_t(std::min(bytes, left));
    return core.file_.read_at(offset, {static_cast<std::byte*>(into), count});
}

std::int64_t ExrCore::size(exr_const_context_t, void* self) {
    return std::int64_t(static_cast<ExrCore*>(self)->file_.size());
}

void ExrCore::remember(exr_const_context_t context, exr_result_t, const char* message) {
    void* self = nullptr;
    if (!context || exr_get_user_data(context, &self) != EXR_ERR_SUCCESS || !self) return;
    auto& core = *static_cast<ExrCore*>(self);
    core.message_ = message;
    // Core 3.1 says so, takes the method for ZIP and goes on.
    if (core.message_.find("'compression'") != std::string::npos) core.unknown_compression_ = true;
}

} // namespace lobelia::host
