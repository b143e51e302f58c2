// Order statistics: which value stands at a place when all are sorted, found in linear time without sorting them.
//
// The values are reordered, which also parts them: none before the place is larger than the one found, none behind it
// smaller. T{} of none. Of equal values each is as good as the other, so the answer depends on the values alone.
#pragma once

#include <algorithm>
#include <functional>
#include <ranges>

namespace base {

/// The value with `rank` others before it; the last one from there on.
template <std::ranges::random_access_range Values, class Less = std::less<>>
std::ranges::range_value_t<Values> ranked(Values&& values, std::size_t rank, Less less = {}) {
    const auto begin = std::ranges::begin(values), end = std::ranges::end(values);
    if (begin == end)
        return {};
    const auto at = begin + std::min(static_cast<std::ptrdiff_t>(rank), end - begin - 1);
    std::nth_element(begin, at, end, less);
    return *at;
}

/// The upper one of two middles.
template <std::ranges::random_access_range Values>
std::ranges::range_value_t<Values> median(Values&& values) {
    return ranked(values, std::ranges::size(values) / 2);
}

/// The value that `share` (0 to 1) of the others do not exceed: 0 the least, 1 the largest; no interpolation.
template <std::ranges::random_access_range Values>
std::ranges::range_value_t<Values> quantile(Values&& values, double share) {
    const std::size_t last = std::max<std::size_t>(std::ranges::size(values), 1) - 1;
    return ranked(values, static_cast<std::size_t>(share * static_cast<double>(last)));
}

} // namespace base
