#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <typeindex>
#include <utility>

namespace lobelia::test {

/// The Vulkan objects that are alive. Descriptor sets and command buffers count with their pools.
class Census {
public:
    template <class Handle>
    void born(Handle handle) {
        alive_.insert(key(handle));
    }
    template <class Handle>
    void died(Handle handle) {
        if (!handle) return;
        const auto found = alive_.find(key(handle));
        if (found == alive_.end())
            ++unknown_deaths_;
        else
            alive_.erase(found);
    }

    std::size_t alive() const { return alive_.size(); }
    /// How often something was destroyed that was not alive.
    std::size_t unknown_deaths() const { return unknown_deaths_; }
    /// The types of what is alive.
    std::string text() const {
        std::string types;
        for (const auto& [type, handle] : alive_) types += std::string(type.name()) + " ";
        return types;
    }

private:
    using Key = std::pair<std::type_index, std::uint64_t>;
    template <class Handle>
    static Key key(Handle handle) {
        return {typeid(Handle), reinterpret_cast<std::uint64_t>(handle)};
    }

    std::multiset<Key> alive_;
    std::size_t unknown_deaths_ = 0;
};

} // namespace lobelia::test
