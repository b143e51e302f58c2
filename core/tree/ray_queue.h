// The priority queue of a walk along a ray: what the ray enters next comes out first.
//
// A binary heap in fixed storage; only a ray through more than `inlineEntries` open bounds at once allocates.
// Of equal entries the one pushed first comes out first, so that the walk is the same everywhere.
#pragma once

#include "core/tree/node.h"

#include <algorithm>
#include <vector>

namespace tree {

class RayQueue {
  public:
    struct Entry {
        float enter, leave;
        const Node* node;                 ///< a node to open, or
        const surfel::SurfelBlock* block; ///< a block to open, or with cluster >= 0
        int cluster;                      ///< a cluster to report
        std::uint32_t sequence;           ///< order of pushing
    };

    bool empty() const { return m_count == 0; }

    void push(Entry entry) {
        entry.sequence = m_pushed++;
        if (m_count == m_capacity)
            grow();
        m_entries[m_count++] = entry;
        std::push_heap(m_entries, m_entries + m_count, later);
    }

    /// REQUIRES: not empty.
    Entry pop() {
        std::pop_heap(m_entries, m_entries + m_count, later);
        return m_entries[--m_count];
    }

    RayQueue() = default;
    RayQueue(const RayQueue&) = delete;
    RayQueue& operator=(const RayQueue&) = delete;

  private:
    static constexpr std::size_t inlineEntries = 128;

    static bool later(const Entry& a, const Entry& b) {
        return a.enter != b.enter ? a.enter > b.enter : a.sequence > b.sequence;
    }
    void grow() {
        std::vector<Entry> larger(2 * m_capacity);
        std::copy(m_entries, m_entries + m_count, larger.begin());
        m_overflow.swap(larger);
        m_entries = m_overflow.data();
        m_capacity = m_overflow.size();
    }

    Entry m_inline[inlineEntries];
    std::vector<Entry> m_overflow;
    Entry* m_entries = m_inline;
    std::size_t m_capacity = inlineEntries, m_count = 0;
    std::uint32_t m_pushed = 0;
};

} // namespace tree
