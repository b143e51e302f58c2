#include "core/solid/loops/relief.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/solid/loops/relief_base.h"
#include "core/solid/loops/relief_texture.h"
#include "core/solid/loops/shape_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace solid {

using base::Vec3d;
using Cell = HeightGrid::Cell;

namespace {

/// A surfel of the surroundings: where it is on the map, and how high over the base, with slopes along the map.
struct Sample {
    Vec3d position, normal;
    MapPlace place;
    double height = 0, slopeU = 0, slopeV = 0;
};

constexpr double nearestReach = 12, farthestReach = 40; ///< of the surroundings, in spacings
constexpr double reachOfRadius = 1.6;                   ///< in the hole's radii
constexpr std::size_t fewest = 150;                     ///< surfels around
constexpr double leastRelief = 0.02;                    ///< spacings: less is none

class Follower {
  public:
    Follower(const surface::Surface& surface, const Loop& loop, const Patch& patch, const std::vector<Vec3d>& normals)
        : m_surface(surface), m_loop(loop), m_map(mapOver(patch, normals)) {
        for (const LoopPoint& p : loop.points)
            m_rim.push_back(m_map.at(p.position, p.normal));
    }

    ReliefFate find() {
        gather();
        if (m_samples.size() < fewest || !allAround())
            return ReliefFate::TooLittle;
        measure();
        const double limit = 4 * deviation(); // strays, and other sheets
        std::erase_if(m_samples, [&](const Sample& s) { return std::abs(s.height) > limit; });
        measure();
        if (deviation() < leastRelief * m_spacing)
            return ReliefFate::Smooth;
        base::CancelScope::check();
        rasterise();
        return synthesise(m_grid) ? ReliefFate::Followed : ReliefFate::TooLittle;
    }
    /// Where a vertex of the smooth patch goes.
    Vec3d moved(const Vec3d& p, const Vec3d& normal) const {
        const MapPlace place = m_map.at(p, normal);
        return m_base.at(place) + m_base.normal(place) * (heightAt(place) + rimOff(p));
    }
    /// Heights at the rim are those of the loop: what is found there is less or more by that.
    void holdRim() {
        for (std::size_t i = 0; i < m_rim.size(); ++i)
            m_off.push_back(dot(m_loop.points[i].position - m_base.at(m_rim[i]), m_base.normal(m_rim[i])) -
                            heightAt(m_rim[i]));
    }

  private:
    void gather() {
        const double radius = m_loop.length / (2 * std::numbers::pi);
        double spacing = 0;
        for (const LoopPoint& p : m_loop.points)
            spacing += p.support * surface::spacingOfUnit / static_cast<double>(m_loop.size());
        m_spacing = spacing;
        const double reach = std::clamp(reachOfRadius * radius, nearestReach * spacing, farthestReach * spacing);
        base::Box3d box;
        for (const LoopPoint& p : m_loop.points)
            box.extend(p.position);
        const base::Box3d wide{box.lo - Vec3d{reach, reach, reach}, box.hi + Vec3d{reach, reach, reach}};
        std::vector<Sample> all;
        const base::Box3f around{base::cast<float>(wide.lo), base::cast<float>(wide.hi)};
        m_surface.tree().forBlocksInSupport(around, [&](std::uint32_t, const surfel::SurfelBlock& block) {
            base::CancelScope::check();
            for (int slot = 0; slot < block.size(); ++slot) {
                const Vec3d p = base::cast<double>(block.position(slot));
                if (wide.contains(p))
                    all.push_back({p, base::cast<double>(block.normal(slot)), {}});
            }
        });
        std::vector<std::uint8_t> keep(all.size(), 0);
        base::parallelFor(all.size(), 64, [&](std::size_t i) {
            const LoopPoint* nearest = nullptr;
            double least = reach * reach;
            for (const LoopPoint& p : m_loop.points)
                if (const double apart = lengthSq(p.position - all[i].position); apart < least)
                    least = apart, nearest = &p;
            if (!nearest)
                return;
            const Vec3d mean = meanNormal(all[i].position, all[i].normal);
            keep[i] = dot(mean, nearest->normal) > 0.17 && m_map.covers(mean);
            all[i].place = m_map.at(all[i].position, mean);
        });
        for (std::size_t i = 0; i < all.size(); ++i)
            if (keep[i])
                m_samples.push_back(all[i]);
    }
    /// Of the surfels about a place on one sheet: relief turns single ones.
    Vec3d meanNormal(const Vec3d& x, const Vec3d& own) const {
        constexpr std::size_t around = 40;
        std::vector<tree::Neighbour> near;
        m_surface.tree().nearest(base::cast<float>(x), around, near);
        Vec3d out = own;
        for (const tree::Neighbour& each : near)
            if (const Vec3d n = base::cast<double>(each.block->normal(each.slot)); dot(n, own) > 0)
                out += n;
        return normalized(out, own);
    }
    /// A hole beside the end of an open model has surroundings on one side only.
    bool allAround() const {
        constexpr int parts = 16, least = 13;
        bool seen[parts] = {};
        for (const Sample& s : m_samples)
            seen[std::clamp(static_cast<int>((std::atan2(s.place.v, s.place.u) / (2 * std::numbers::pi) + 0.5) * parts),
                            0, parts - 1)] = true;
        return std::count(std::begin(seen), std::end(seen), true) >= least;
    }
    /// By the lowest degree that is nearly as good as the highest: what is high takes long waves for shape, and swings
    /// in the hole.
    void measure() {
        constexpr double nearly = 1.06;
        measure(ReliefBase::most);
        const double best = deviation();
        for (int degree = ReliefBase::least; degree < ReliefBase::most; ++degree) {
            measure(degree);
            if (deviation() <= nearly * best + 0.1 * leastRelief * m_spacing)
                return;
        }
        measure(ReliefBase::most);
    }
    void measure(int degree) {
        base::CancelScope::check();
        std::vector<Vec3d> positions;
        std::vector<MapPlace> places;
        for (const Sample& s : m_samples)
            positions.push_back(s.position), places.push_back(s.place);
        m_base = ReliefBase(positions, places, degree);
        base::parallelFor(m_samples.size(), 256, [&](std::size_t i) {
            Sample& s = m_samples[i];
            const Vec3d n = m_base.normal(s.place);
            s.height = dot(s.position - m_base.at(s.place), n);
            const double up = std::max(0.2, dot(s.normal, n));
            s.slopeU = -dot(s.normal, m_base.along(s.place, true)) / up;
            s.slopeV = -dot(s.normal, m_base.along(s.place, false)) / up;
        });
    }
    double deviation() const {
        double out = 0;
        for (const Sample& s : m_samples)
            out += s.height * s.height;
        return std::sqrt(out / std::max<double>(1, static_cast<double>(m_samples.size())));
    }
    void rasterise() {
        constexpr double finest = 400; // cells across
        double lo[2] = {m_samples[0].place.u, m_samples[0].place.v}, hi[2] = {lo[0], lo[1]};
        for (const Sample& s : m_samples) {
            lo[0] = std::min(lo[0], s.place.u), hi[0] = std::max(hi[0], s.place.u);
            lo[1] = std::min(lo[1], s.place.v), hi[1] = std::max(hi[1], s.place.v);
        }
        m_pitch = std::max(m_spacing, std::max(hi[0] - lo[0], hi[1] - lo[1]) / finest);
        m_low = {lo[0] - m_pitch, lo[1] - m_pitch};
        m_grid.width = static_cast<int>((hi[0] - lo[0]) / m_pitch) + 4;
        m_grid.height = static_cast<int>((hi[1] - lo[1]) / m_pitch) + 4;
        const std::size_t cells = static_cast<std::size_t>(m_grid.width) * static_cast<std::size_t>(m_grid.height);
        m_grid.values.assign(cells, 0);
        m_grid.cells.assign(cells, Cell::None);
        std::vector<double> weights(cells, 0);
        constexpr double reach = 1.6; // cells
        for (const Sample& s : m_samples) {
            const double x = (s.place.u - m_low.u) / m_pitch, y = (s.place.v - m_low.v) / m_pitch;
            for (int j = static_cast<int>(std::ceil(y - reach)); j <= y + reach; ++j)
                for (int i = static_cast<int>(std::ceil(x - reach)); i <= x + reach; ++i) {
                    const double distanceSq = (i - x) * (i - x) + (j - y) * (j - y);
                    if (!m_grid.has(i, j) || distanceSq >= reach * reach)
                        continue;
                    const double part = 1 - distanceSq / (reach * reach), weight = part * part * part * part;
                    weights[m_grid.at(i, j)] += weight;
                    m_grid.values[m_grid.at(i, j)] +=
                        weight * (s.height + m_pitch * (s.slopeU * (i - x) + s.slopeV * (j - y)));
                }
        }
        constexpr double least = 0.15; // of the weight of a surfel there
        for (int y = 0; y < m_grid.height; ++y)
            for (int x = 0; x < m_grid.width; ++x) {
                const std::size_t i = m_grid.at(x, y);
                if (inHole({m_low.u + x * m_pitch, m_low.v + y * m_pitch}))
                    m_grid.cells[i] = Cell::Wanted;
                else if (weights[i] > least)
                    m_grid.cells[i] = Cell::Known;
                m_grid.values[i] = m_grid.cells[i] == Cell::Known ? m_grid.values[i] / weights[i] : 0;
            }
        fillCracks();
    }
    /// Cells beside the rim that are neither in the hole nor beside a surfel.
    void fillCracks() {
        const std::vector<Cell> before = m_grid.cells;
        const auto is = [&](int x, int y, Cell cell) { return m_grid.has(x, y) && before[m_grid.at(x, y)] == cell; };
        for (int y = 0; y < m_grid.height; ++y)
            for (int x = 0; x < m_grid.width; ++x) {
                bool beside = false;
                for (int v = -2; v <= 2; ++v)
                    for (int u = -2; u <= 2; ++u)
                        beside = beside || is(x + u, y + v, Cell::Wanted);
                if (beside && is(x, y, Cell::None))
                    m_grid.cells[m_grid.at(x, y)] = Cell::Wanted;
            }
    }
    bool inHole(const MapPlace& p) const {
        bool out = false;
        for (std::size_t i = 0, j = m_rim.size() - 1; i < m_rim.size(); j = i++) {
            const MapPlace &a = m_rim[i], &b = m_rim[j];
            if ((a.v > p.v) != (b.v > p.v) && p.u < (b.u - a.u) * (p.v - a.v) / (b.v - a.v) + a.u)
                out = !out;
        }
        return out;
    }
    /// Cubic between cells; at the edge of what is there the nearest.
    double heightAt(const MapPlace& place) const {
        const double x = (place.u - m_low.u) / m_pitch, y = (place.v - m_low.v) / m_pitch;
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        const auto weights = [](double t, double(&w)[4]) { // Catmull and Rom
            w[0] = 0.5 * t * (-1 + t * (2 - t)), w[1] = 1 + 0.5 * t * t * (-5 + 3 * t);
            w[2] = 0.5 * t * (1 + t * (4 - 3 * t)), w[3] = 0.5 * t * t * (t - 1);
        };
        double wx[4], wy[4], out = 0, nearest = 0, least = 1e30;
        weights(x - i, wx), weights(y - j, wy);
        bool whole = true;
        for (int v = 0; v < 4; ++v)
            for (int u = 0; u < 4; ++u) {
                const int a = i - 1 + u, b = j - 1 + v;
                if (!m_grid.has(a, b) || m_grid.cells[m_grid.at(a, b)] == Cell::None) {
                    whole = false;
                    continue;
                }
                const double value = m_grid.values[m_grid.at(a, b)], apart = std::hypot(a - x, b - y);
                out += wx[u] * wy[v] * value;
                if (apart < least)
                    least = apart, nearest = value;
            }
        return whole ? out : nearest;
    }
    double rimOff(const Vec3d& p) const {
        const double fade = 2 * m_spacing;
        double sum = 0, weights = 0, least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < m_off.size(); ++i) {
            const double apartSq = lengthSq(p - m_loop.points[i].position) + 1e-12 * fade * fade,
                         weight = 1 / (apartSq * apartSq);
            sum += weight * m_off[i], weights += weight;
            least = std::min(least, apartSq);
        }
        return weights > 0 ? sum / weights * std::exp(-0.5 * least / (fade * fade)) : 0;
    }

    const surface::Surface& m_surface;
    const Loop& m_loop;
    HoleMap m_map;
    std::vector<MapPlace> m_rim;
    std::vector<double> m_off; ///< of each of them
    std::vector<Sample> m_samples;
    double m_spacing = 0, m_pitch = 0;
    MapPlace m_low;
    ReliefBase m_base;
    HeightGrid m_grid;
};

} // namespace

ReliefFate followRelief(const surface::Surface& surface, const Loop& loop, const Patch& patch, Patch& fine,
                        std::vector<Vec3d>& normals) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    if (!layout.normals || !layout.oriented)
        return ReliefFate::TooLittle;
    Follower follower(surface, loop, patch, patchNormals(loop, patch));
    if (const ReliefFate fate = follower.find(); fate != ReliefFate::Followed)
        return fate;
    follower.holdRim();
    std::vector<Vec3d> moved(fine.positions.size()), turned(moved.size());
    base::parallelFor(moved.size(), 64,
                      [&](std::size_t v) { moved[v] = follower.moved(fine.positions[v], normals[v]); });
    for (std::size_t v = 0; v < fine.loopSize; ++v) { // the rim keeps its own relief
        moved[v] = loop.points[v].position;
        normals[v] = loop.points[v].normal;
    }
    for (const mesh::Triangle& t : fine.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d a = moved[t[(k + 1) % 3]] - moved[t[k]], b = moved[t[(k + 2) % 3]] - moved[t[k]],
                        n = cross(a, b);
            turned[t[k]] += normalized(n) * std::atan2(length(n), dot(a, b));
        }
    for (std::size_t v = fine.loopSize; v < moved.size(); ++v)
        normals[v] = normalized(turned[v], normals[v]);
    fine.positions = std::move(moved);
    return ReliefFate::Followed;
}

} // namespace solid
