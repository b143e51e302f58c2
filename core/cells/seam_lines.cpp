#include "core/cells/seam_lines.h"

#include "core/base/parallel.h"
#include "core/cells/cell_source.h"
#include "core/cells/feet.h"
#include "core/cells/meeting_ends.h"
#include "core/cells/seams.h"
#include "core/complexes/cell_frame.h"
#include "core/complexes/curve_trace.h"

#include <algorithm>
#include <set>

namespace cells {

using base::Vec3d;

double SeamLine::length() const {
    double out = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        out += base::distance(points[i - 1].position, points[i].position);
    return out;
}

/// `standsOut`: does the edge, rather than being a groove?
static SeamPoint pointOf(const Vec3d& x, const Vec3d& a, const Vec3d& b, bool standsOut, double unit) {
    const double turn = std::atan2(length(cross(a, b)), dot(a, b)) * 57.29577951308232;
    return {x, normalized(a + b), standsOut ? turn : -turn, unit};
}

static std::vector<SeamLine> ofCells(const CellSurface& surface, const base::Progress& progress) {
    const std::vector<Seam> seams = traceSeams(surface, progress);
    std::vector<SeamLine> out(seams.size());
    base::parallelFor(seams.size(), 1, [&](std::size_t s) {
        CellSource source(surface);
        out[s] = {seams[s].a, seams[s].b, {}, seams[s].closed};
        for (const Vec3d& x : seams[s].points) {
            source.moveTo(x);
            const std::size_t a = source.find(seams[s].a), b = source.find(seams[s].b);
            if (a == CellSource::none || b == CellSource::none)
                continue;
            const bool standsOut = source.meeting(a, b) != Meeting::Concave;
            const surface::Evaluationd first = source.at(a, surface::Need::Gradient),
                                       second = source.at(b, surface::Need::Gradient);
            out[s].points.push_back(
                pointOf(x, normalized(first.gradient), normalized(second.gradient), standsOut, first.unit));
        }
    });
    return out;
}

/// Marching ends a little before a corner. Where three lines and more do, all get the corner itself as their end.
static void joinAtCorners(const CellSurface& surface, std::vector<SeamLine>& lines) {
    std::vector<SeamEnd> ends;
    std::vector<std::size_t> lineOf; // of two ends each, its front and its back
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!lines[i].closed && lines[i].points.size() > 1) {
            for (const SeamPoint& end : {lines[i].points.front(), lines[i].points.back()})
                ends.push_back({end.position, surface::spacingOfUnit * end.unit});
            lineOf.push_back(i);
        }
    for (const MeetingEnds& here : meetingEnds(ends)) {
        std::set<std::uint32_t> meeting;
        for (const std::uint32_t k : here.ends)
            meeting.insert({lines[lineOf[k / 2]].a, lines[lineOf[k / 2]].b});
        const std::vector<std::uint32_t> which(meeting.begin(), meeting.end());
        CellSource source(surface);
        source.moveTo(here.middle);
        const std::optional<Vec3d> found =
            which.size() < 3 ? std::nullopt : Feet(source, here.middle, {}).corner(which, here.middle);
        const double reach = ends[here.ends.front()].reach;
        const Vec3d corner = found && base::distance(*found, here.middle) < reach ? *found : here.middle;
        for (const std::uint32_t k : here.ends) {
            std::vector<SeamPoint>& points = lines[lineOf[k / 2]].points;
            const bool front = k % 2 == 0;
            SeamPoint end = front ? points.front() : points.back();
            end.position = corner;
            points.insert(front ? points.begin() : points.end(), end);
        }
    }
}

static std::vector<SeamLine> ofComplex(const complexes::Complex& complex) {
    std::vector<std::vector<std::uint32_t>> patchesOf(complex.cells().size()); // of curves
    for (std::uint32_t c = 0; c < complex.cells().size(); ++c)
        if (complex[c].dimension == 2)
            for (const std::uint32_t curve : complex[c].boundary)
                patchesOf[curve].push_back(c);
    std::vector<SeamLine> out;
    for (std::uint32_t curve = 0; curve < complex.cells().size(); ++curve) {
        const std::vector<std::uint32_t>& patches = patchesOf[curve];
        if (patches.size() < 2) // where it ends, or a curve of its own
            continue;
        const complexes::TracedCurve traced = trace(complex, curve);
        SeamLine line{patches.front(), patches.back(), {}, traced.closed};
        for (const Vec3d& x : traced.points) {
            const complexes::CellFrame a = frameOf(complex, line.a, x), b = frameOf(complex, line.b, x, a.axis);
            const bool standsOut = dot(a.axis - b.axis, b.ownCentre - a.ownCentre) < 0;
            line.points.push_back(pointOf(x, a.axis, b.axis, standsOut, a.unit));
        }
        out.push_back(std::move(line));
    }
    return out;
}

std::vector<SeamLine> seamLines(const surface::Surface& surface, const base::Progress& progress) {
    std::vector<SeamLine> out;
    if (const auto complex = complexes::Complex::of(surface))
        out = ofComplex(*complex);
    else if (const auto byCells = CellSurface::of(surface))
        out = ofCells(*byCells, progress), joinAtCorners(*byCells, out);
    std::erase_if(out, [](const SeamLine& line) { return line.points.size() < 2; });
    std::stable_sort(out.begin(), out.end(),
                     [](const SeamLine& a, const SeamLine& b) { return a.length() > b.length(); });
    return out;
}

} // namespace cells
