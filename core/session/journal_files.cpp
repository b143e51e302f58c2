#include "core/session/journal_files.h"

#include "core/io/folder_names.h"
#include "core/session/journal.h"
#include "core/session/locked_file.h"

#include <cstdlib>
#include <string_view>
#include <system_error>
#include <vector>

namespace session {

namespace fs = std::filesystem;

fs::path stateFolder() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state == '/')
        return fs::path(state) / "pointclay";
    const char* home = std::getenv("HOME");
    return (home && *home ? fs::path(home) / ".local/state" : fs::temp_directory_path()) / "pointclay";
}

fs::path keptSource(const fs::path& journal, const fs::path& source) {
    return journal.string() + ".source" + source.extension().string();
}

/// What stands beside `journal` and belongs to it.
static std::vector<fs::path> filesOf(const fs::path& journal) {
    std::vector<fs::path> out;
    const std::string own = journal.filename().string() + ".";
    for (const std::string& name : io::namesIn(journal.parent_path()))
        for (const char* kind : {"source", "stamp-", "new-"})
            if (name.starts_with(own + kind))
                out.push_back(journal.parent_path() / name);
    return out;
}

void removeJournal(const fs::path& journal) {
    std::error_code ignored;
    fs::remove(journal, ignored);
    for (const fs::path& each : filesOf(journal))
        if (!isLocked(each))
            fs::remove(each, ignored);
}

void removeLeftovers(const fs::path& folder) {
    std::error_code ignored;
    constexpr std::string_view extension = ".jsonl.";
    std::vector<fs::path> left;
    for (const std::string& name : io::namesIn(folder)) {
        const std::size_t end = name.find(extension);
        if (!name.starts_with("journal-") || end == std::string::npos || isLocked(folder / name))
            continue;
        const bool unfinished = name.substr(end + extension.size()).find("new-") != std::string::npos;
        if (unfinished || !fs::exists(folder / name.substr(0, end + extension.size() - 1), ignored))
            left.push_back(folder / name);
    }
    for (const fs::path& each : left)
        fs::remove(each, ignored);
}

void removeUnfinished(const fs::path& journal) {
    std::error_code ignored;
    const std::size_t own = journal.filename().string().size();
    for (const fs::path& each : filesOf(journal))
        if (each.filename().string().find(".new-", own) != std::string::npos && !isLocked(each))
            fs::remove(each, ignored);
}

bool isJournalHeld(const fs::path& journal) {
    return isLocked(journal);
}

} // namespace session
