#include "core/cells/creases/surface_line.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <cmath>

namespace cells {

using base::Vec3d;

namespace {

constexpr double step = 0.5;       ///< spacings
constexpr double farthest = 4;     ///< spacings of a point from the surface
constexpr double closedWithin = 1; ///< spacings from end to beginning
constexpr double longChord = 4;    ///< spacings: on ways that are shorter there may be an edge
constexpr double mostArch = 0.3;   ///< of a longer chord: what its middle may be off the surface
constexpr std::size_t normalCount = 10;
constexpr int mostHalvings = 24;

class LineTracer {
  public:
    LineTracer(const surface::Surface& surface, const SurfelLinks& links) : m_surface(surface), m_links(links) {}

    Vec3d foot(const Vec3d& p) const {
        const auto found = surface::projectReference(m_surface, p, {.checkBoundary = false});
        if (found.status == surface::Status::Ok || found.status == surface::Status::BeyondBoundary)
            return found.foot;
        return m_links.at(nearest(p));
    }
    std::uint32_t nearest(const Vec3d& p) const {
        std::vector<tree::Neighbour> found;
        m_surface.tree().nearest(base::cast<float>(p), 1, found);
        return m_links.number(found.front());
    }
    LinePiece piece(const Vec3d& from, const Vec3d& to) const {
        const std::uint32_t i = nearest((from + to) / 2);
        Vec3d sum = base::cast<double>(m_links.surfel(i).normal);
        for (const std::uint32_t j : m_links.near(i).first(std::min(normalCount, m_links.near(i).size())))
            sum += base::cast<double>(m_links.surfel(j).normal);
        return {from, to, i, base::normalized(sum)};
    }
    /// From a to b, both on the surface, b left out: the feet of the middle, then of both halves.
    void trace(const Vec3d& a, const Vec3d& b, int halvings, std::vector<Vec3d>& out) const {
        base::CancelScope::check();
        if (base::distance(a, b) <= step * m_links.spacing(nearest(a))) {
            out.push_back(a);
            return;
        }
        const Vec3d middle = foot((a + b) / 2);
        const double chord = base::distance(a, b);
        const double far = std::max(base::distance(a, middle), base::distance(middle, b));
        const bool beside =
            chord > longChord * m_links.spacing(nearest(a)) && base::distance(middle, (a + b) / 2) > mostArch * chord;
        if (halvings == 0 || beside || !(far < 0.999 * chord))
            throw base::Error("the line leaves the surface", {}, "give points that are closer together");
        trace(a, middle, halvings - 1, out);
        trace(middle, b, halvings - 1, out);
    }

  private:
    const surface::Surface& m_surface;
    const SurfelLinks& m_links;
};

} // namespace

SurfaceLine lineOnSurface(const surface::Surface& surface, const SurfelLinks& links, std::span<const Vec3d> points) {
    const LineTracer tracer(surface, links);
    std::vector<Vec3d> feet, way;
    for (std::size_t k = 0; k < points.size(); ++k) {
        feet.push_back(tracer.foot(points[k]));
        const double s = links.spacing(tracer.nearest(feet.back()));
        if (!(base::distance(feet.back(), points[k]) < farthest * s))
            throw base::Error("point " + std::to_string(k + 1) + " of the line is not near the surface", {},
                              "give points on the surface, in model units");
    }
    if (feet.size() < 2)
        throw base::Error("a line needs two points at least");
    for (std::size_t k = 0; k + 1 < feet.size(); ++k)
        tracer.trace(feet[k], feet[k + 1], mostHalvings, way);
    way.push_back(feet.back());
    SurfaceLine out;
    for (std::size_t k = 0; k + 1 < way.size(); ++k)
        if (way[k] != way[k + 1])
            out.pieces.push_back(tracer.piece(way[k], way[k + 1]));
    if (out.pieces.empty())
        throw base::Error("the line has no length");
    const LinePiece &first = out.pieces.front(), &last = out.pieces.back();
    out.closed =
        out.pieces.size() > 6 && base::distance(first.from, last.to) < closedWithin * links.spacing(first.nearest);
    if (out.closed && first.from != last.to)
        out.pieces.push_back(tracer.piece(Vec3d(last.to), Vec3d(first.from)));
    return out;
}

} // namespace cells
