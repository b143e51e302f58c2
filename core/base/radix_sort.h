// Stable radix sort by the lowest bits of integer keys, in parallel: the same order at any thread count.
#pragma once

#include "core/base/parallel.h"

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace base {

/// Sorts by the lowest `bits` bits of keyOf(item) and keeps the order of equal ones. Digits that all items share cost
/// one look. `Items`: std::vector, base::LargeArray. REQUIRES: fewer than 2^32 items.
template <class Items, class KeyOf>
void radixSort(Items& items, int bits, const KeyOf& keyOf) {
    using Item = std::remove_cvref_t<decltype(items[0])>;
    constexpr int digitBits = 11;
    constexpr std::size_t digits = std::size_t(1) << digitBits, grain = std::size_t(1) << 16;
    using Counts = std::array<std::uint32_t, digits>;
    std::vector<Counts> counts(chunkCount(items.size(), grain));
    Items other(items.size());
    for (int shift = 0; shift < bits; shift += digitBits) {
        const auto digit = [&](const Item& item) {
            return static_cast<std::size_t>(static_cast<std::uint64_t>(keyOf(item)) >> shift & (digits - 1));
        };
        parallelChunks(items.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            counts[chunk].fill(0);
            for (std::size_t i = begin; i < end; ++i)
                ++counts[chunk][digit(items[i])];
        });
        std::uint32_t sum = 0;
        bool oneDigit = false;
        for (std::size_t d = 0; d < digits; ++d) {
            const std::uint32_t before = sum;
            for (Counts& each : counts)
                sum += std::exchange(each[d], sum);
            oneDigit |= sum - before == items.size();
        }
        if (oneDigit)
            continue;
        parallelChunks(items.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t i = begin; i < end; ++i)
                other[counts[chunk][digit(items[i])]++] = items[i];
        });
        std::swap(items, other);
    }
}

} // namespace base
