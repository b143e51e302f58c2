#include "core/session/recover.h"

#include "core/base/error.h"
#include "core/io/folder_names.h"
#include "core/session/journal.h"
#include "core/session/journal_files.h"
#include "core/session/json_text.h"
#include "core/session/path_text.h"
#include "core/session/session_file.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace session {

namespace fs = std::filesystem;
using nlohmann::json;

static std::string modelOf(const json& first) {
    const auto path = first.find("path");
    return path != first.end() && path->is_string() ? path->get<std::string>() : std::string();
}

/// Null where the line is no JSON.
static json firstOf(const std::string& line) {
    try {
        return jsonOf(line);
    } catch (const base::Error&) {
        return {};
    }
}

/// Reads the first line and counts the whole ones that follow; false where there is no whole line.
static bool summarise(LeftJournal& journal) {
    std::ifstream in(journal.path, std::ios::binary);
    std::string line;
    int lines = 0;
    while (std::getline(in, line) && !in.eof())
        if (line == openedLine) {
            lines = std::min(lines, 1);
        } else if (lines++ == 0) {
            const json first = firstOf(line);
            if (!first.is_object())
                return false;
            journal.model = pathOf(modelOf(first));
        }
    journal.commands = lines - 1;
    return lines > 0;
}

std::vector<LeftJournal> findLeftJournals(const fs::path& folder) {
    std::vector<LeftJournal> out;
    std::error_code none;
    for (const std::string& name : io::namesIn(folder)) {
        const fs::path path = folder / name;
        if (!name.starts_with("journal-") || path.extension() != ".jsonl" || isJournalHeld(path))
            continue;
        LeftJournal journal{path, {}, fs::last_write_time(path, none), 0};
        if (summarise(journal))
            out.push_back(std::move(journal));
    }
    std::sort(out.begin(), out.end(), [](const LeftJournal& a, const LeftJournal& b) {
        return a.time != b.time ? a.time > b.time : a.path < b.path;
    });
    return out;
}

std::vector<LeftJournal> findLeftJournals() {
    return findLeftJournals(stateFolder());
}

static void count(std::vector<std::pair<std::string, int>>& steps, const std::string& label) {
    for (auto& [known, times] : steps)
        if (known == label) {
            ++times;
            return;
        }
    steps.emplace_back(label, 1);
}

Recovery recover(const fs::path& journal, Context& context) {
    constexpr int told = 10;
    Recovery out;
    std::string torn;
    ReplayOptions options;
    options.torn = [&](int line) {
        torn = journal.string() + ":" + std::to_string(line) +
               ": the last line breaks off, as a crash leaves it; it was left out";
    };
    options.passedOver = [&](const base::Error& error) {
        if (++out.leftOut <= told)
            context.messages.push_back(error.message() + "; this line was left out");
    };
    options.done = [&](const LineReport& report) {
        const CommandRow& row = command(report.op);
        const bool step = row.changesModel && !row.startsModel && row.op != std::string_view("undo") &&
                          row.op != std::string_view("redo") && context.document.canUndo();
        if (step)
            count(out.steps, context.document.undoLabel());
    };
    out.commands = replay(journal, context, options);
    if (out.commands == 0)
        throw base::Error("holds no complete command", journal.string(), "there is nothing to recover");
    if (out.leftOut > told)
        context.messages.push_back(journal.string() + ": " + std::to_string(out.leftOut - told) +
                                   " more lines were left out");
    if (!torn.empty())
        context.messages.push_back(torn);
    return out;
}

} // namespace session
