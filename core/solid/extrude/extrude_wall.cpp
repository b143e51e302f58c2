#include "core/solid/extrude/extrude_wall.h"

#include "core/process/resampling/resample.h"
#include "core/solid/map_places.h"
#include "core/solid/seam_labels.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace solid {

using base::Vec3d;

namespace {

class WallMaker {
  public:
    WallMaker(const Loop& loop, const std::function<Vec3d(std::size_t)>& way, const std::vector<std::uint8_t>& stands,
              const tree::SurfelTree& beside, const surface::SurfaceDefinition& definition, surfel::SurfelList& out)
        : m_loop(loop), m_stands(stands), m_beside(beside), m_definition(definition), m_out(out),
          m_words(out.layout->words()), m_at(loop.size() + 1, 0) {
        const std::size_t n = loop.size();
        for (std::size_t i = 0; i < n; ++i) {
            m_way.push_back(way(i));
            m_at[i + 1] = m_at[i] + distance(position(i), position(i + 1));
            m_height = std::max(m_height, length(m_way.back()));
        }
    }
    void make() {
        double least = std::numeric_limits<double>::infinity(), most = 0;
        for (const LoopPoint& p : m_loop.points)
            least = std::min(least, p.spacing), most = std::max(most, p.spacing);
        const Map map{*this, {0, 0}, {m_at.back(), m_height}};
        forPlaces(map, least, most, [&](double u, double v, double spacing) { add(u, v, spacing); });
    }

  private:
    const Vec3d& position(std::size_t i) const { return m_loop.points[i % m_loop.size()].position; }
    template <class Fn>
    auto mix(std::size_t i, double t, const Fn& fn) const {
        return fn(i) * (1 - t) + fn((i + 1) % m_loop.size()) * t;
    }
    /// The way along the loop, and that up the wall.
    struct Map {
        const WallMaker& wall;
        base::Point2 lo, hi;
        double unit(double) const { return 1; }
        double spacing(double u, double) const {
            const auto [i, t] = placeOnLoop(wall.m_at, u);
            return wall.mix(i, t, [&](std::size_t k) { return wall.m_loop.points[k].spacing; });
        }
    };
    Vec3d wayAt(double u) const {
        const auto [i, t] = placeOnLoop(m_at, u);
        return mix(i, t, [&](std::size_t k) { return m_way[k]; });
    }
    Vec3d foot(double u) const {
        const auto [i, t] = placeOnLoop(m_at, u);
        return mix(i, t, [&](std::size_t k) { return position(k); });
    }
    /// So far on along the loop, but not around its corners.
    double upTo(double u, double by) const {
        for (std::size_t i = 0; i < m_loop.size(); ++i)
            if (m_loop.points[i].corner)
                if (const double ahead = std::remainder(m_at[i] - u, m_at.back()); ahead * by > 0)
                    by = std::copysign(std::min(std::abs(by), std::abs(ahead)), by);
        return u + by;
    }
    /// The nearest surfel there; at a corner of several, the nearest that faces as the wall does.
    const tree::Neighbour& besideAt(const Vec3d& place, const Vec3d& normal) {
        constexpr std::size_t around = 8;
        constexpr double alike = 0.95;
        m_beside.nearest(base::cast<float>(place), around, m_near);
        const auto same = std::ranges::find_if(m_near, [&](const tree::Neighbour& each) {
            return dot(base::cast<double>(each.block->normal(each.slot)), normal) > alike;
        });
        return same != m_near.end() ? *same : m_near.front();
    }
    void add(double u, double v, double spacing) {
        const auto [i, t] = placeOnLoop(m_at, u);
        if (!m_stands.empty() && !m_stands[t < 0.5 ? i : (i + 1) % m_loop.size()])
            return;
        const double share = v / m_height;
        const auto at = [&](double where) { return foot(where) + wayAt(where) * share; };
        const Vec3d way = wayAt(u), place = at(u), along = at(upTo(u, spacing)) - at(upTo(u, -spacing));
        const Vec3d normal = normalized(cross(along, way), m_loop.points[i].normal);
        const tree::Neighbour& near = besideAt(foot(u), normal);
        surfel::Surfel s = near.block->surfel(near.slot);
        near.block->extra(near.slot, m_words);
        surfel::becomeBall(*m_out.layout, s, m_words);
        if (const auto labels = cells::LabelLayout::of(*m_out.layout)) {
            const cells::Label label = labels->at(m_words); // of its cell, beside no crease yet
            writeLabel(*m_out.layout, {label.cell, label.cell, cells::Meeting::None, 255, label.face}, m_words);
        }
        s.position = base::cast<float>(place);
        s.normal = base::cast<float>(m_out.layout->normals ? normal : Vec3d{});
        s.support = process::supportOf(m_definition, static_cast<float>(spacing));
        s.mask = 0;
        m_out.append(s, m_words);
    }

    const Loop& m_loop;
    const std::vector<std::uint8_t>& m_stands;
    const tree::SurfelTree& m_beside;
    const surface::SurfaceDefinition& m_definition;
    surfel::SurfelList& m_out;
    std::vector<std::uint32_t> m_words;
    std::vector<tree::Neighbour> m_near;
    std::vector<double> m_at; ///< ways along the loop to its places
    std::vector<Vec3d> m_way; ///< from each to the end of the wall
    double m_height = 0;
};

} // namespace

void wallAlong(const Loop& loop, const std::function<Vec3d(std::size_t)>& way, const std::vector<std::uint8_t>& stands,
               const tree::SurfelTree& beside, const surface::SurfaceDefinition& definition, surfel::SurfelList& out) {
    WallMaker(loop, way, stands, beside, definition, out).make();
}

} // namespace solid
