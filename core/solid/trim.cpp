#include "core/solid/trim.h"

#include "core/base/error.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/cap_rims.h"
#include "core/solid/outline_walls.h"

#include <algorithm>
#include <cmath>

namespace solid {

using base::Point2;

Combined trimmed(const surface::Surface& model, const OutlineSide& side, Trim trim, const CutOptions& options,
                 const base::Progress& progress) {
    const int gone = trim == Trim::Away ? -1 : 1;
    const std::vector<std::int8_t> sides = sidesOf(model.tree(), side);
    const auto inside = std::ranges::count_if(sides, [](std::int8_t s) { return s < 0; }),
               outside = std::ssize(sides) - inside;
    constexpr auto few = 4;
    if (inside < (trim == Trim::Keep ? few : 1))
        throw base::Error("the outline holds no points of the model", "trim",
                          "draw it over the model, larger than the points are apart");
    if (outside < (trim == Trim::Keep ? 1 : few))
        throw base::Error(trim == Trim::Keep ? "there is nothing to trim away" : "nothing would be left", "trim",
                          "draw a smaller outline");
    if (!options.cap)
        return leftOpen(model, sides, gone, progress);
    return endingAsBefore(model, side, -gone,
                          combine(model, {side, wallsOf(side, model), sides},
                                  trim == Trim::Away ? Operation::Difference : Operation::Intersection,
                                  {options.creases}, process::part(progress, 0, 0.8)),
                          process::part(progress, 0.8, 1));
}

/// Douglas and Peucker's way from one corner to another.
static void keepBetween(const std::vector<Point2>& p, std::size_t from, std::size_t to, double tolerance,
                        std::vector<bool>& kept) {
    const auto &a = p[from], &b = p[to % p.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, long2 = dx * dx + dy * dy;
    double most = tolerance;
    std::size_t farthest = from;
    for (std::size_t k = from + 1; k < to; ++k) {
        const double x = p[k].x - a.x, y = p[k].y - a.y;
        const double share = long2 > 0 ? std::clamp((x * dx + y * dy) / long2, 0.0, 1.0) : 0;
        if (const double off = std::hypot(x - share * dx, y - share * dy); off > most)
            most = off, farthest = k;
    }
    if (farthest == from)
        return;
    kept[farthest] = true;
    keepBetween(p, from, farthest, tolerance, kept);
    keepBetween(p, farthest, to, tolerance, kept);
}

std::vector<Point2> plainOutline(const std::vector<Point2>& corners) {
    base::Box3d box;
    for (const Point2& p : corners)
        box.extend(base::Vec3d{p.x, p.y, 0});
    const double tolerance = box.diagonal() / 4000;
    // from the corner that is leftmost, which stays whatever the tolerance
    std::vector<Point2> turned = corners;
    std::ranges::rotate(turned, std::ranges::min_element(turned));
    std::vector<bool> kept(turned.size());
    kept[0] = true;
    keepBetween(turned, 0, turned.size(), tolerance, kept);
    std::vector<Point2> out;
    for (std::size_t k = 0; k < turned.size(); ++k)
        if (kept[k])
            out.push_back(turned[k]);
    return out;
}

} // namespace solid
