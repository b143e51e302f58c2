#include "app/command_help.h"

#include "core/sculpt/tool.h"

#include <map>
#include <sstream>
#include <vector>

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

static std::string parameterHelp(const CommandParameter& p) {
    return std::string("    ") + p.id + " (" + detailsOf(p) + "): " + p.tip + "\n";
}

/// The first command in the table that tells of the parameter in the same words.
static const char* firstToTell(const CommandParameter& wanted) {
    const std::string text = parameterHelp(wanted);
    for (const session::CommandRow& row : session::commandTable())
        for (const CommandParameter& p : row.parameters)
            if (parameterHelp(p) == text)
                return row.op;
    return "";
}

constexpr std::size_t many = 5;

/// As many parameters as that which another command has as well, such as all of the surface's, are told there.
static std::string parametersHelp(const session::CommandRow& row) {
    std::map<std::string, std::vector<std::string>> elsewhere;
    for (const CommandParameter& p : row.parameters)
        if (const std::string first = firstToTell(p); *p.fallback && first != row.op)
            elsewhere[first].push_back(p.id);
    std::erase_if(elsewhere, [](const auto& each) { return each.second.size() < many; });
    std::string out;
    for (const CommandParameter& p : row.parameters)
        if (!*p.fallback || !elsewhere.contains(firstToTell(p)))
            out += parameterHelp(p);
    for (const auto& [op, ids] : elsewhere) {
        out += "    as for " + op + ":";
        for (const std::string& id : ids)
            out += ' ' + id;
        out += '\n';
    }
    return out;
}

/// To copy and change.
static constexpr const char* exampleSession =
    "Example of a session, which draws a ridge across a ball, strokes it smooth and saves the ball:\n"
    R"(  {"op":"new","sample":"sphere","count":50000})"
    "\n"
    R"(  {"op":"stroke","tool":"draw","radius":0.2,"samples":[[-0.5,0,3,0,0,-1,1,0],[0.5,0.2,3,0,0,-1,1,0.5]]})"
    "\n"
    R"(  {"op":"stroke","tool":"smooth","radius":0.3,"samples":[[0,0.1,3,0,0,-1,1,0]]})"
    "\n"
    R"(  {"op":"save","path":"ridge.ply"})"
    "\n\n";

std::string hiddenHelp() {
    std::string spared;
    for (const session::CommandRow& row : session::commandTable())
        if (row.hidden == session::HiddenParts::Spared)
            spared += (spared.empty() ? "" : ", ") + std::string(row.op);
    return "Hidden parts of a model (hide) are spared by " + spared +
           ". All other commands work on the whole model, and say how many hidden surfels they changed.";
}

std::string commandHelp() {
    std::string out = std::string(exampleSession) +
                      "Commands: one JSON object per line; lines that begin with # are comments; relative paths start "
                      "in the session's folder:\n";
    for (const session::CommandRow& row : session::commandTable())
        out += std::string("  ") + row.op + ": " + row.tip + "\n" + parametersHelp(row);
    out += hiddenHelp() + "\n";
    out += "Stroke tools and their own parameters:\n" + toolHelp();
    out.pop_back(); // help ends its last line
    return out;
}

} // namespace app
