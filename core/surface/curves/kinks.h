// Where traced curves turn at once, and no step leads on: samples with noise, and corners of rims, make such places.
// Both ways there end beside it, or a little beyond, past each other. Internal to the room.
//
// A Point has position, normal and unit (h).
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace surface {

/// How many points of the curve that ends, and of the one that begins, come up to where both meet; the others lie past
/// it.
struct Kink {
    std::size_t upTo = 0; ///< the curve that ends keeps its first so many points
    std::size_t from = 0; ///< the one that begins keeps those from this one on
    double apart = 0;     ///< how far its points are apart there, in units of h
};

namespace kinks {
constexpr double past = 0.5; ///< in units of h: how far they may lead past each other

/// How many of the curve's points, from one end, are within `past` of it all along.
template <class Point>
std::size_t tailOf(const std::vector<Point>& points, bool end) {
    const Point& last = end ? points.back() : points.front();
    std::size_t n = 1;
    while (n < points.size() &&
           distance(points[end ? points.size() - 1 - n : n].position, last.position) < past * last.unit)
        ++n;
    return n;
}
} // namespace kinks

/// Where a curve that ends goes on as one that begins, if it does: the nearest two of the points about both ends, less
/// than `near` apart, in units of h. The two may be one curve, if that leads away from there.
template <class Point>
std::optional<Kink> kinkBetween(const std::vector<Point>& ends, const std::vector<Point>& begins, double near) {
    const Point &last = ends.back(), &first = begins.front();
    if (!(distance(last.position, first.position) < (2 * kinks::past + near) * last.unit))
        return std::nullopt;
    const std::size_t tail = kinks::tailOf(ends, true), head = kinks::tailOf(begins, false);
    if (&ends == &begins && tail + head >= ends.size())
        return std::nullopt;
    std::optional<Kink> out;
    for (std::size_t t = 0; t < tail; ++t)
        for (std::size_t k = 0; k < head; ++k) {
            const Point &a = ends[ends.size() - 1 - t], &b = begins[k];
            const double apart = distance(a.position, b.position) / a.unit;
            if (apart < (out ? out->apart : near) && dot(a.normal, b.normal) > 0.5)
                out = Kink{ends.size() - t, k, apart};
        }
    return out;
}

/// Makes a loop of an open curve whose end goes on as its beginning, without what lies past that. A dot is none.
template <class Point>
bool closeAtAKink(std::vector<Point>& points, double near) {
    constexpr std::size_t fewest = 16;
    const auto kink = points.size() < fewest ? std::nullopt : kinkBetween(points, points, near);
    if (!kink)
        return false;
    points.resize(kink->upTo);
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(kink->from));
    return true;
}

} // namespace surface
