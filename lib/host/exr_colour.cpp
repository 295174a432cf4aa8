#include "host/exr_colour.h"

#include <optional>
#include <string_view>

#include "host/message.h"

namespace lobelia::host {

namespace {

constexpr std::size_t MOST_NAMES = 8; // of channels in a message

struct Candidate {
    ExrPart part;
    std::string name;
    bool deep = false;
    bool subsampled = false;
};

std::string names_of(const std::vector<ExrChannel>& channels) {
    std::string names;
    for (std::size_t i = 0; i < channels.size() && i < MOST_NAMES; ++i)
        names += (i ? " " : "") + printable(channels[i].name, 40);
    if (channels.size() > MOST_NAMES)
        names += " and " + std::to_string(channels.size() - MOST_NAMES) + " more";
    return names.empty() ? "none" : names;
}

std::optional<std::size_t> find(const Candidate& candidate, std::string_view name) {
    for (std::size_t i = 0; i < candidate.part.channels.size(); ++i)
        if (candidate.part.channels[i].name == name) return i;
    return std::nullopt;
}

Outcome<Candidate> read_candidate(const ExrCore& core, int index, const ReadLimits& limits) {
    Candidate candidate;
    candidate.part.index = index;
    const exr_attr_chlist_t* list = nullptr;
    exr_storage_t storage = EXR_STORAGE_LAST_TYPE;
    if (exr_get_channels(core.context(), index, &list) != EXR_ERR_SUCCESS ||
        exr_get_storage(core.context(), index, &storage) != EXR_ERR_SUCCESS)
        return Failure{"has no list of channels" + core.reason() + ", export it again"};
    if (list->num_channels > 0 && std::uint32_t(list->num_channels) > limits.channels)
        return Failure{"has " + std::to_string(list->num_channels) +
                       " channels, above the limit of " + std::to_string(limits.channels) +
                       ", export only R, G and B"};
    for (int i = 0; i < list->num_channels; ++i) {
        const exr_attr_chlist_entry_t& entry = list->entries[i];
        if (entry.pixel_type < EXR_PIXEL_UINT || entry.pixel_type >= EXR_PIXEL_LAST_TYPE)
            return Failure{"has a channel of unknown type, export it as half or float"};
        candidate.subsampled |= entry.x_sampling != 1 || entry.y_sampling != 1;
        candidate.part.channels.push_back(
            {std::string(entry.name.str, std::size_t(entry.name.length)), entry.pixel_type,
             entry.p_linear != 0});
    }
    candidate.deep = storage == EXR_STORAGE_DEEP_SCANLINE || storage == EXR_STORAGE_DEEP_TILED;
    const char* name = nullptr;
    if (exr_get_name(core.context(), index, &name) == EXR_ERR_SUCCESS && name)
        candidate.name = name;
    return candidate;
}

bool is_luminance_chroma(const Candidate& candidate) {
    return find(candidate, "RY") || find(candidate, "BY");
}

// R, G and B, or Y alone.
bool take_colour(Candidate& candidate) {
    if (candidate.deep || candidate.subsampled) return false;
    const auto r = find(candidate, "R");
    const auto g = find(candidate, "G");
    const auto b = find(candidate, "B");
    const auto y = find(candidate, "Y");
    if (r && g && b)
        candidate.part.colour = {*r, *g, *b};
    else if (y && !is_luminance_chroma(candidate) && !r && !g && !b)
        candidate.part.colour = {*y};
    return !candidate.part.colour.empty();
}

bool take_red(Candidate& candidate) {
    const auto r = find(candidate, "R");
    if (candidate.deep || candidate.subsampled || !r || find(candidate, "G") ||
        find(candidate, "B"))
        return false;
    candidate.part.colour = {*r};
    return true;
}

std::string why_not(const Candidate& candidate) {
    const std::string names = names_of(candidate.part.channels);
    if (candidate.deep) return "is a deep image (channels " + names + "), flatten it";
    if (is_luminance_chroma(candidate))
        return "is luminance-chroma (channels " + names + "), export it as R, G, B";
    if (candidate.subsampled)
        return "has subsampled channels (" + names + "), export it at full resolution";
    return "has no channels R, G, B and no Y but " + names + ", export the wanted ones as R, G, B";
}

} // namespace

Outcome<ExrPart> choose_exr_colour(const ExrCore& core, const ReadLimits& limits,
                                   std::vector<std::string>& notices) {
    int count = 0;
    if (exr_get_count(core.context(), &count) != EXR_ERR_SUCCESS || count < 1)
        return Failure{"has no parts, export it again"};
    if (std::uint32_t(count) > limits.parts)
        return Failure{"has " + std::to_string(count) + " parts, above the limit of " +
                       std::to_string(limits.parts) + ", export only the wanted one"};
    std::vector<Candidate> candidates;
    for (int i = 0; i < count; ++i) {
        Outcome<Candidate> candidate = read_candidate(core, i, limits);
        if (!candidate) return candidate.error();
        candidates.push_back(std::move(*candidate));
    }

    Candidate* chosen = nullptr;
    for (Candidate& candidate : candidates)
        if (!chosen && take_colour(candidate)) chosen = &candidate;
    for (Candidate& candidate : candidates)
        if (!chosen && take_red(candidate)) {
            chosen = &candidate;
            notices.push_back("has only the channel R, which is taken as grey");
        }
    if (!chosen) {
        std::string message = why_not(candidates.front());
        if (count > 1) message += " (first of " + std::to_string(count) + " parts)";
        return Failure{message};
    }
    if (count > 1)
        notices.push_back("has " + std::to_string(count) + " parts, of which part " +
                          std::to_string(chosen->part.index + 1) + ", \"" +
                          printable(chosen->name, 40) + "\", is read");
    return std::move(chosen->part);
}

} // namespace lobelia::host
