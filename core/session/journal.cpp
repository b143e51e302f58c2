#include "core/session/journal.h"

#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/base/sync_folder.h"
#include "core/io/safe_file.h"
#include "core/session/files_read.h"
#include "core/session/journal_files.h"
#include "core/session/json_text.h"
#include "core/session/locked_file.h"
#include "core/session/path_text.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace session {

namespace fs = std::filesystem;
using nlohmann::json;

/// In a folder that others can write to, they could put their files in the place of ours.
static void checkOwner(const fs::path& folder) {
    struct stat info {};
    if (::stat(folder.c_str(), &info) != 0)
        throw std::system_error(errno, std::generic_category());
    if (info.st_uid != ::geteuid() || (info.st_mode & (S_IWGRP | S_IWOTH)) != 0)
        throw base::Error("others can write to the folder of journals", folder.string(),
                          "make it yours alone (chmod 700), or name a file with --journal");
}

/// The first free name of this process; a left journal of an earlier process of the same number stays.
static fs::path defaultPath() {
    const fs::path folder = stateFolder();
    if (fs::create_directories(folder))
        fs::permissions(folder, fs::perms::owner_all);
    checkOwner(folder);
    removeLeftovers(folder);
    const std::string stem = "journal-" + std::to_string(::getpid());
    fs::path out = folder / (stem + ".jsonl");
    for (int k = 2; fs::exists(out); ++k)
        out = folder / (stem + "-" + std::to_string(k) + ".jsonl");
    return out;
}

/// Paths that are not UTF-8 become URLs.
static std::string textOf(json command) {
    for (auto& [key, value] : command.items())
        if (value.is_string())
            value = pathText(value.get_ref<const std::string&>());
        else if (value.is_array()) // of paths, or of numbers
            for (json& each : value)
                if (each.is_string())
                    each = pathText(each.get_ref<const std::string&>());
    return command.dump(-1, ' ', false, json::error_handler_t::replace);
}

static std::string lineOf(json command) {
    return textOf(std::move(command)) + "\n";
}

static std::string contentOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

static std::string hashOf(const std::string& content) {
    std::vector<std::uint32_t> words(1 + (content.size() + 3) / 4, 0);
    words[0] = static_cast<std::uint32_t>(content.size());
    std::memcpy(words.data() + 1, content.data(), content.size());
    return base::hashWords(words).text();
}

/// The blanks that end the first line of every journal and of nothing else.
static constexpr std::string_view mark = " \t\n";

static std::string marked(std::string lines) {
    const std::size_t end = lines.find('\n');
    if (end != std::string::npos && !lines.substr(0, end + 1).ends_with(mark))
        lines.replace(end, 1, mark);
    return lines;
}

/// The last line of a journal whose session came to its end.
static constexpr std::string_view endLine = "# ended\n";

/// Up to `count` bytes of a file from `begin` on.
static std::string bytesOf(const fs::path& path, std::uintmax_t begin, std::size_t count) {
    std::ifstream in(path, std::ios::binary);
    std::string out(count, '\0');
    in.seekg(static_cast<std::streamoff>(begin));
    in.read(out.data(), static_cast<std::streamsize>(count));
    out.resize(static_cast<std::size_t>(in.gcount()));
    return out;
}

/// Throws for a file that holds anything but a journal, or one that somebody may still want: it would be emptied.
static void refuseOthers(const fs::path& path) {
    constexpr std::size_t longest = 1 << 20; // of a first line
    const std::string start = bytesOf(path, 0, longest);
    if (start.empty())
        return;
    const std::size_t first = start.find('\n') + 1;
    if (!start.substr(0, first).ends_with(mark))
        throw base::Error("is not a journal and would be written over", path.string(),
                          "choose a new name for the journal");
    const std::uintmax_t size = fs::file_size(path);
    if (size > first && bytesOf(path, size - std::min<std::uintmax_t>(size, endLine.size()), endLine.size()) != endLine)
        throw base::Error("is the journal of a session that did not come to its end and would be written over",
                          path.string(),
                          "save what it holds with `pointclay recover " + path.filename().string() +
                              " -o OUT` and remove it, or choose another name");
}

Journal::Journal(fs::path file) {
    try {
        m_path = file.empty() ? defaultPath() : fs::absolute(file);
        const fs::file_status found = fs::symlink_status(m_path);
        if (fs::exists(found) && !fs::is_regular_file(found)) // it would be replaced
            throw base::Error("a journal must be a file of its own, not a link, folder or device", m_path.string(),
                              "choose another name");
        m_file = hold(m_path);
        if (m_file < 0)
            throw base::Error("another process writes its journal here", m_path.string(), "choose another file");
        refuseOthers(m_path);
        removeUnfinished(m_path);
        begin({});
    } catch (const std::system_error& error) {
        closeFile(m_file);
        throw base::Error("cannot write the journal: " + error.code().message(), m_path.string(),
                          "name a writable file with --journal");
    } catch (...) {
        closeFile(m_file);
        throw;
    }
}

Journal::~Journal() {
    closeFile(m_file);
}

/// Puts a new file of these lines in the place of the old one, whose lock is held until then.
void Journal::begin(const std::string& lines) {
    const std::string content = marked(lines);
    closeFile(std::exchange(m_file, replaceDurably(m_path, content)));
    m_size = content.size();
    base::syncFolder(m_path.parent_path());
}

void Journal::append(const std::string& lines) {
    cutOff(m_file, m_size); // half a line of an attempt that failed
    appendDurably(m_file, lines);
    m_size += lines.size();
}

/// False where the disk refuses, which is told where it is news.
template <class Work>
bool Journal::attempted(Context& context, const Work& work) {
    try {
        work();
        return true;
    } catch (const std::system_error& error) {
        if (!std::exchange(m_refused, true))
            context.messages.push_back(m_path.string() + ": the journal cannot be written (" + error.code().message() +
                                       "); save often, a crash would lose what is not saved");
        return false;
    }
}

void Journal::write(const std::string& line, bool first, Context& context) {
    m_waiting = first ? line : m_waiting + line;
    m_anew |= first;
    if (!attempted(context, [&] { m_anew ? begin(m_waiting) : append(m_waiting); }))
        return;
    m_waiting.clear();
    m_anew = false;
    if (std::exchange(m_refused, false))
        context.messages.push_back(m_path.string() + ": the journal is written again and holds everything");
}

void Journal::record(const json& complete, Context& context) {
    const std::string op = complete.at("op").get<std::string>();
    const bool first = command(op).startsModel;
    m_untilModel &= !first;
    if (m_discarded || m_untilModel)
        return;
    json line = complete;
    if (first) {
        m_source.clear();
        m_others.clear();
    }
    if (op == "open" && !context.instead) // what stands for another command has it
        line["hash"] = context.document.hash().text();
    attempted(context, [&] { keepAgain(line, first); });
    attempted(context, [&] { keepStamp(line); });
    for (const std::string& file : filesRead(line))
        if (first)
            m_source = file;
        else
            m_others.emplace_back(file);
    write(lineOf(std::move(line)), first, context);
}

void Journal::opened(Context& context) {
    if (!m_discarded && !m_untilModel)
        write(std::string(openedLine) + "\n", false, context);
}

/// Copies a file that a line reads, the `first` or another one, to this journal's side.
fs::path Journal::kept(const fs::path& source, bool first) {
    fs::path out = keptSource(m_path, source);
    for (int k = 2; !first && (k == 2 || fs::exists(out)); ++k)
        out = m_path.string() + ".source-" + std::to_string(k) + source.extension().string();
    copyDurably(source, out);
    return out;
}

/// What a journal kept that is being recovered, and that may go.
void Journal::keepAgain(json& line, bool first) {
    const std::vector<std::string> named = filesNamed(line), read = filesRead(line);
    for (std::size_t k = 0; k < named.size(); ++k)
        if (read[k] != named[k])
            readInstead(line, k, kept(read[k], first).string());
}

/// Copies the image that a stroke presses in to this journal's side, under a name made of its content.
void Journal::keepStamp(json& stroke) {
    const auto stamp = stroke.find("stamp");
    if (stamp == stroke.end() || !stamp->is_string() || stamp->get_ref<const std::string&>().empty())
        return;
    const fs::path image = stamp->get<std::string>();
    const std::string content = contentOf(image);
    if (content.empty())
        return; // gone meanwhile
    const fs::path kept = m_path.string() + ".stamp-" + hashOf(content) + image.extension().string();
    if (!fs::exists(kept))
        closeFile(replaceDurably(kept, content));
    stroke["stamp"] = kept.string();
}

/// One file under two names; false where one of them is none.
static bool isSame(const fs::path& a, const fs::path& b) {
    std::error_code none;
    return fs::equivalent(a, b, none);
}

bool Journal::reads(const fs::path& target) const {
    return isSame(m_source, target) ||
           std::any_of(m_others.begin(), m_others.end(), [&](const fs::path& each) { return isSame(each, target); });
}

void Journal::keepSource(const fs::path& target, Context& context) {
    if (m_discarded || m_untilModel || !reads(target))
        return;
    const bool first = isSame(m_source, target);
    const bool done = attempted(context, [&] {
        std::istringstream lines(m_anew ? m_waiting : contentOf(m_path).substr(0, m_size) + m_waiting);
        fs::path copy;
        std::string content;
        for (std::string line; std::getline(lines, line); content += line + "\n") {
            if (line.starts_with('#'))
                continue;
            json command = jsonOf(line);
            const std::vector<std::string> files = filesRead(command);
            for (std::size_t k = 0; k < files.size(); ++k)
                if (isSame(files[k], target)) {
                    if (copy.empty())
                        copy = kept(files[k], first);
                    readInstead(command, k, copy.string());
                    line = textOf(command);
                }
        }
        begin(content);
        m_waiting.clear();
        m_anew = false;
        if (first)
            m_source = copy;
        for (fs::path& each : m_others)
            if (isSame(each, target))
                each = copy;
    });
    m_untilModel = first && !done;
}

/// Copies files that begin like `own` to the side of `target` and names the copies in their place.
static void copyBeside(json& files, const std::string& own, const fs::path& target) {
    if (files.is_array())
        for (json& each : files)
            copyBeside(each, own, target);
    if (!files.is_string() || !files.get_ref<const std::string&>().starts_with(own))
        return;
    const std::string file = files.get<std::string>();
    const fs::path beside = fs::absolute(target).string() + "." + file.substr(own.size());
    try {
        copyDurably(file, beside);
    } catch (const std::system_error& error) {
        throw base::Error("cannot be copied beside the session: " + error.code().message(), file,
                          "choose a folder with room that can be written to");
    }
    files = beside.string();
}

void Journal::copyTo(const fs::path& target) const {
    if (m_discarded || m_untilModel)
        throw base::Error("cannot be written", target.string(), "nothing was recorded of this model");
    std::error_code unequal;
    if (fs::equivalent(target, m_path, unequal))
        throw base::Error("is the journal of this session, which the copy would replace", target.string(),
                          "choose another name");
    std::istringstream lines(m_anew ? m_waiting : contentOf(m_path).substr(0, m_size) + m_waiting);
    std::string out;
    const std::string own = m_path.string() + ".";
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#'))
            continue;
        json command = jsonOf(line);
        for (const char* key : {"source", "sources", "stamp"})
            if (command.contains(key))
                copyBeside(command[key], own, target);
        out += lineOf(std::move(command));
    }
    io::writeFile(target, out);
}

void Journal::end(Context& context) {
    const bool empty = m_size == 0 && m_waiting.empty();
    if (!m_discarded && !m_untilModel && !empty)
        write(std::string(endLine), false, context);
}

void Journal::discard() {
    m_discarded = true;
    closeFile(std::exchange(m_file, -1));
    removeJournal(m_path);
}

} // namespace session
