#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <CLI/CLI.hpp>

#include <lobelia/host/outcome.h>

namespace lobelia::cli {

/// Adds an option that takes one word, which `parse` turns into a value for `store`. What `parse`
/// refuses is wrong usage, told with the option's name.
template <class T, class Store>
CLI::Option* add_parsed(CLI::App& verb, const std::string& names,
                        host::Outcome<T> (*parse)(std::string_view), Store store,
                        const std::string& form, const std::string& description) {
    const auto read = [parse, store, names](const std::string& text) {
        host::Outcome<T> value = parse(text);
        if (!value) throw CLI::ValidationError(names, value.error().message);
        store(std::move(*value));
    };
    return verb.add_option_function<std::string>(names, read, description)->type_name(form);
}

/// The same for a value that is stored as it is.
template <class T, class Target>
CLI::Option* add_parsed(CLI::App& verb, const std::string& names,
                        host::Outcome<T> (*parse)(std::string_view), Target* target,
                        const std::string& form, const std::string& description) {
    return add_parsed(
        verb, names, parse, [target](T value) { *target = std::move(value); }, form, description);
}

} // namespace lobelia::cli
