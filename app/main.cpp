// pointclay: one of the subcommands of subcommands/subcommand_table.cpp, or the window, a program of its own beside
// this one.
#include "app/command_line.h"
#include "app/subcommands/subcommand.h"
#include "core/base/cancel_scope.h"
#include "core/base/near_word.h"
#include "core/base/parallel.h"
#include "core/base/row_of_id.h"
#include "core/io/file_name.h"
#include "core/io/formats.h"

#include <filesystem>
#include <iostream>
#include <unistd.h>

namespace {

int runSubcommand(const app::Action& action, const app::CommonOptions& common) {
    base::setThreadCount(common.threads);
    const base::CancelScope scope(&app::catchInterrupts());
    app::Console console(common.quiet);
    action(console);
    std::cout.flush();
    return std::cout ? 0 : app::fail("standard output cannot be written", 1);
}

/// Whether a person may mean a model by it, rather than a subcommand that there is not.
bool mayBeModel(const std::string& word) {
    std::error_code unknown;
    return std::filesystem::exists(word, unknown) || word.starts_with("sample:") ||
           io::rowOfExtension(io::formatTable(), io::extensionOf(word));
}

int refuseWord(const std::string& word) {
    const std::string known = base::joinedIds(app::subcommandTable(), &app::SubcommandRow::name);
    return app::fail("'" + word + "' is neither a subcommand nor a file; " +
                         base::didYouMeanOr(word, known, "pointclay --help names all subcommands"),
                     2);
}

/// Becomes the window's program: the same process, with the same arguments. Returns only where that fails.
int openWindow(char** argv) {
    std::error_code unknown;
    const auto beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
    const std::filesystem::path window = beside / "pointclay-window";
    ::execv(window.c_str(), argv);
    return app::fail("the window cannot be opened without " + window.string() +
                         "; build it, or work without a window: pointclay --help",
                     1);
}

int work(int argc, char** argv) {
    CLI::App program("", "pointclay");
    program.require_subcommand(0, 1);
    app::CommonOptions common;
    app::describe(program, common);

    app::Action chosen;
    for (const app::SubcommandRow& row : app::subcommandTable()) {
        CLI::App& command = *program.add_subcommand(row.name, row.tip);
        command.footer(std::string("Example: ") + row.example);
        app::addCommon(command, common);
        command.callback([&chosen, action = row.add(command)] { chosen = action; });
    }
    if (const auto code = app::parse(program, argc, argv))
        return *code;
    if (chosen)
        return runSubcommand(chosen, common);
    if (!common.models.empty() && !mayBeModel(common.models.front()))
        return refuseWord(common.models.front());
    return openWindow(argv);
}

} // namespace

int main(int argc, char** argv) {
    return app::guarded([&] { return work(argc, argv); });
}
