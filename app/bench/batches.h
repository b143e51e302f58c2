// Takes a list in equal parts, round and round.
#pragma once

#include <algorithm>
#include <span>

namespace bench {

template <class T>
class Batches {
  public:
    /// REQUIRES: a list that is not empty and outlives this.
    Batches(std::span<const T> all, std::size_t size) : m_all(all), m_size(std::min(size, all.size())) {}

    std::size_t size() const { return m_size; }
    std::span<const T> next() {
        if (m_at + m_size > m_all.size())
            m_at = 0;
        m_at += m_size;
        return m_all.subspan(m_at - m_size, m_size);
    }

  private:
    std::span<const T> m_all;
    std::size_t m_size, m_at = 0;
};

} // namespace bench
