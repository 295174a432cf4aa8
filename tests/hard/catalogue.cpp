#include "catalogue.h"

namespace lobelia::hard {

const std::vector<Kind>& catalogue() {
    static const std::vector<Kind> all{lobe_numerics(), texel_values(), image_shapes(),
                                       hostile_files(), geometry(),     views(),
                                       devices(),       processes(),    oracle_facts()};
    return all;
}

} // namespace lobelia::hard
