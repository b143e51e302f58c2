#include "core/complexes/rims.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/complexes/cell_frame.h"
#include "core/complexes/curve_trace.h"

#include <algorithm>

namespace complexes {

using base::Vec3d;
using surface::BoundaryCurve, surface::BoundaryPoint;

namespace {

/// A curve that bounds one patch; of closed ones both ends are the same point, or none.
struct Rim {
    std::uint32_t curve = 0, patch = 0;
    std::optional<std::uint32_t> begin, end;
    std::vector<BoundaryPoint> points;
    bool used = false;

    bool closed() const { return begin == end; }
};

std::vector<Rim> rimsOf(const Complex& complex) {
    std::vector<std::vector<std::uint32_t>> patches(complex.cells().size());
    for (std::uint32_t c = 0; c < complex.cells().size(); ++c)
        if (complex[c].dimension == 2)
            for (const std::uint32_t curve : complex[c].boundary)
                patches[curve].push_back(c);
    std::vector<Rim> out;
    for (std::uint32_t curve = 0; curve < complex.cells().size(); ++curve)
        if (patches[curve].size() == 1) {
            Rim rim{curve, patches[curve].front(), {}, {}, {}, false};
            if (const std::vector<std::uint32_t>& ends = complex[curve].boundary; !ends.empty())
                rim.begin = ends.front(), rim.end = ends.back();
            out.push_back(std::move(rim));
        }
    return out;
}

/// Across the curve, to the side that the patch's own points are not on.
std::vector<BoundaryPoint> pointsOf(const Complex& complex, const Rim& rim) {
    const std::vector<Vec3d> places = trace(complex, rim.curve).points;
    std::vector<BoundaryPoint> out;
    Vec3d side;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec3d way = places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0];
        const CellFrame frame = frameOf(complex, rim.patch, places[i], side);
        Vec3d outward = base::normalized(cross(way, frame.axis));
        if (dot(outward, frame.ownCentre - places[i]) > 0)
            outward = -outward;
        side = frame.axis;
        out.push_back({places[i], frame.axis, outward, frame.unit});
    }
    return out;
}

/// What goes on at a point: of the same patch if there is one. Turned so that it begins there.
Rim* next(std::vector<Rim>& rims, std::uint32_t patch, std::uint32_t at) {
    Rim* out = nullptr;
    for (Rim& rim : rims)
        if (!rim.used && !rim.closed() && (rim.begin == at || rim.end == at))
            if (!out || (out->patch != patch && rim.patch == patch))
                out = &rim;
    if (out && out->begin != at) {
        std::swap(out->begin, out->end);
        std::reverse(out->points.begin(), out->points.end());
    }
    return out;
}

BoundaryCurve joined(std::vector<Rim>& rims, Rim& first) {
    BoundaryCurve out{first.points, first.closed(), 0};
    first.used = true;
    for (std::optional<std::uint32_t> at = first.end; !out.closed;) {
        Rim* more = next(rims, first.patch, *at);
        if (!more)
            return out;
        more->used = true;
        out.points.insert(out.points.end(), more->points.begin(), more->points.end());
        at = more->end;
        out.closed = at == first.begin;
    }
    if (!first.begin)
        out.points.pop_back(); // the first one again
    return out;
}

} // namespace

std::vector<BoundaryCurve> findRims(const Complex& complex, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    std::vector<Rim> rims = rimsOf(complex);
    base::parallelFor(rims.size(), 1, [&](std::size_t i) { rims[i].points = pointsOf(complex, rims[i]); });
    std::vector<BoundaryCurve> out;
    for (Rim& rim : rims)
        if (!rim.used)
            out.push_back(joined(rims, rim));
    std::stable_sort(out.begin(), out.end(),
                     [](const BoundaryCurve& a, const BoundaryCurve& b) { return a.length() > b.length(); });
    return out;
}

} // namespace complexes
