#include "quality.h"

#include <string>

namespace lobelia::cli {

host::Outcome<Quality> parse_quality(std::string_view text) {
    for (const Quality quality : {Quality::fast, Quality::normal, Quality::high})
        if (text == quality_name(quality)) return quality;
    return host::Failure{"\"" + std::string(text) +
                         "\" is no quality; there are fast, normal and high"};
}

const char* quality_name(Quality quality) {
    switch (quality) {
    case Quality::fast: return "fast";
    case Quality::normal: return "normal";
    case Quality::high: return "high";
    }
    return "";
}

} // namespace lobelia::cli
