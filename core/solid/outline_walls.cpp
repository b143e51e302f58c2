#include "core/solid/outline_walls.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/cells/crease_labels.h"
#include "core/process/resampling/resample.h"
#include "core/solid/hexagonal.h"
#include "core/solid/spacing_beside.h"

#include <algorithm>
#include <numbers>

namespace solid {

using base::Vec3d;

namespace {

/// A part of the outline without sharp turns, by the way along it.
struct Chain {
    std::vector<PicturePoint> corners; ///< both ends included
    std::vector<double> ways;          ///< of each corner from the first

    double length() const { return ways.back(); }
    PicturePoint at(double way) const {
        const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(ways.begin(), ways.end(), way) - ways.begin(), 1,
                                                     std::ssize(ways) - 1);
        const auto k = static_cast<std::size_t>(next);
        const double step = ways[k] - ways[k - 1], share = step > 0 ? (way - ways[k - 1]) / step : 0;
        return {std::lerp(corners[k - 1][0], corners[k][0], share), std::lerp(corners[k - 1][1], corners[k][1], share)};
    }
    /// Of the chord about a place.
    PicturePoint direction(double way, double reach) const {
        const PicturePoint from = at(std::max(way - reach, 0.0)), to = at(std::min(way + reach, length()));
        return {to[0] - from[0], to[1] - from[1]};
    }
};

double distanceOf(const PicturePoint& a, const PicturePoint& b) {
    return std::hypot(b[0] - a[0], b[1] - a[1]);
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
            const double depth = m_frame.seen(x).z, spacing = m_beside.at(x);
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
    static constexpr double mostPlaces = 2e7;

    double scale() const { return m_frame.scale(0.5 * (m_near + m_far)); }
    /// Of the model beside a place of the outline, in units of the picture.
    double spacingAt(const PicturePoint& p, double depth) const {
        return m_beside.at(m_frame.place(p[0], p[1], depth)) / m_frame.scale(depth);
    }

    /// A turn is sharp where the walls bend by 6 degrees and more, and leave a curve through the corners by more than a
    /// twentieth of the spacing: what a hand draws round in many short steps is round.
    bool sharp(std::size_t corner) const {
        const auto p = m_side.corners();
        const std::size_t n = p.size();
        const PicturePoint &before = p[(corner + n - 1) % n], &at = p[corner], &after = p[(corner + 1) % n];
        const double first = std::atan2(at[1] - before[1], at[0] - before[0]),
                     last = std::atan2(after[1] - at[1], after[0] - at[0]),
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
        const PicturePoint& p = chain.corners.front();
        const PicturePoint on = chain.at(1e-6 * chain.length()),
                           back = m_chains[before].at((1 - 1e-6) * m_chains[before].length());
        const double first = distanceOf(p, on), last = distanceOf(p, back), step = std::min(first, last);
        const PicturePoint between{p[0] + step * ((on[0] - p[0]) / first + (back[0] - p[0]) / last),
                                   p[1] + step * ((on[1] - p[1]) / first + (back[1] - p[1]) / last)};
        m_creases.push_back({m_frame.place(p[0], p[1], m_near), m_frame.place(p[0], p[1], m_far), before, cell,
                             m_side.holds(between) ? cells::Meeting::Convex : cells::Meeting::Concave});
    }

    void sample(const Chain& chain, std::uint32_t cell) {
        const double wide = chain.length() * m_frame.scale(m_far), deep = m_far - m_near;
        if (!(wide * deep < mostPlaces * m_least * m_least))
            throw base::Error("walls as dense as the model is there would have too many points", "trim",
                              "resample the model with a larger spacing");
        if (m_most < 1.25 * m_least)
            rows(chain, cell, std::sqrt(m_least * m_most));
        else
            squares(chain, cell);
    }
    /// A hexagonal layout, half a row from where the chain ends.
    void rows(const Chain& chain, std::uint32_t cell, double spacing) {
        const double row = rowStep * spacing, along = spacing / rowStep;
        int number = 0;
        for (double depth = m_near; depth < m_far; depth += row, ++number) {
            base::CancelScope::check();
            const auto count =
                static_cast<int>(std::max(1.0, std::round(chain.length() * m_frame.scale(depth) / along)));
            for (int k = 0; k < count; ++k)
                add(chain, cell, chain.length() * (k + 0.25 + 0.5 * (number & 1)) / count, depth, spacing);
        }
    }
    /// Rectangles, halved across their longer side until none is longer than the spacing about it.
    void squares(const Chain& chain, std::uint32_t cell) {
        struct Rectangle {
            double way, depth, wide, deep;
        };
        std::vector<Rectangle> open{{0.5 * chain.length(), 0.5 * (m_near + m_far), chain.length(), m_far - m_near}};
        while (!open.empty()) {
            const Rectangle at = open.back();
            open.pop_back();
            base::CancelScope::check();
            const PicturePoint p = chain.at(at.way);
            const double spacing = m_beside.at(m_frame.place(p[0], p[1], at.depth)),
                         wide = at.wide * m_frame.scale(at.depth);
            // what is a side of 1.4 at most is one of 0.7 at least: as dense in the mean
            if (std::max(wide, at.deep) <= 1.4 * spacing) {
                add(chain, cell, at.way, at.depth, spacing);
                continue;
            }
            for (const double part : {-0.25, 0.25}) {
                if (wide > at.deep)
                    open.push_back({at.way + part * at.wide, at.depth, 0.5 * at.wide, at.deep});
                else
                    open.push_back({at.way, at.depth + part * at.deep, at.wide, 0.5 * at.deep});
            }
        }
    }
    /// Faces away from what the outline holds; not where that lies on both sides, or on none.
    void add(const Chain& chain, std::uint32_t cell, double way, double depth, double spacing) {
        const PicturePoint p = chain.at(way), d = chain.direction(way, 0.5 * spacing / m_frame.scale(depth));
        const Vec3d x = m_frame.place(p[0], p[1], depth), across = m_frame.right * d[0] + m_frame.upright * d[1];
        const Vec3d normal = normalized(cross(across, m_frame.parallel ? m_frame.forward : x - m_frame.eye));
        const auto held = [&](double height) {
            const Vec3d seen = m_frame.seen(x + normal * height);
            return m_side.holds({seen.x, seen.y});
        };
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
