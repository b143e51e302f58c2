// Sorting in parallel: the same order at any thread count, and it stops with its cancel scope.
#pragma once

#include "core/base/parallel.h"

#include <algorithm>
#include <vector>

namespace base {

/// REQUIRES: `less` is a strict total order: of two items one is less than the other, or they are alike in every way.
template <class Item, class Less>
void parallelSort(std::vector<Item>& items, const Less& less) {
    constexpr std::size_t grain = std::size_t(1) << 14;
    const auto at = [](std::vector<Item>& of, std::size_t i) { return of.begin() + static_cast<std::ptrdiff_t>(i); };
    parallelChunks(items.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::sort(at(items, begin), at(items, end), less);
    });
    std::vector<Item> other(items.size() > grain ? items.size() : 0);
    for (std::size_t width = grain; width < items.size(); width *= 2) {
        parallelChunks(items.size(), 2 * width, [&](std::size_t begin, std::size_t end, std::size_t) {
            const auto middle = at(items, std::min(begin + width, end));
            std::merge(at(items, begin), middle, middle, at(items, end), at(other, begin), less);
        });
        items.swap(other);
    }
}

} // namespace base
