#include <csignal>
#include <exception>

#include <CLI/CLI.hpp>

#include "messages.h"
#include "verbs.h"

namespace lobelia::cli {

namespace {

// The verb that was given, or the program where none was.
const CLI::App& asked(const CLI::App& program) {
    const auto verbs = program.get_subcommands();
    return verbs.empty() ? program : *verbs.front();
}

int wrong_usage(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& verb = asked(program);
    const std::string name = &verb == &program ? "" : verb.get_name();
    say((name.empty() ? "" : name + ": ") + error.what() + "; see lobelia " +
        (name.empty() ? "" : name + " ") + "-h");
    return WRONG_USAGE;
}

int run(int argument_count, char** arguments) {
    int status = SUCCEEDED;
    CLI::App program("Image-based lighting with Phong lobes on Vulkan", "lobelia");
    program.set_version_flag("--version", "lobelia " LOBELIA_VERSION);
    program.require_subcommand(1);
    add_render(program, status);
    add_prefilter(program, status);
    add_view(program, status);
    add_measure(program, status);
    add_gallery(program, status);
    add_plan(program, status);
    add_devices(program, status);
    try {
        program.parse(argument_count, arguments);
    } catch (const CLI::CallForHelp&) {
        const CLI::App& verb = asked(program);
        return print(&verb == &program ? program.help() : verb.help("lobelia"));
    } catch (const CLI::CallForVersion& version) {
        return print(std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& error) {
        return wrong_usage(program, error);
    }
    return status;
}

} // namespace

} // namespace lobelia::cli

int main(int argument_count, char** arguments) {
    // A limit on the size of files is then an error of the write like any other.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        return lobelia::cli::run(argument_count, arguments);
    } catch (const std::bad_alloc&) {
        return lobelia::cli::fail("out of memory");
    } catch (const std::exception& error) {
        return lobelia::cli::fail(error.what());
    }
}
