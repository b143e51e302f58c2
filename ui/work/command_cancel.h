// Which command is to stop. Commands are counted from 1 in the order asked; one may be cancelled while it still waits,
// and a cancel that comes after its command has ended stops no other.
//
// Threads: any; what runs looks at the flag.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>

namespace ui {

class CommandCancel {
  public:
    /// On the thread that works: command `number` begins.
    void begin(std::uint64_t number) {
        const std::lock_guard lock(m_mutex);
        m_running = number;
        m_flag = m_closed || m_cancelled >= number;
    }
    /// Command `number` stops, or will not run; those before it are done.
    void cancel(std::uint64_t number) {
        const std::lock_guard lock(m_mutex);
        m_cancelled = std::max(m_cancelled, number);
        if (m_running == number)
            m_flag = true;
    }
    /// All stop, and those to come.
    void close() {
        const std::lock_guard lock(m_mutex);
        m_flag = m_closed = true;
    }
    bool closed() const { return m_closed; }
    const std::atomic<bool>& flag() const { return m_flag; }

  private:
    std::mutex m_mutex;
    std::atomic<bool> m_flag = false, m_closed = false;
    std::uint64_t m_running = 0, m_cancelled = 0;
};

} // namespace ui
