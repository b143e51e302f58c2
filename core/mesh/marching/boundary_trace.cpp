#include "core/mesh/marching/boundary_trace.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/packets.h"

#include <algorithm>

namespace mesh {

using base::Vec3d, base::Vec3f;
using surface::Evaluationf, surface::Status;

std::vector<LooseEnd> looseEnds(const SurfaceGrid& grid) {
    constexpr std::size_t bricksPerTask = 64;
    const SparseSet& nodes = grid.nodes();
    std::vector<std::vector<LooseEnd>> parts(base::chunkCount(nodes.bricks().size(), bricksPerTask));
    base::parallelChunks(
        nodes.bricks().size(), bricksPerTask, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t b = begin; b < end; ++b) {
                const Neighbourhood around(nodes, static_cast<std::uint32_t>(b));
                nodes.forMembers(static_cast<std::uint32_t>(b), [&](const GridIndex& p, std::uint32_t n) {
                    GridFace face;
                    for (int axis = 0; axis < 3; ++axis) {
                        if (!faceAt(grid, around, p, axis, face) || face.count == 0)
                            continue;
                        const FacePairs pairs = pairsOf(grid, face);
                        for (int i = 0; i < face.count; ++i)
                            if (pairs.partner[static_cast<std::size_t>(i)] < 0)
                                parts[chunk].push_back({n, axis, face, i});
                    }
                });
            }
        });
    std::vector<LooseEnd> out;
    for (const auto& part : parts)
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

namespace {

constexpr double firstStep = 0.1, leastStep = 0.01, shorter = 0.4; ///< in cells; how steps shrink on failure
constexpr double leastAcross = 0.01;                               ///< |np| / |n|, np the normal in the face's plane
constexpr double height = 1e-4;                                    ///< of |f|, in spacings

/// One curve.
class FaceTrace {
  public:
    FaceTrace(const CrossingGrid& grid, surface::Source& source, const LooseEnd& end)
        : m_grid(grid), m_source(source), m_size(grid.lattice().cell * end.face.size), m_end(end),
          m_across(grid.lattice().direction(end.axis)) {}

    TracedEnd run() {
        const Crossing& start = m_grid.crossings()[m_end.crossing()];
        m_here = {start.position, base::cast<double>(start.normal)};
        m_heading = inwards();
        double step = firstStep;
        for (int i = 0; i < 200; ++i) {
            Point next;
            const Verdict verdict = advance(m_here, step * m_size, next);
            if (verdict == Verdict::Good) {
                if (const int side = sideLeft(next.position); side >= 0)
                    return {TraceEnd::Left, side, m_here.position, base::cast<float>(m_here.normal)};
                m_heading = base::normalized(next.position - m_here.position, m_heading);
                m_here = next;
                step = std::min(firstStep, step / shorter);
                continue;
            }
            if (verdict == Verdict::Beyond)
                return ended(TraceEnd::Limit, step);
            if (step <= leastStep)
                return ended(TraceEnd::Fold, step);
            step = std::max(leastStep, step * shorter);
        }
        return {TraceEnd::Fold, -1, m_here.position, base::cast<float>(m_here.normal)};
    }

  private:
    enum class Verdict { Good, Beyond, Failed };
    struct Point {
        Vec3d position, normal;
    };

    /// Across the edge of the crossing, into the face.
    Vec3d inwards() const {
        const Lattice& lattice = m_grid.lattice();
        const Vec3d u = lattice.direction((m_end.axis + 1) % 3), v = lattice.direction((m_end.axis + 2) % 3);
        switch (m_end.face.side[static_cast<std::size_t>(m_end.index)]) {
        case 0:
            return v;
        case 1:
            return -u;
        case 2:
            return -v;
        default:
            return u;
        }
    }

    /// From a point on the curve to one a step further on.
    Verdict advance(const Point& from, double step, Point& out) {
        const Vec3d along = base::normalized(cross(m_across, from.normal));
        if (!(lengthSq(along) > 0))
            return Verdict::Failed;
        const double side = dot(along, m_heading) < 0 ? -1 : 1;
        return correct(from.position + along * (side * step), from.normal, step, out);
    }

    /// Newton's method in the face's plane.
    Verdict correct(const Vec3d& guess, const Vec3d& normal, double step, Point& out) {
        Vec3d x = guess;
        for (int i = 0; i < 12; ++i) {
            Evaluationf at;
            m_source.evaluate(base::cast<float>(x), surface::Need::Gradient, {}, at);
            const bool usable = at.ok() || at.status == Status::BeyondBoundary;
            if (!usable)
                return Verdict::Failed;
            const Vec3d g = base::cast<double>(at.gradient), flat = g - m_across * dot(g, m_across);
            if (!(lengthSq(flat) > leastAcross * leastAcross * lengthSq(g)))
                return Verdict::Failed;
            const double spacing = m_grid.traits().spacingsPerUnit * double(at.unit);
            x -= flat * (double(at.value) / lengthSq(flat));
            if (distance(x, guess) > step)
                return Verdict::Failed;
            if (std::abs(double(at.value)) > height * spacing)
                continue;
            const double slope = dot(base::cast<double>(at.normal), g);
            Vec3d n = base::normalized(g);
            if (!m_grid.traits().oriented && dot(n, normal) < 0)
                n = -n;
            if (slope < surface::minSlope || dot(n, normal) < 0.3)
                return Verdict::Failed;
            out = {x, n};
            if (at.status == Status::BeyondBoundary || double(at.offCentre) > surface::maxOffCentre * double(at.unit))
                return Verdict::Beyond;
            return Verdict::Good;
        }
        return Verdict::Failed;
    }

    /// Between a point that is surface and a step that is not: halves. Where f has a step it tells of one sheet up to
    /// there and of another behind, so such an end keeps away from it.
    TracedEnd ended(TraceEnd end, double step) {
        const int halvings = end == TraceEnd::Limit ? 24 : 6;
        double good = 0, bad = step * m_size;
        const Point start = m_here;
        for (int i = 0; i < halvings; ++i) {
            Point middle;
            const double t = 0.5 * (good + bad);
            if (advance(start, t, middle) == Verdict::Good) {
                good = t;
                m_here = middle;
            } else {
                bad = t;
            }
        }
        if (const int side = sideLeft(m_here.position); side >= 0)
            return {TraceEnd::Left, side, start.position, base::cast<float>(start.normal)};
        return {end, -1, m_here.position, base::cast<float>(m_here.normal)};
    }

    /// The side of the face through which a point has left it, or -1.
    int sideLeft(const Vec3d& x) const {
        const Vec3d grid = m_grid.lattice().toGrid(x);
        const int u = (m_end.axis + 1) % 3, v = (m_end.axis + 2) % 3;
        const double a = grid[static_cast<std::size_t>(u)] - m_end.face.place[u];
        const double b = grid[static_cast<std::size_t>(v)] - m_end.face.place[v];
        const double size = m_end.face.size;
        const double out[4] = {-b, a - size, b - size, -a};
        int most = 0;
        for (int side = 1; side < 4; ++side)
            if (out[side] > out[most])
                most = side;
        return out[most] > 0 ? most : -1;
    }

    const CrossingGrid& m_grid;
    surface::Source& m_source;
    double m_size; ///< the face's side
    const LooseEnd& m_end;
    Vec3d m_across, m_heading;
    Point m_here;
};

} // namespace

std::vector<TracedEnd> trace(const CrossingGrid& grid, std::span<const LooseEnd> ends, const base::Progress& progress) {
    constexpr std::size_t endsAtOnce = 1024;
    std::vector<Vec3f> x;
    int largest = 1;
    for (const LooseEnd& end : ends) {
        largest = std::max(largest, end.face.size);
        x.push_back(base::cast<float>(grid.crossings()[end.crossing()].position));
    }
    std::vector<TracedEnd> out(ends.size());
    for (std::size_t first = 0; first < ends.size(); first += endsAtOnce) {
        progress.step(static_cast<double>(first) / static_cast<double>(ends.size()), "tracing boundaries");
        const std::span<const Vec3f> some{x.data() + first, std::min(endsAtOnce, ends.size() - first)};
        surface::forPacketsWithin(grid.surface(), some, largest * grid.lattice().cell,
                                  [&](surface::Source& source, std::size_t i) {
                                      out[first + i] = FaceTrace(grid, source, ends[first + i]).run();
                                  });
    }
    return out;
}

} // namespace mesh
