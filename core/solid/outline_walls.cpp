#include "core/solid/outline_walls.h"

#include "core/cells/crease_labels.h"
#include "core/process/resampling/resample.h"
#include "core/solid/map_places.h"
#include "core/solid/spacing_beside.h"

#include <algorithm>
#include <numbers>

namespace solid {

using base::Point2;
using base::Vec3d;

namespace {

/// A part of the outline without sharp turns, by the way along it.
struct Chain {
    std::vector<Point2> corners; ///< both ends included
    std::vector<double> ways;    ///< of each corner from the first

    double length() const { return ways.back(); }
    Point2 at(double way) const {
        const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(ways.begin(), ways.end(), way) - ways.begin(), 1,
                                                     std::ssize(ways) - 1);
        const auto k = static_cast<std::size_t>(next);
        const double step = ways[k] - ways[k - 1], share = step > 0 ? (way - ways[k - 1]) / step : 0;
        return {std::lerp(corners[k - 1].x, corners[k].x, share), std::lerp(corners[k - 1].y, corners[k].y, share)};
    }
    /// Of the chord about a place.
    Point2 direction(double way, double reach) const {
        const Point2 from = at(std::max(way - reach, 0.0)), to = at(std::min(way + reach, length()));
        return {to.x - from.x, to.y - from.y};
    }
};

double distanceOf(const Point2& a, const Point2& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

class WallSampler {
  public:
    WallSampler(const OutlineSide& side, const surface::Surface& model)
        : m_side(side), m_frame(side.frame()), m_definition(model.definition()), m_beside(model.tree(), side) {
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        m_out.layout = layout;
        if (m_beside.empty())
            return;
        m_beside.forPlaces([&](const Vec3d& x) {
            const double depth = m_frame.depth(x), spacing = m_beside.at(x);
            m_least = std::min(m_least, spacing), m_most = std::max(m_most, spacing);
            m_near = std::min(m_near, depth - spacing), m_far = std::max(m_far, depth + spacing);
        });
        if (!m_frame.parallel) // where the eye is within the model walls begin there
            m_near = SurfaceSide(model).at(m_frame.eye).value < 0 ? 0.25 * m_least : std::max(m_near, 1e-3 * m_far);
        findChains();
        for (std::uint32_t c = 0; c < m_chains.size(); ++c)
            sample(m_chains[c], c);
    }
    surfel::SurfelList result() {
        if (!m_creases.empty())
            cells::setLabels(m_out, cells::labelsByCreases(m_out.items, m_cells, m_creases, m_most));
        return std::move(m_out);
    }

  private:
    /// Of the model beside a place of the outline, in units of the picture.
    double spacingAt(const Point2& p, double depth) const {
        return m_beside.at(m_frame.place(p, depth)) / m_frame.scale(depth);
    }

    /// A turn is sharp where the walls bend by 6 degrees and more, and leave a curve through the corners by more than a
    /// twentieth of the spacing: what a hand draws round in many short steps is round.
    bool sharp(std::size_t corner) const {
        const auto p = m_side.corners();
        const std::size_t n = p.size();
        const Point2 &before = p[(corner + n - 1) % n], &at = p[corner], &after = p[(corner + 1) % n];
        const double first = std::atan2(at.y - before.y, at.x - before.x),
                     last = std::atan2(after.y - at.y, after.x - at.x),
                     turn = std::abs(std::remainder(last - first, 2 * std::numbers::pi)),
                     step = std::min(distanceOf(before, at), distanceOf(at, after));
        return turn > std::numbers::pi / 30 && turn * step > 8 * 0.05 * spacingAt(at, 0.5 * (m_near + m_far));
    }
    void findChains() {
        const auto p = m_side.corners();
        std::vector<std::size_t> ends;
        for (std::size_t k = 0; k < p.size(); ++k)
            if (sharp(k))
                ends.push_back(k);
        const std::size_t begin = ends.empty() ? 0 : ends.front();
        Chain chain;
        for (std::size_t i = 0; i <= p.size(); ++i) {
            const std::size_t k = (begin + i) % p.size();
            chain.ways.push_back(chain.corners.empty() ? 0 : chain.length() + distanceOf(chain.corners.back(), p[k]));
            chain.corners.push_back(p[k]);
            if (i > 0 && (i == p.size() || std::ranges::binary_search(ends, k))) {
                m_chains.push_back(chain);
                chain = {{p[k]}, {0}};
            }
        }
        const auto count = static_cast<std::uint32_t>(m_chains.size());
        for (std::uint32_t c = 0; c < count && count > 1; ++c)
            crease(m_chains[c], c, (c + count - 1) % count);
    }
    /// At the beginning of a chain.
    void crease(const Chain& chain, std::uint32_t cell, std::uint32_t before) {
        const Point2& p = chain.corners.front();
        const Point2 on = chain.at(1e-6 * chain.length()),
                     back = m_chains[before].at((1 - 1e-6) * m_chains[before].length());
        const double first = distanceOf(p, on), last = distanceOf(p, back), step = std::min(first, last);
        const Point2 between{p.x + step * ((on.x - p.x) / first + (back.x - p.x) / last),
                             p.y + step * ((on.y - p.y) / first + (back.y - p.y) / last)};
        m_creases.push_back(
            {m_frame.place(p, m_near), m_frame.place(p, m_far), before, cell,
             m_side.holds(m_frame.place(between, 1)) ? cells::Meeting::Convex : cells::Meeting::Concave});
    }

    /// Of a chain: the way along it, and the depth.
    struct Map {
        const WallSampler& walls;
        const Chain& chain;
        Point2 lo, hi;

        double unit(double depth) const { return walls.m_frame.scale(depth); }
        double spacing(double way, double depth) const {
            return walls.m_beside.at(walls.m_frame.place(chain.at(way), depth));
        }
    };
    void sample(const Chain& chain, std::uint32_t cell) {
        const Map map{*this, chain, {0, m_near}, {chain.length(), m_far}};
        forPlaces(map, m_least, m_most,
                  [&](double way, double depth, double spacing) { add(chain, cell, way, depth, spacing); });
    }
    /// Faces away from what the outline holds; not where that lies on both sides, or on none.
    void add(const Chain& chain, std::uint32_t cell, double way, double depth, double spacing) {
        const Point2 p = chain.at(way), d = chain.direction(way, 0.5 * spacing / m_frame.scale(depth));
        const Vec3d x = m_frame.place(p, depth), across = m_frame.right * d.x + m_frame.upright * d.y;
        const Vec3d normal = normalized(cross(across, m_frame.parallel ? m_frame.forward : x - m_frame.eye));
        const auto held = [&](double height) { return m_side.holds(x + normal * height); };
        const bool ahead = held(1e-3 * spacing), behind = held(-1e-3 * spacing);
        if (ahead == behind)
            return;
        surfel::Surfel s;
        s.position = base::cast<float>(x);
        s.normal = base::cast<float>(ahead ? -normal : normal);
        s.support = process::supportOf(m_definition, static_cast<float>(spacing));
        m_out.append(s, {});
        m_cells.push_back(cell);
    }

    const OutlineSide& m_side;
    const PictureFrame& m_frame;
    surface::SurfaceDefinition m_definition;
    SpacingBeside m_beside;
    double m_least = std::numeric_limits<double>::infinity(), m_most = 0;
    double m_near = std::numeric_limits<double>::infinity(), m_far = -std::numeric_limits<double>::infinity();
    std::vector<Chain> m_chains;
    std::vector<cells::CreasePiece> m_creases;
    surfel::SurfelList m_out;
    std::vector<std::uint32_t> m_cells;
};

} // namespace

surfel::SurfelList wallsOf(const OutlineSide& side, const surface::Surface& model) {
    return WallSampler(side, model).result();
}

} // namespace solid
