#include <algorithm>

#include <lobelia/scene.h>

#include "prefilter_plan.h"

namespace lobelia {

namespace {

bool same_ladder(const Ladder& a, const Ladder& b) {
    return a.lowest == b.lowest && a.rungs == b.rungs;
}

/// Whether the maps that are there are all that the later plan has.
bool serves(const PrefilterPlan& before, const PrefilterPlan& after) {
    const auto& made = before.state();
    const auto& wanted = after.state();
    if (made.source_size != wanted.source_size || made.quality != wanted.quality ||
        made.map_format != wanted.map_format)
        return false;
    if (wanted.ladder.rungs && !same_ladder(made.ladder, wanted.ladder)) return false;
    return std::all_of(after.maps().begin(), after.maps().end(), [&](const PrefilteredMap& map) {
        return std::any_of(before.maps().begin(), before.maps().end(),
                           [&](const PrefilteredMap& other) {
                               return map.exponent == other.exponent && map.size == other.size &&
                                      map.filter == other.filter;
                           });
    });
}

/// Whether the blurred background that the later plan has, if any, is there.
bool same_background(const ScenePlan& before, const ScenePlan& after) {
    const PrefilteredMap* const made = before.background_map();
    const PrefilteredMap* const wanted = after.background_map();
    return !wanted || (made && made->exponent == wanted->exponent);
}

} // namespace

SceneEdit edit_between(const ScenePlan& before, const ScenePlan& after) noexcept {
    SceneEdit edit{.shading = !(before.shading() == after.shading())};
    const auto has = [](const ScenePlan& plan, const ScenePass& pass) {
        return std::any_of(plan.passes().begin(), plan.passes().end(), [&](const ScenePass& other) {
            return std::string_view(pass.name) == other.name &&
                   pass.bytes_written == other.bytes_written;
        });
    };
    const PrefilterPlan* const made = before.prefilter();
    const PrefilterPlan* const wanted = after.prefilter();
    if (wanted && !(made && serves(*made, *wanted) && same_background(before, after)))
        edit.maps = made && wanted->shares_levels(*made) ? SceneEdit::Maps::from_levels
                                                         : SceneEdit::Maps::anew;
    for (const ScenePass& pass : after.passes())
        if ((std::string_view(pass.name) == "mips" ||
             std::string_view(pass.name) == "irradiance") &&
            !has(before, pass))
            edit.maps = SceneEdit::Maps::anew;
    return edit;
}

} // namespace lobelia
