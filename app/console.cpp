#include "app/console.h"

#include <csignal>
#include <cstdio>
#include <unistd.h>

namespace app {

/// Set by the signal handler, which can reach nothing else.
static std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

static void onInterrupt(int signal) {
    interrupted.store(true, std::memory_order_relaxed);
    std::signal(signal, SIG_DFL); // a second one ends the process
}

const std::atomic<bool>& catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onInterrupt;       // without SA_RESTART: who waits for a pipe sees the flag
    ::sigaction(SIGINT, &action, nullptr); // even where a shell has it ignored for what runs in the background
    ::sigaction(SIGTERM, &action, nullptr);
    struct sigaction before {};
    ::sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) // by nohup
        ::sigaction(SIGHUP, &action, nullptr);
    std::signal(SIGXFSZ, SIG_IGN); // a limit on file sizes is an error of writing, told as such
    return interrupted;
}

Console::Console(bool quiet) : m_quiet(quiet), m_terminal(::isatty(STDERR_FILENO) == 1) {}

Console::~Console() {
    clear();
}

base::Progress Console::progress() {
    base::Progress out{{}, &interrupted};
    if (m_terminal && !m_quiet)
        out.report = [this](double done, std::string_view what) { show(done, what); };
    return out;
}

void Console::show(double done, std::string_view what) {
    const std::lock_guard lock(m_mutex);
    const auto now = std::chrono::steady_clock::now();
    if (now - m_last < std::chrono::milliseconds(100))
        return;
    m_last = now;
    m_shown = true;
    std::fprintf(stderr, "\r\033[K%3d %%  %.*s", static_cast<int>(100 * done), static_cast<int>(what.size()),
                 what.data());
    std::fflush(stderr);
}

void Console::clear() {
    const std::lock_guard lock(m_mutex);
    if (m_shown)
        std::fputs("\r\033[K", stderr);
    m_shown = false;
}

void Console::tell(const std::string& message) {
    clear();
    if (!m_quiet)
        std::fprintf(stderr, "%s\n", message.c_str());
}

void Console::tell(const std::vector<std::string>& messages) {
    for (const std::string& message : messages)
        tell(message);
}

} // namespace app
