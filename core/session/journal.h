// The journal: the session written while it happens, so that a crash loses at most the command in progress.
//
// A journal is a session file (session_file.h). A command is written when it has completed, as one whole line that is
// on the disk before the next command runs; a line torn by a crash has no newline and is ignored. Since `open` and
// `new` replace the document, each of them begins the file anew; `open` carries an absolute path and the content hash,
// so that recovery notices a file that has changed meanwhile. Before a save writes over a file that a line reads, the
// one that the journal begins with (`keptSource`) or another model's, that file is kept beside the journal and the line
// reads the copy. Images that brushes press in are kept the same way, by their content.
//
// A disk that refuses is told once. What it refused is kept in memory and written with the next command that finds
// room.
//
// While a process lives it holds a lock on its journal, which dies with it, even by kill -9: a journal without a lock
// was left behind (recover.h). Its first line has a mark that says what it is: a file that exists and is no journal is
// never written over, nor is a journal that did not come to its end.
//
// Ownership: the file stays when a Journal is destroyed; `discard` removes it, which is what a normal exit does.
// Threads: one at a time.
#pragma once

#include "core/session/command.h"

namespace session {

class Journal {
  public:
    /// A journal at `file`, replacing what was there; empty: journal-PID.jsonl in stateFolder(). Throws base::Error
    /// where it cannot be written, another process holds it, the file is something else, or it holds commands of a
    /// session that was not ended.
    explicit Journal(std::filesystem::path file = {});
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    /// Writes a completed command. That the disk refuses, and that it takes the journal again, is said in the context's
    /// messages.
    void record(const nlohmann::json& complete, Context& context);
    /// What was recorded so far is what opening has done: nobody loses anything if it is all there is.
    void opened(Context& context);
    /// To be called before `target` is written over.
    void keepSource(const std::filesystem::path& target, Context& context);
    /// All that it holds as a session that stands alone: what was kept beside the journal is copied beside the target.
    /// Throws base::Error where it cannot be written, or what the journal begins with is lost.
    void copyTo(const std::filesystem::path& target) const;
    /// To be called when nothing can be lost any more: another journal may then take the place of this one, which can
    /// be recovered until it does.
    void end(Context& context);
    /// Removes the file and what was kept beside it. Nothing is recorded afterwards.
    void discard();

  private:
    void begin(const std::string& lines);
    void append(const std::string& lines);
    void write(const std::string& line, bool first, Context& context);
    std::filesystem::path kept(const std::filesystem::path& source, bool first);
    void keepAgain(nlohmann::json& line, bool first);
    bool reads(const std::filesystem::path& target) const;
    void keepStamp(nlohmann::json& stroke);
    template <class Work>
    bool attempted(Context& context, const Work& work);

    std::filesystem::path m_path;
    std::filesystem::path m_source;              ///< the file that the first line opens; empty for none
    std::vector<std::filesystem::path> m_others; ///< that further lines read
    int m_file = -1;
    std::uint64_t m_size = 0;  ///< bytes of the file that are whole lines
    std::string m_waiting;     ///< lines that the disk has not taken yet
    bool m_anew = false;       ///< they begin the file anew
    bool m_refused = false;    ///< the disk has, and that was told
    bool m_untilModel = false; ///< what the journal begins with is lost: nothing to record before the next model
    bool m_discarded = false;
};

/// $XDG_STATE_HOME/pointclay, else ~/.local/state/pointclay.
std::filesystem::path stateFolder();
/// Where `journal` keeps a source file with the extension of `source`.
std::filesystem::path keptSource(const std::filesystem::path& journal, const std::filesystem::path& source);
/// Removes a journal and what it kept. Nothing happens where there is none.
void removeJournal(const std::filesystem::path& journal);
/// True where a living process holds the journal.
bool isJournalHeld(const std::filesystem::path& journal);
/// Removes what killed processes have left of journals in `folder` that they had not finished or no longer have.
void removeLeftovers(const std::filesystem::path& folder);

} // namespace session
