#include "core/solid/hollow.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/ranked.h"
#include "core/cells/labels.h"
#include "core/process/resampling/point_grid.h"
#include "core/solid/hollow_edges.h"
#include "core/solid/side.h"
#include "core/surface/projection/project.h"

#include <numbers>
#include <optional>

namespace solid {

using base::Vec3d;
using base::Vec3f;

namespace {

/// A place at the depth asked for.
struct Place {
    Vec3d position, inwards;
    double spacing = 0;
    surfel::Surfel above; ///< the outer surfel nearest to it: what it takes after
    std::vector<std::uint32_t> words;
};

/// The inner wall: first places below every surfel, then what is missing between them, grown along the surface of one
/// distance.
class InnerWall {
  public:
    InnerWall(const surface::Surface& model, double thickness)
        : m_model(model), m_thickness(thickness), m_grid(model.tree().bounds().lo, cellOf(model)) {
        if (cells::LabelLayout::of(*model.tree().layout()))
            m_sharp.emplace(model);
    }

    surfel::SurfelList made(const base::Progress& progress) {
        const surfel::SurfelList outer = m_model.tree().surfels();
        std::vector<std::optional<Place>> below(outer.size());
        progress.step(0, "Looking for room");
        base::parallelFor(outer.size(), 32, [&](std::size_t i) {
            const surfel::Surfel& s = outer.items[i];
            below[i] = atDepth(base::cast<double>(s.position) - base::cast<double>(s.normal) * m_thickness);
        });
        for (const std::optional<Place>& place : below)
            if (place)
                accept(*place);
        progress.step(0.4, "Growing the inner wall");
        for (std::size_t begin = 0; begin < m_places.size();) // a generation after the other
            begin = grow(begin);
        surfel::SurfelList out;
        out.layout = outer.layout;
        for (const Place& place : m_places) {
            surfel::Surfel s = place.above;
            s.position = base::cast<float>(place.position);
            s.normal = base::cast<float>(place.inwards);
            s.mask = 0;
            out.append(s, place.words);
        }
        return out;
    }

  private:
    /// About a spacing: the middle one of the blocks'.
    static float cellOf(const surface::Surface& model) {
        std::vector<float> supports;
        model.tree().forEachBlock(
            [&](std::uint32_t, const surfel::SurfelBlock& block) { supports.push_back(block.maxSupport()); });
        return std::max(1e-5F * model.tree().bounds().diagonal(),
                        0.75F * base::median(supports) * static_cast<float>(surface::spacingOfUnit));
    }
    /// The nearest place of the outer wall. Rounded edges would turn the inner wall beside them.
    SideFoot onWall(const Vec3d& x) const {
        if (m_sharp)
            return m_sharp->foot(x);
        const surface::Projection<float> found = surface::project(m_model, base::cast<float>(x));
        if (!found.ok())
            return {};
        return {base::cast<double>(found.foot), 0, normalized(base::cast<double>(found.at.gradient)), true};
    }
    /// The nearest place of the surface of that depth: along the way from the foot on the outer wall. Nothing outside,
    /// or where another part of the wall is nearer.
    std::optional<Place> atDepth(Vec3d x) const {
        constexpr int steps = 4;
        std::vector<tree::Neighbour> near;
        Place out;
        for (int step = 0; step < steps; ++step) {
            const SideFoot wall = onWall(x);
            if (!wall.ok)
                return {};
            const Vec3d next = wall.foot - wall.gradient * m_thickness;
            const double moved = distance(next, x);
            x = next;
            out.inwards = -wall.gradient;
            if (moved < 1e-3 * m_thickness)
                break;
        }
        m_model.tree().nearest(base::cast<float>(x), 1, near);
        const tree::Neighbour& at = near.front();
        out.above = at.block->surfel(at.slot);
        out.spacing = static_cast<double>(out.above.support) * surface::spacingOfUnit;
        // surfels stand up to a spacing beside the foot, and so farther away, never nearer
        if (static_cast<double>(at.distanceSq) < std::pow(m_thickness - 0.1 * std::min(out.spacing, m_thickness), 2))
            return {};
        const Vec3d to = x - base::cast<double>(out.above.position);
        if (dot(to, base::cast<double>(out.above.normal)) >= 0)
            return {};
        out.position = x;
        out.words.resize(at.block->extraWords());
        at.block->extra(at.slot, out.words);
        return out;
    }
    bool accept(const Place& place) {
        constexpr double apart = 0.72; // of a spacing, as resampling fills (process/README 4.2)
        base::CancelScope::check();    // millions one after the other
        bool free = true;
        m_grid.forNear(base::cast<float>(place.position), static_cast<float>(apart * place.spacing),
                       [&](const process::PointGrid::Entry& entry) {
                           const Place& other = m_places[entry.index];
                           if (distance(other.position, place.position) < apart * place.spacing &&
                               dot(other.inwards, place.inwards) > 0.17)
                               free = false;
                       });
        if (!free)
            return false;
        m_grid.insert({base::cast<float>(place.position), static_cast<std::uint32_t>(m_places.size())});
        m_places.push_back(place);
        return true;
    }
    /// Candidates beside places from `begin` on; returns where the next generation begins.
    std::size_t grow(std::size_t begin) {
        constexpr int directions = 8;
        constexpr double step = 1.05;
        const std::size_t end = m_places.size(), count = end - begin;
        std::vector<std::optional<Place>> candidates(count * directions);
        base::parallelFor(count, 8, [&](std::size_t k) {
            const Place& place = m_places[begin + k];
            const Vec3d u = base::perpendicular(place.inwards), v = cross(place.inwards, u);
            for (int d = 0; d < directions; ++d) {
                const double angle = 2 * std::numbers::pi * d / directions;
                const Vec3d x = place.position + (u * std::cos(angle) + v * std::sin(angle)) * (step * place.spacing);
                if (room(x, place))
                    candidates[k * directions + static_cast<std::size_t>(d)] = atDepth(x);
            }
        });
        for (const std::optional<Place>& candidate : candidates)
            if (candidate)
                accept(*candidate);
        base::CancelScope::check();
        return end;
    }
    bool room(const Vec3d& x, const Place& from) const {
        bool free = true;
        m_grid.forNear(base::cast<float>(x), static_cast<float>(0.675 * from.spacing),
                       [&](const process::PointGrid::Entry& entry) {
                           free = free && distance(m_places[entry.index].position, x) >= 0.675 * from.spacing;
                       });
        return free;
    }

    const surface::Surface& m_model;
    std::optional<SurfaceSide> m_sharp; ///< where the model has labels
    double m_thickness;
    process::PointGrid m_grid;
    std::vector<Place> m_places;
};

} // namespace

Combined hollowed(const surface::Surface& model, double thickness, const base::Progress& progress) {
    if (model.definition().manifold != surface::Manifold::Surface || !model.tree().layout()->oriented)
        throw base::Error("only a solid whose normals point outwards can be made hollow", "hollow",
                          "orient the normals first");
    surfel::SurfelList inner = InnerWall(model, thickness).made(progress);
    if (inner.size() < 4)
        throw base::Error("no place of the model is deep enough for walls of that thickness", "hollow",
                          "make them thinner");
    Combined out;
    out.inserted = inner.size();
    out.surface = withInnerWall(model, std::move(inner));
    progress.step(1, "Growing the inner wall");
    return out;
}

} // namespace solid
