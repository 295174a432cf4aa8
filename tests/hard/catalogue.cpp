#include "catalogue.h"

namespace lobelia::hard {

const std::vector<Kind>& catalogue() {
    static const std::vector<Kind> all{lobe_numerics()};
    return all;
}

} // namespace lobelia::hard
