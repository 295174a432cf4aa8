#include <lobelia/pass_rate.h>

#include <string_view>

namespace lobelia {

double predicted_milliseconds(std::span<const PassRate> rates, const char* name,
                              double work) noexcept {
    for (const PassRate& rate : rates)
        if (std::string_view(rate.name) == name) return rate.milliseconds_per_work * work;
    return 0;
}

} // namespace lobelia
