#include "app/command_help.h"

#include "core/sculpt/tool.h"

#include <sstream>

namespace app {

using session::CommandParameter;

/// "above 0", "0 to 1", "" where any number will do.
static std::string rangeOf(const CommandParameter& p) {
    std::ostringstream out;
    if (p.min == CommandParameter::positive)
        out << "above 0";
    else if (p.max > p.min && p.max < CommandParameter::largest)
        out << p.min << " to " << p.max;
    return out.str();
}

std::string detailsOf(const CommandParameter& p) {
    std::string out = p.type;
    for (const std::string& part : {rangeOf(p), std::string(p.unit), std::string(p.choices)})
        out += part.empty() ? "" : ", " + part;
    const std::string fallback = p.fallback;
    return out + (fallback.empty() ? ", required" : fallback == "null" ? "" : ", default " + fallback);
}

static std::string toolHelp() {
    std::ostringstream out;
    for (const sculpt::ToolRow& tool : sculpt::toolTable()) {
        out << "  " << tool.id << ": " << tool.tip << "\n";
        for (const sculpt::ToolParameter& p : tool.parameters)
            out << "    " << p.id << " (" << p.min << " to " << p.max << (*p.unit ? " " : "") << p.unit << ", default "
                << p.fallback << "): " << p.tip << "\n";
    }
    return out.str();
}

std::string commandHelp() {
    std::string out =
        "Commands: one JSON object per line; lines that begin with # are comments; relative paths start in "
        "the session's folder:\n";
    for (const session::CommandRow& row : session::commandTable()) {
        out += std::string("  ") + row.op + ": " + row.tip + "\n";
        for (const CommandParameter& p : row.parameters)
            out += std::string("    ") + p.id + " (" + detailsOf(p) + "): " + p.tip + "\n";
    }
    return out + "Stroke tools and their own parameters:\n" + toolHelp();
}

} // namespace app
