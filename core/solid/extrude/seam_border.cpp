#include "core/solid/extrude/seam_border.h"

#include "core/base/segment.h"
#include "core/solid/segment_runs.h"

#include <optional>

namespace solid {

using base::Vec3d;

namespace {

struct Piece {
    Vec3d from, to;
    std::size_t line;
};

std::vector<Piece> piecesOf(std::span<const cells::SeamLine> lines) {
    std::vector<Piece> out;
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const auto& points = lines[l].points;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            out.push_back({points[i].position, points[i + 1].position, l});
        if (lines[l].closed && points.size() > 2)
            out.push_back({points.back().position, points.front().position, l});
    }
    return out;
}

/// Of two lines the end that they share, the nearest to a place.
std::optional<Vec3d> sharedEnd(const cells::SeamLine& a, const cells::SeamLine& b, const Vec3d& near, double within) {
    std::optional<Vec3d> out;
    for (const Vec3d& p : {a.points.front().position, a.points.back().position})
        for (const Vec3d& q : {b.points.front().position, b.points.back().position})
            if (distance(p, q) < 1e-3 * within && distance(p, near) < within &&
                (!out || distance(p, near) < distance(*out, near)))
                out = p;
    return out;
}

} // namespace

void layOnto(std::span<const cells::SeamLine> lines, Loop& loop) {
    constexpr double reach = 1.2, ofCorner = 4; // spacings
    constexpr std::size_t none = ~std::size_t(0);
    const std::vector<Piece> pieces = piecesOf(lines);
    if (pieces.empty())
        return;
    std::vector<base::Box3d> boxes(pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k)
        boxes[k].extend(pieces[k].from), boxes[k].extend(pieces[k].to);
    const SegmentRuns runs(boxes);
    std::vector<std::size_t> on(loop.size(), none);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        LoopPoint& p = loop.points[i];
        const auto foot = [&](std::size_t k) {
            return base::nearestOnSegment(pieces[k].from, pieces[k].to, p.position);
        };
        const std::size_t nearest =
            runs.nearest(p.position, [&](std::size_t k) { return distanceSq(foot(k), p.position); });
        if (distance(foot(nearest), p.position) < reach * p.spacing) {
            p.position = foot(nearest);
            on[i] = pieces[nearest].line;
        }
    }
    Loop out = loop;
    out.points.clear();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t j = (i + 1) % loop.size();
        out.points.push_back(loop.points[i]);
        if (on[i] == on[j] || on[i] == none || on[j] == none)
            continue;
        LoopPoint corner = loop.points[i];
        corner.normal = normalized(corner.normal + loop.points[j].normal, corner.normal);
        corner.outward = normalized(corner.outward + loop.points[j].outward, corner.outward);
        if (const auto at = sharedEnd(lines[on[i]], lines[on[j]], corner.position, ofCorner * corner.spacing)) {
            corner.position = *at;
            corner.corner = true;
            out.points.push_back(corner);
        }
    }
    loop = out;
}

} // namespace solid
