// The manual page: loops over subcommands, their options, and formats.
#include "app/desktop/described_subcommands.h"
#include "app/desktop/desktop_files.h"
#include "core/io/formats.h"

namespace app {

/// Text of a manual page: no hyphen of its own, no request by accident.
static std::string escapedMan(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
            out += "\\&";
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return out;
}

std::string manPage() {
    std::string out = ".TH POINTCLAY 1 \"\" \"Pointclay " POINTCLAY_VERSION "\" \"User Commands\"\n"
                      ".SH NAME\npointclay \\- sculpts and edits point-set surfaces\n"
                      ".SH SYNOPSIS\n.B pointclay\n[\\fIMODEL\\fR...]\n.br\n.B pointclay\n\\fISUBCOMMAND\\fR "
                      "[\\fIOPTION\\fR...]\n.SH DESCRIPTION\n";
    CLI::App program("", "pointclay");
    CommonOptions common;
    describe(program, common);
    out += escapedMan(program.get_description()) + "\n.SH SUBCOMMANDS\n";
    forSubcommands([&](const SubcommandRow& row, const CLI::App& command) {
        out += std::string(".SS ") + row.name + "\n" + escapedMan(row.tip) + "\n";
        for (const CLI::Option* option : optionsOf(command))
            out += ".TP\n.B " + escapedMan(option->get_name(true, true)) + "\n" +
                   escapedMan(option->get_description()) + "\n";
        out += std::string(".PP\nExample:\n.B ") + escapedMan(row.example) + "\n";
    });
    out += ".SH FILES\n";
    for (const io::FormatRow& row : io::formatTable())
        out += std::string(".TP\n.B ") + escapedMan(row.extensions) + "\n" + escapedMan(row.label) +
               (row.read && row.write ? ", read and written\n"
                : row.read            ? ", read\n"
                                      : ", written\n");
    return out;
}

} // namespace app
