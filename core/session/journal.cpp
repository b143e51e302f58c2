#include "core/session/journal.h"

#include "core/base/error.h"
#include "core/base/sync_folder.h"
#include "core/session/locked_file.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace session {

namespace fs = std::filesystem;
using nlohmann::json;

fs::path stateFolder() {
    if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state == '/')
        return fs::path(state) / "pointclay";
    const char* home = std::getenv("HOME");
    return (home && *home ? fs::path(home) / ".local/state" : fs::temp_directory_path()) / "pointclay";
}

fs::path keptSource(const fs::path& journal, const fs::path& source) {
    return journal.string() + ".source" + source.extension().string();
}

void removeJournal(const fs::path& journal) {
    std::error_code ignored;
    fs::remove(journal, ignored);
    const fs::path folder = journal.has_parent_path() ? journal.parent_path() : fs::path(".");
    for (const auto& entry : fs::directory_iterator(folder, ignored))
        if (entry.path().filename() == keptSource(journal, entry.path()).filename())
            fs::remove(entry.path(), ignored);
}

bool isJournalHeld(const fs::path& journal) {
    return isLocked(journal);
}

/// The first free name of this process; a left journal of an earlier process of the same number stays.
static fs::path defaultPath() {
    const fs::path folder = stateFolder();
    fs::create_directories(folder);
    const std::string stem = "journal-" + std::to_string(::getpid());
    fs::path out = folder / (stem + ".jsonl");
    for (int k = 2; fs::exists(out); ++k)
        out = folder / (stem + "-" + std::to_string(k) + ".jsonl");
    return out;
}

static std::string lineOf(const json& command) {
    return command.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

static std::string contentOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

Journal::Journal(fs::path file) {
    try {
        m_path = file.empty() ? defaultPath() : fs::absolute(file);
        if (fs::exists(m_path) && !fs::is_regular_file(m_path)) // it would be replaced
            throw base::Error("a journal must be a file", m_path.string(), "choose another name");
        if (isLocked(m_path))
            throw base::Error("another process writes its journal here", m_path.string(), "choose another file");
        begin({});
    } catch (const std::system_error& error) {
        throw base::Error("cannot write the journal: " + error.code().message(), m_path.string(),
                          "name a writable file with --journal");
    }
}

Journal::~Journal() {
    closeFile(m_file);
}

/// Puts a new file of this content in the place of the old one; a crash leaves either of them whole.
void Journal::begin(const std::string& content) {
    const fs::path next = m_path.string() + ".new";
    const int file = createLocked(next);
    try {
        appendDurably(file, content);
        fs::rename(next, m_path);
    } catch (...) {
        closeFile(file);
        std::error_code ignored;
        fs::remove(next, ignored);
        throw;
    }
    closeFile(std::exchange(m_file, file));
    base::syncFolder(m_path.parent_path());
}

void Journal::append(const std::string& line) {
    appendDurably(m_file, line);
}

template <class Write>
void Journal::guarded(Context& context, const Write& write) {
    if (m_stopped)
        return;
    try {
        write();
    } catch (const std::system_error& error) {
        m_stopped = true;
        context.messages.push_back(m_path.string() + ": the journal cannot be written (" + error.code().message() +
                                   "); save often, a crash would lose what is not saved");
    }
}

void Journal::record(const json& complete, Context& context) {
    guarded(context, [&] {
        const std::string op = complete.at("op").get<std::string>();
        if (!command(op).startsModel)
            return append(lineOf(complete));
        json first = complete;
        m_source.clear();
        if (op == "open") {
            first["hash"] = context.document.hash().text();
            m_source = first.at("path").get<std::string>();
            if (first.contains("source")) // kept by the journal that is being recovered, which may go
                keep(first["source"].get<std::string>(), first);
        }
        begin(lineOf(first));
    });
}

/// Copies the file that `open` reads to this journal's side and lets it read the copy.
void Journal::keep(const fs::path& source, json& open) {
    const fs::path kept = keptSource(m_path, source);
    fs::copy_file(source, kept, fs::copy_options::overwrite_existing);
    open["source"] = kept.string();
    m_source = kept;
}

void Journal::keepSource(const fs::path& target, Context& context) {
    std::error_code unequal;
    if (m_source.empty() || !fs::equivalent(m_source, target, unequal))
        return;
    guarded(context, [&] {
        const std::string content = contentOf(m_path);
        const std::size_t end = content.find('\n');
        json first = json::parse(content.substr(0, end));
        keep(m_source, first);
        begin(lineOf(first) + content.substr(end + 1));
    });
}

void Journal::discard() {
    m_stopped = true;
    closeFile(std::exchange(m_file, -1));
    removeJournal(m_path);
}

} // namespace session
