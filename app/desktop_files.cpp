#include "app/desktop_files.h"

#include "app/command_line.h"
#include "app/subcommands/subcommand.h"
#include "core/io/formats.h"

#include <algorithm>
#include <sstream>

namespace app {

static std::vector<std::string> wordsOf(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> out;
    for (std::string word; in >> word;)
        out.push_back(word);
    return out;
}

/// Extensions that are a format's own: texts and tables belong to other programs.
static std::vector<std::string> ownExtensions(const io::FormatRow& row) {
    std::vector<std::string> out = wordsOf(row.extensions);
    std::erase_if(out, [](const std::string& each) { return each == "txt" || each == "csv" || each == "asc"; });
    return out;
}

static std::string mimeOf(const io::FormatRow& row) {
    const std::string id = row.id;
    const bool registered = id == "obj" || id == "stl";
    return (registered ? "model/" : "model/x-") + id;
}

template <class Fn>
static void forReadable(const Fn& fn) {
    for (const io::FormatRow& row : io::formatTable())
        if (row.read && !ownExtensions(row).empty())
            fn(row);
}

std::string desktopEntry() {
    std::string types;
    forReadable([&](const io::FormatRow& row) { types += mimeOf(row) + ";"; });
    return "[Desktop Entry]\nType=Application\nName=Pointclay\nGenericName=Sculptor of point-set surfaces\n"
           "Comment=Sculpts and edits point-set surfaces\nExec=pointclay %F\nIcon=pointclay\nTerminal=false\n"
           "Categories=Graphics;3DGraphics;\nStartupWMClass=pointclay\nMimeType=" +
           types + "\n";
}

static std::string escapedXml(const std::string& text) {
    std::string out;
    for (const char c : text)
        out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

std::string mimeTypes() {
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<mime-info xmlns=\"http://www.freedesktop.org/standards/shared-mime-info\">\n";
    forReadable([&](const io::FormatRow& row) {
        out += "  <mime-type type=\"" + mimeOf(row) + "\">\n    <comment>" + escapedXml(row.label) + "</comment>\n";
        for (const std::string& extension : ownExtensions(row))
            out += "    <glob pattern=\"*." + extension + "\"/>\n";
        out += "  </mime-type>\n";
    });
    return out + "</mime-info>\n";
}

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

/// Those that help would show.
static std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
    std::vector<const CLI::Option*> out;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty())
            out.push_back(option);
    return out;
}

template <class Fn>
static void forSubcommands(const Fn& fn) {
    for (const SubcommandRow& row : subcommandTable()) {
        CLI::App command(row.tip, row.name);
        CommonOptions common;
        addCommon(command, common);
        const Action action = row.add(command); // holds what the options write to
        fn(row, command);
    }
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
           "    [ \"${#COMPREPLY[@]}\" = 0 ] && COMPREPLY=($(compgen -f -- \"${COMP_WORDS[COMP_CWORD]}\"))\n}\n"
           "complete -o filenames -F _pointclay pointclay\n";
}

} // namespace app
