// Takes a list in equal parts, each as it stands, the parts in an order that hops all over the list: whatever part of
// the list a measurement gets through is like the whole.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>

namespace bench {

template <class T>
class Batches {
  public:
    /// REQUIRES: a list that is not empty and outlives this.
    Batches(std::span<const T> all, std::size_t size)
        : m_all(all), m_size(std::min(size, all.size())), m_count(all.size() / m_size), m_hop(hopOf(m_count)) {}

    std::size_t size() const { return m_size; }
    std::span<const T> next() {
        const std::size_t at = m_at;
        m_at = (m_at + m_hop) % m_count;
        return m_all.subspan(at * m_size, m_size);
    }

  private:
    /// About the golden section of the list, and all parts before one comes again.
    static std::size_t hopOf(std::size_t count) {
        std::size_t hop = std::max<std::size_t>(1, count * 618 / 1000);
        while (std::gcd(hop, count) != 1)
            ++hop;
        return hop;
    }
    std::span<const T> m_all;
    std::size_t m_size, m_count, m_hop, m_at = 0;
};

} // namespace bench
