// Every subcommand with its options, for what is written about them.
#pragma once

#include "app/command_line.h"
#include "app/subcommands/subcommand.h"

namespace app {

/// Those that help would show.
inline std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
    std::vector<const CLI::Option*> out;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            out.push_back(option);
    return out;
}

/// fn(const SubcommandRow&, const CLI::App&)
template <class Fn>
void forSubcommands(const Fn& fn) {
    for (const SubcommandRow& row : subcommandTable()) {
        CLI::App command(row.tip, row.name);
        CommonOptions common;
        addCommon(command, common);
        const Action action = row.add(command); // holds what the options write to
        fn(row, command);
    }
}

} // namespace app
