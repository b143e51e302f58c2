// A median of the last differences, kept in five sorted numbers; one at alternating ends goes when a new one comes
// (LASzip's predictor of coordinates).
#pragma once

#include <cstdint>

namespace io::laz {

class StreamingMedian {
  public:
    std::int32_t value() const { return m_sorted[2]; }
    void add(std::int32_t v) {
        if (m_dropsHigh && v < m_sorted[2]) {
            insert(v, 0, 4);
        } else if (m_dropsHigh) {
            insert(v, 3, 4);
            m_dropsHigh = false;
        } else if (m_sorted[2] < v) {
            insertFromAbove(v, 4, 0);
        } else {
            insertFromAbove(v, 1, 0);
            m_dropsHigh = true;
        }
    }

  private:
    /// Puts v among [first, last], the largest of which goes.
    void insert(std::int32_t v, int first, int last) {
        int at = last;
        while (at > first && v < m_sorted[at - 1]) {
            m_sorted[at] = m_sorted[at - 1];
            --at;
        }
        m_sorted[at] = v;
    }
    /// Puts v among [first, last], the smallest of which goes.
    void insertFromAbove(std::int32_t v, int last, int first) {
        int at = first;
        while (at < last && m_sorted[at + 1] < v) {
            m_sorted[at] = m_sorted[at + 1];
            ++at;
        }
        m_sorted[at] = v;
    }

    std::int32_t m_sorted[5] = {};
    bool m_dropsHigh = true;
};

} // namespace io::laz
