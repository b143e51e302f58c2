// Finds numbered items by 64-bit keys: open addressing over the items' numbers, while the keys stay with the items.
//
//     KeyIndex index;
//     const auto keyOf = [&](std::uint32_t i) { return cells[i].key; };
//     index.add(number, keyOf);                        number: of the new item, whose key no other has
//     index.find(key, keyOf) != KeyIndex::none
//
// Numbers take 4 bytes each, at most half of the table is full, and keys that differ in the lowest three bits alone
// share a line of memory: neighbours where keys are those of cells. What is found does not depend on the hash. Const
// functions may run on any thread.
#pragma once

#include "core/base/random.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace base {

class KeyIndex {
  public:
    static constexpr std::uint32_t none = 0xffffffffu;

    template <class KeyOf>
    std::uint32_t find(std::uint64_t key, const KeyOf& keyOf) const {
        if (m_table.empty())
            return none;
        const std::size_t mask = m_table.size() - 1;
        for (std::size_t slot = home(key) & mask;; slot = (slot + 1) & mask)
            if (m_table[slot] == none || keyOf(m_table[slot]) == key)
                return m_table[slot];
    }

    template <class KeyOf>
    void add(std::uint32_t number, const KeyOf& keyOf) {
        if (2 * (m_count + 1) > m_table.size()) {
            const std::vector<std::uint32_t> old = std::move(m_table);
            reserve(2 * (m_count + 16));
            for (const std::uint32_t each : old)
                if (each != none)
                    place(each, keyOf(each));
        }
        place(number, keyOf(number));
        ++m_count;
    }

    /// Forgets what was there and takes items 0 to count - 1.
    template <class KeyOf>
    void assign(std::uint32_t count, const KeyOf& keyOf) {
        reserve(count + 16);
        for (m_count = 0; m_count < count; ++m_count)
            place(static_cast<std::uint32_t>(m_count), keyOf(static_cast<std::uint32_t>(m_count)));
    }

  private:
    static std::size_t home(std::uint64_t key) { return static_cast<std::size_t>(mix(key >> 3) << 3 | (key & 7)); }
    /// Room for that many, and all of it empty.
    void reserve(std::size_t count) { m_table.assign(std::bit_ceil(4 * count), none); }
    void place(std::uint32_t number, std::uint64_t key) {
        const std::size_t mask = m_table.size() - 1;
        std::size_t slot = home(key) & mask;
        while (m_table[slot] != none)
            slot = (slot + 1) & mask;
        m_table[slot] = number;
    }

    std::vector<std::uint32_t> m_table; ///< a power of two
    std::size_t m_count = 0;
};

} // namespace base
