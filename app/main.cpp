// pointclay: the window, or one of the subcommands of subcommand_table.cpp. The one door for errors: exit code 0 done,
// 1 the input or the data is at fault, 2 wrong usage.
#include "app/subcommand.h"
#include "core/base/parallel.h"
#include "ui/window/run_window.h"

#include <cstdio>
#include <iostream>

namespace {

struct Common {
    int threads = 0;
    bool quiet = false;
};

void addCommon(CLI::App& command, Common& common) {
    command.add_option("--threads", common.threads, "threads to work with; 0: all cores. Results never depend on it")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command.add_flag("--quiet", common.quiet, "no progress and no messages, only errors");
}

int fail(const std::string& message, int code) {
    std::fprintf(stderr, "pointclay: %s\n", message.c_str());
    return code;
}

/// Turns what the work throws into an exit code.
int guarded(const std::function<int()>& work) {
    try {
        return work();
    } catch (const app::UsageError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("not enough memory; try a smaller model", 1);
    } catch (const std::exception& error) { // base::Error, base::Cancelled and what libraries throw
        return fail(error.what(), 1);
    }
}

int runSubcommand(const app::Action& action, const Common& common) {
    base::setThreadCount(common.threads);
    app::catchInterrupts();
    return guarded([&] {
        app::Console console(common.quiet);
        action(console);
        std::cout.flush();
        return std::cout ? 0 : fail("standard output cannot be written", 1);
    });
}

int runWindow(int argc, char** argv, const std::vector<std::string>& models) {
    return guarded([&] { return ui::runWindow(argc, argv, {models.begin(), models.end()}); });
}

} // namespace

int main(int argc, char** argv) {
    CLI::App program("Pointclay sculpts point-set surfaces. Without a subcommand it opens its window.\n"
                     "Lengths are in model units, angles in degrees where nothing else is said.",
                     "pointclay");
    program.footer("Example: pointclay bunny.ply\nEach subcommand tells more: pointclay query --help");
    program.set_version_flag("--version", "pointclay " POINTCLAY_VERSION);
    program.require_subcommand(0, 1);
    Common common;
    addCommon(program, common);
    std::vector<std::string> models;
    program.add_option("MODEL", models, "models to open in windows");

    app::Action chosen;
    for (const app::SubcommandRow& row : app::subcommandTable()) {
        CLI::App& command = *program.add_subcommand(row.name, row.tip);
        command.footer(std::string("Example: ") + row.example);
        addCommon(command, common);
        command.callback([&chosen, action = row.add(command)] { chosen = action; });
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    if (chosen)
        return runSubcommand(chosen, common);
    base::setThreadCount(common.threads);
    return runWindow(argc, argv, models);
}
