#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>

namespace lobelia::test {

/// Part of an image or buffer: bytes of a buffer, or layers of one level of an image, which are
/// numbered level * 4096 + layer.
struct Part {
    std::uint64_t resource = 0;
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

/// One side of a dependency.
struct Scope {
    VkPipelineStageFlags stages = 0;
    VkAccessFlags accesses = 0;
};

/// The accesses of recorded commands to images and buffers and what orders them: a dependency makes
/// writes of its first scope available, and visible to its second one ("Synchronization and Cache
/// Control" of the specification). Two accesses with a write among them must be so ordered.
class AccessHistory {
public:
    /// The accesses from here on are another command's: it is not ordered within itself.
    void next_command() { ++command_; }

    /// A command's access. A hazard against an earlier one is remembered.
    void access(const Part& part, const Scope& by, bool writes, const std::string& what);

    /// A dependency: of everything, or of a part. One that changes an image's layout writes it.
    void depend(const Scope& first, const Scope& second);
    void depend(const Part& part, const Scope& first, const Scope& second, bool changes_layout);

    /// All has ended: later work needs no order. `mapped` resources are read by the host then.
    void finish(const std::vector<std::uint64_t>& mapped);
    void forget(std::uint64_t resource) { all_.erase(resource); }

    std::vector<std::string> hazards;

private:
    struct Access {
        std::uint64_t begin, end;
        Scope by;
        bool writes;
        std::string what;
        std::size_t command = 0;
        VkPipelineStageFlags before = 0; // the stages that it is ordered before
        bool available = false;
        Scope visible{};
    };
    static bool orders(const Access& earlier, const Scope& later, bool needs_memory);
    static void apply(Access& access, const Scope& first, const Scope& second, bool memory);
    std::vector<Access*> cut(const Part& part);

    std::size_t command_ = 0;
    std::map<std::uint64_t, std::vector<Access>> all_; // by resource
};

} // namespace lobelia::test
