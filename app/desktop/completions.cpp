// Words that a shell completes: a loop over the subcommands.
#include "app/desktop/described_subcommands.h"
#include "app/desktop/desktop_files.h"

namespace app {

std::string bashCompletions() {
    std::string names, cases;
    forSubcommands([&](const SubcommandRow& row, const CLI::App& command) {
        names += (names.empty() ? "" : " ") + std::string(row.name);
        std::string options;
        for (const CLI::Option* option : optionsOf(command))
            for (const std::string& name : option->get_lnames())
                options += (options.empty() ? "--" : " --") + name;
        cases += "        " + std::string(row.name) + ") words=\"" + options + "\" ;;\n";
    });
    return "# bash completions of pointclay\n_pointclay() {\n    local words=\"--help --version\"\n"
           "    [ \"$COMP_CWORD\" = 1 ] && words=\"" +
           names + " $words\"\n    case \"${COMP_WORDS[1]}\" in\n" + cases +
           "    esac\n    COMPREPLY=($(compgen -W \"$words\" -- \"${COMP_WORDS[COMP_CWORD]}\"))\n"
           "    [ \"${#COMPREPLY[@]}\" = 0 ] && mapfile -t COMPREPLY < <(compgen -f -- "
           "\"${COMP_WORDS[COMP_CWORD]}\")\n}\n"
           "complete -o filenames -F _pointclay pointclay\n";
}

} // namespace app
