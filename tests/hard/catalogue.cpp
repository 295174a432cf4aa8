#include "catalogue.h"

namespace lobelia::hard {

const std::vector<Kind>& catalogue() {
    static const std::vector<Kind> all{
        lobe_numerics(),  suns(),         texel_values(),  image_sizes(), exr_forms(),
        radiance_forms(), not_pictures(), hostile_files(), geometry(),    views(),
        devices(),        processes(),    oracle_facts()};
    return all;
}

} // namespace lobelia::hard
