#pragma once

#include <string_view>

#include <lobelia/host/work.h>

namespace lobelia::cli {

inline constexpr host::PrefilterMethod PREFILTER_METHODS[] = {
    host::PrefilterMethod::chain, host::PrefilterMethod::importance,
    host::PrefilterMethod::filtered_importance, host::PrefilterMethod::exact};

/// The method called so.
host::Outcome<host::PrefilterMethod> parse_prefilter_method(std::string_view text);

/// As on the command line.
const char* prefilter_method_name(host::PrefilterMethod method);

/// Whether it works by a number of samples that is to be chosen.
bool takes_samples(host::PrefilterMethod method);

} // namespace lobelia::cli
