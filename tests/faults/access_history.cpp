#include "access_history.h"

#include <algorithm>

namespace lobelia::test {

namespace {

constexpr VkPipelineStageFlags EVERY_STAGE = 0x7fffffffu ^ VK_PIPELINE_STAGE_HOST_BIT;
constexpr VkPipelineStageFlags GRAPHICS = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT |
                                          VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT |
                                          VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
constexpr VkAccessFlags WRITES = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT |
                                 VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_HOST_WRITE_BIT |
                                 VK_ACCESS_MEMORY_WRITE_BIT;

VkPipelineStageFlags named(VkPipelineStageFlags stages) {
    if (stages & VK_PIPELINE_STAGE_ALL_COMMANDS_BIT) stages |= EVERY_STAGE;
    if (stages & VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT) stages |= GRAPHICS;
    return stages;
}

// The first scope of an execution dependency has the stages before those named, too.
VkPipelineStageFlags first_stages(VkPipelineStageFlags stages) {
    stages = named(stages);
    if (stages & VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT) stages |= EVERY_STAGE;
    if (stages & VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT) stages |= GRAPHICS;
    if (stages & VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT)
        stages |= VK_PIPELINE_STAGE_VERTEX_SHADER_BIT;
    return stages & ~VkPipelineStageFlags(VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT);
}

// And the second one those after.
VkPipelineStageFlags second_stages(VkPipelineStageFlags stages) {
    stages = named(stages);
    if (stages & VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT) stages |= EVERY_STAGE;
    if (stages & VK_PIPELINE_STAGE_VERTEX_SHADER_BIT) stages |= GRAPHICS;
    if (stages & VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT)
        stages |= VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    return stages & ~VkPipelineStageFlags(VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
}

bool covers(VkAccessFlags scope, VkAccessFlags access) {
    if (scope & VK_ACCESS_MEMORY_WRITE_BIT) scope |= WRITES;
    if (scope & VK_ACCESS_MEMORY_READ_BIT) scope |= ~WRITES;
    return (access & ~scope) == 0;
}

} // namespace

// A write needs its memory made visible, a read only to have happened.
bool AccessHistory::orders(const Access& earlier, const Scope& later, bool needs_memory) {
    if (later.stages & ~earlier.before) return false;
    return !needs_memory || (earlier.available && !(later.stages & ~earlier.visible.stages) &&
                             covers(earlier.visible.accesses, later.accesses));
}

// The accesses to the part, cut off at its ends.
std::vector<AccessHistory::Access*> AccessHistory::cut(const Part& part) {
    std::vector<Access>& accesses = all_[part.resource];
    for (const std::uint64_t edge : {part.begin, part.end}) {
        const std::size_t count = accesses.size();
        for (std::size_t i = 0; i < count; ++i)
            if (accesses[i].begin < edge && edge < accesses[i].end) {
                Access rest = accesses[i];
                rest.begin = edge;
                accesses[i].end = edge;
                accesses.push_back(rest);
            }
    }
    std::vector<Access*> inside;
    for (Access& access : accesses)
        if (access.begin >= part.begin && access.end <= part.end) inside.push_back(&access);
    return inside;
}

void AccessHistory::access(const Part& part, const Scope& by, bool writes,
                           const std::string& what) {
    for (const Access* const earlier : cut(part))
        if ((earlier->writes || writes) && earlier->command != command_ &&
            !orders(*earlier, by, earlier->writes))
            hazards.push_back(what + (writes ? " writes" : " reads") + " what " + earlier->what +
                              (earlier->writes ? " writes" : " reads") +
                              ", and nothing orders them");
    std::vector<Access>& accesses = all_[part.resource];
    std::erase_if(accesses, [&](const Access& earlier) {
        const bool same_read = !writes && !earlier.writes && earlier.by.stages == by.stages;
        return (writes || same_read) && earlier.begin >= part.begin && earlier.end <= part.end;
    });
    accesses.push_back({part.begin, part.end, by, writes, what, command_});
}

void AccessHistory::apply(Access& access, const Scope& first, const Scope& second, bool memory) {
    const VkPipelineStageFlags stages = first_stages(first.stages);
    if (!((access.by.stages | access.before) & stages)) return;
    if (memory && access.writes) {
        access.available |= (access.by.stages & named(first.stages)) &&
                            covers(first.accesses, access.by.accesses & WRITES);
        if (access.available) {
            access.visible.stages |= named(second.stages);
            access.visible.accesses |= second.accesses;
        }
    }
    access.before |= second_stages(second.stages);
}

void AccessHistory::depend(const Scope& first, const Scope& second) {
    const bool memory = first.accesses || second.accesses;
    for (auto& [resource, accesses] : all_)
        for (Access& access : accesses) apply(access, first, second, memory);
}

void AccessHistory::depend(const Part& part, const Scope& first, const Scope& second,
                           bool changes_layout) {
    for (Access* const access : cut(part)) {
        apply(*access, first, second, true);
        const bool ordered =
            access->before & second_stages(second.stages) || !second_stages(second.stages);
        if (changes_layout && (!ordered || (access->writes && !access->available)))
            hazards.push_back("a change of layout writes what " + access->what +
                              (access->writes ? " writes" : " reads") +
                              ", and nothing orders them");
    }
    if (!changes_layout) return;
    std::vector<Access>& accesses = all_[part.resource];
    std::erase_if(accesses, [&](const Access& earlier) {
        return earlier.begin >= part.begin && earlier.end <= part.end;
    });
    accesses.push_back({part.begin,
                        part.end,
                        {},
                        true,
                        "a change of layout",
                        0,
                        second_stages(second.stages),
                        true,
                        {named(second.stages), second.accesses}});
}

void AccessHistory::finish(const std::vector<std::uint64_t>& mapped) {
    const Scope host{VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT};
    for (const std::uint64_t resource : mapped)
        for (const Access& access : all_[resource])
            if (access.writes && !orders(access, host, true))
                hazards.push_back("the host reads what " + access.what +
                                  " writes, and nothing makes it visible to the host");
    all_.clear();
}

} // namespace lobelia::test
