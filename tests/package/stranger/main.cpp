// Plans the maps of a glossy material and says what they are, with the installed headers alone.
#include <cstdio>

#include <lobelia/clipped_tables.h>
#include <lobelia/lobe.h>
#include <lobelia/prefilter.h>

int main() {
    const lobelia::Ladder ladder = lobelia::ladder_for(lobelia::Taps::two, 64, 64);
    const auto plan = lobelia::PrefilterPlan::make({.ladder = ladder, .source_size = 256});
    if (!plan) return 1;
    std::printf("%u rungs of %u texels, albedo %g\n", ladder.rungs, plan->ladder_size(),
                double(lobelia::phong_albedo(0.5f, 64)));
    return ladder.rungs >= 2 && plan->ladder_size() >= 32 ? 0 : 1;
}
