#include "prefilter_method.h"

namespace lobelia::cli {

using host::PrefilterMethod;

host::Outcome<PrefilterMethod> parse_prefilter_method(std::string_view text) {
    for (const PrefilterMethod method : PREFILTER_METHODS)
        if (text == prefilter_method_name(method)) return method;
    return host::Failure{"\"" + std::string(text) +
                         "\" is no method; there are chain, importance, filtered-importance and "
                         "exact"};
}

const char* prefilter_method_name(PrefilterMethod method) {
    switch (method) {
    case PrefilterMethod::chain: return "chain";
    case PrefilterMethod::importance: return "importance";
    case PrefilterMethod::filtered_importance: return "filtered-importance";
    case PrefilterMethod::exact: return "exact";
    }
    return "";
}

bool takes_samples(PrefilterMethod method) {
    return method == PrefilterMethod::importance || method == PrefilterMethod::filtered_importance;
}

} // namespace lobelia::cli
