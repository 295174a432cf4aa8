#include "shader_accesses.h"

#include <set>
#include <utility>

namespace lobelia::test {

namespace {

// Numbers of the SPIR-V specification.
enum Operation : std::uint32_t {
    STRUCT = 30,
    POINTER = 32,
    VARIABLE = 59,
    DECORATE = 71,
    MEMBER = 72
};
enum Decoration : std::uint32_t { NON_WRITABLE = 24, NON_READABLE = 25, BINDING = 33 };
constexpr std::size_t HEADER_WORDS = 5;

using Decorated = std::pair<std::uint32_t, std::uint32_t>; // id, decoration

} // namespace

std::map<std::uint32_t, BindingUse> shader_accesses(std::span<const std::uint32_t> spirv) {
    std::map<std::uint32_t, std::uint32_t> bindings, pointees, variables; // by id
    std::map<std::uint32_t, std::size_t> member_counts;
    std::set<Decorated> decorated;
    std::map<Decorated, std::size_t> decorated_members;
    for (std::size_t i = HEADER_WORDS; i < spirv.size(); i += spirv[i] >> 16) {
        const std::uint32_t* const words = &spirv[i];
        switch (words[0] & 0xffff) {
        case STRUCT: member_counts[words[1]] = (words[0] >> 16) - 2; break;
        case POINTER: pointees[words[1]] = words[3]; break;
        case VARIABLE: variables[words[2]] = words[1]; break;
        case MEMBER: ++decorated_members[{words[1], words[3]}]; break;
        case DECORATE:
            decorated.insert({words[1], words[2]});
            if (words[2] == BINDING) bindings[words[1]] = words[3];
            break;
        }
    }
    std::map<std::uint32_t, BindingUse> uses;
    for (const auto& [bound, binding] : bindings) {
        const std::uint32_t variable = bound, type = pointees[variables[variable]];
        const auto is = [&](Decoration decoration) {
            const auto members = member_counts.find(type); // of a buffer: all its members are
            return decorated.contains({variable, decoration}) ||
                   (members != member_counts.end() &&
                    decorated_members[{type, decoration}] == members->second);
        };
        uses[binding] = {!is(NON_READABLE), !is(NON_WRITABLE)};
    }
    return uses;
}

} // namespace lobelia::test
