// The newest value from one thread to another, without locks: three slots, one for each side and one in between, which
// either side swaps with its own (haptics/README 6.1).
//
//     writer: mailbox.put(value)      never waits; what nobody took is replaced
//     reader: mailbox.take()          the newest value, or null where there is none since the last time
//
// Values are destroyed by the writer alone, so that a reader with deadlines never frees memory.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <utility>

namespace haptics {

template <class T>
class Mailbox {
  public:
    /// Writer's thread.
    void put(T value) {
        m_slots[m_writing] = std::move(value);
        m_writing = m_between.exchange(m_writing | fresh, std::memory_order_acq_rel) & slot;
    }
    /// Reader's thread; valid until the next call.
    const T* take() {
        if (!(m_between.load(std::memory_order_relaxed) & fresh))
            return nullptr;
        m_reading = m_between.exchange(m_reading, std::memory_order_acq_rel) & slot;
        return &*m_slots[m_reading];
    }

  private:
    static constexpr unsigned slot = 3, fresh = 4;
    std::array<std::optional<T>, 3> m_slots;
    std::atomic<unsigned> m_between = 1;
    unsigned m_writing = 0, m_reading = 2;
};

} // namespace haptics
