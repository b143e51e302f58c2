// What the program says while it works: progress and messages on stderr, and Ctrl-C as a wish to stop.
//
// Progress is shown only where stderr is a terminal; --quiet silences it and the messages, never errors. Results go to
// stdout or to files and do not pass here. Threads: progress may come from any thread.
#pragma once

#include "core/base/progress.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace app {

class Console {
  public:
    explicit Console(bool quiet);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// To hand down; valid as long as the console. Cancelled by the first Ctrl-C; the second ends the process.
    base::Progress progress();
    void tell(const std::string& message);
    void tell(const std::vector<std::string>& messages);
    /// Takes the progress line away.
    void clear();

  private:
    void show(double done, std::string_view what);

    bool m_quiet;
    bool m_terminal;
    std::mutex m_mutex;
    bool m_shown = false;
    std::chrono::steady_clock::time_point m_last;
};

/// Turns Ctrl-C, SIGTERM and SIGHUP into Console::progress's cancellation; returns the flag that says so.
const std::atomic<bool>& catchInterrupts();

} // namespace app
