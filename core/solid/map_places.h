// Places all over a rectangle that maps a surface, about as far apart as is asked there (solid/README 2.4).
//
// A map has corners `lo` and `hi`, and tells of its places u, v: `unit(v)`, model units to one of u (one of v is one),
// and `spacing(u, v)`, in model units.
#pragma once

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/outline.h"
#include "core/solid/hexagonal.h"

#include <cmath>
#include <vector>

namespace solid {

/// A hexagonal layout, half a row from the sides.
template <class Map, class Fn>
void forHexagonalPlaces(const Map& map, double spacing, const Fn& place) {
    const double wide = map.hi.x - map.lo.x, high = map.hi.y - map.lo.y;
    const auto fitting = [](double length, double step) {
        return static_cast<int>(std::max(1.0, std::round(length / step)));
    };
    const int rows = fitting(high, rowStep * spacing);
    for (int row = 0; row < rows; ++row) {
        base::CancelScope::check();
        const double v = map.lo.y + high * (row + 0.5) / rows;
        const int count = fitting(wide * map.unit(v), alongStep * spacing);
        for (int k = 0; k < count; ++k)
            place(map.lo.x + wide * (k + 0.25 + 0.5 * (row & 1)) / count, v, spacing);
    }
}

/// Rectangles halved across their longer side until that is no longer than the spacing about their middles.
template <class Map, class Fn>
void forHalvedPlaces(const Map& map, const Fn& place) {
    struct Rectangle {
        double u, v, wide, high;
    };
    std::vector<Rectangle> open{
        {0.5 * (map.lo.x + map.hi.x), 0.5 * (map.lo.y + map.hi.y), map.hi.x - map.lo.x, map.hi.y - map.lo.y}};
    while (!open.empty()) {
        const Rectangle at = open.back();
        open.pop_back();
        base::CancelScope::check();
        const double spacing = map.spacing(at.u, at.v), wide = at.wide * map.unit(at.v);
        // what is a side of 1.4 at most is one of 0.7 at least: as dense in the mean
        if (std::max(wide, at.high) <= 1.4 * spacing) {
            place(at.u, at.v, spacing);
            continue;
        }
        for (const double part : {-0.25, 0.25}) {
            if (wide > at.high)
                open.push_back({at.u + part * at.wide, at.v, 0.5 * at.wide, at.high});
            else
                open.push_back({at.u, at.v + part * at.high, at.wide, 0.5 * at.high});
        }
    }
}

/// Might places, `least` apart, be more than 20 million?
template <class Map>
bool areTooMany(const Map& map, double least) {
    constexpr double mostPlaces = 2e7;
    const double area =
        (map.hi.x - map.lo.x) * std::max(map.unit(map.lo.y), map.unit(map.hi.y)) * (map.hi.y - map.lo.y);
    return !(area < mostPlaces * least * least);
}

/// place(u, v, spacing) for each; spacings are between `least` and `most`. Throws base::Error where places are too
/// many.
template <class Map, class Fn>
void forPlaces(const Map& map, double least, double most, const Fn& place) {
    if (areTooMany(map, least))
        throw base::Error("what closes the cut would have too many points, as dense as the model is there", "",
                          "resample the model with a larger spacing");
    if (most < 1.25 * least)
        forHexagonalPlaces(map, std::sqrt(least * most), place);
    else
        forHalvedPlaces(map, place);
}

} // namespace solid
