#include "core/process/resampling/refine_under.h"

#include "core/process/resampling/resample_cells.h"
#include "core/process/resampling/resample_fit.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <set>

namespace process {

using base::Vec3f;

namespace {

/// With more neighbours over a place than that a surface is no reduced one.
constexpr int fewNeighbours = 16;
/// Over a place, of the new samples.
constexpr float neighbours = 10;
constexpr float perRadius = 4.5f; ///< new spacings in the brush's radius
constexpr float growth = 0.5f;    ///< of the spacing, per length outside of the brush
/// In radii: how far spacings stay fine when there is something to do, so that the next dabs find nothing, and how far
/// they must be fine.
constexpr float fineWithin = 1.5f, askedWithin = 1.1f;
constexpr float coarser = 1.25f; ///< than wanted, and worth while
constexpr float beside = 0.6f;   ///< of a semi-axis, about a spacing: at rims there is nothing on one side
constexpr float inside = 0.7f;   ///< of the boundary limit: that is no border yet, and finer samples end where it was
constexpr float finerAtRims = 2; ///< at least so much: others, as wide as those before, would end elsewhere
constexpr int mostRounds = 8;
constexpr int fitRounds = 6;

class Refining {
  public:
    Refining(const surface::Surface& surface, const Vec3f& centre, float radius)
        : m_surface(surface), m_centre(centre), m_radius(radius),
          m_shape(surfel::shapeChannel(*surface.tree().layout())),
          m_perSpacing(supportOf(surface.definition(), 1) *
                       std::sqrt(neighbours / static_cast<float>(surface.definition().neighbours))) {}

    float spacingAt(const Vec3f& x, float within) const {
        return m_radius / perRadius + growth * std::max(0.0f, distance(x, m_centre) - within * m_radius);
    }
    float supportAt(const Vec3f& x) const { return m_perSpacing * spacingAt(x, fineWithin); }

    /// Is there anything that is far coarser than it should be?
    bool asked() {
        std::vector<tree::Neighbour> near;
        m_surface.tree().nearest(m_centre, 16, near);
        for (const tree::Neighbour& each : near)
            m_coarsest = std::max(m_coarsest, surfel::ballOf(*each.block, each.slot, m_shape));
        // where spacings have grown to the coarsest of them
        m_reach = fineWithin * m_radius + m_coarsest / (growth * m_perSpacing);
        bool out = false;
        forAll(m_surface.tree(), [&](std::uint32_t, const surfel::SurfelBlock& block, int slot) {
            out = out || coarse(block, slot, coarser * m_perSpacing * spacingAt(block.position(slot), askedWithin));
        });
        return out;
    }

    /// Creases are met by the samples that are there: finer ones would need others across.
    bool inOneCell() const { return oneCellAround(m_surface, m_centre, m_reach + m_coarsest); }

    surface::Surface refined(const Along& along) {
        forAll(m_surface.tree(), [&](std::uint32_t, const surfel::SurfelBlock& block, int slot) {
            if (!coarse(block, slot, supportAt(block.position(slot))))
                m_kept.insert(keyOf(block, slot));
        });
        ResampleOptions options;
        options.fitRounds = 0;
        options.spacing = spacingAt(m_centre + Vec3f{m_reach, 0, 0}, fineWithin);
        // few neighbours are off centre anywhere: the model's own limit tells what is a border
        options.border = inside * m_surface.definition().boundaryLimit;
        options.targetOf = [this](const surfel::SurfelBlock& block, int slot) {
            return spacingAt(block.position(slot), fineWithin);
        };
        tree::SurfelTree tree = m_surface.tree();
        const auto apply = [&](tree::Edit edit) {
            if (!edit.empty())
                tree = tree.apply(along ? along(tree, std::move(edit)) : edit);
        };
        apply(balls(tree));
        bool settled = false;
        for (int round = 0; round < mostRounds && !settled; ++round) {
            tree::Edit edit = resample({tree, m_surface.definition()}, chosen(tree), options, m_surface);
            settled = edit.inserted.items.empty();
            apply(std::move(edit));
            apply(balls(tree));
        }
        options.relaxAll = true;
        options.order = Order::RelaxOnly;
        apply(resample({tree, m_surface.definition()}, chosen(tree), options, m_surface));
        apply(balls(tree));
        m_kept.clear(); // where others border on new ones, each has a say in the surface there
        m_reach += m_coarsest;
        apply(fit(tree, chosen(tree), m_surface,
                  {[this](const Vec3f& x) { return spacingAt(x, fineWithin); }, options.border, fitRounds}));
        return {tree, m_surface.definition()};
    }

  private:
    using Key = std::array<float, 3>;
    static Key keyOf(const surfel::SurfelBlock& block, int slot) {
        const Vec3f p = block.position(slot);
        return {p.x, p.y, p.z};
    }
    bool coarse(const surfel::SurfelBlock& block, int slot, float limit) const {
        const float axis = surfel::ballOf(block, slot, m_shape);
        return axis > 0.5f * m_radius && axis > limit && block.mask(slot) < 1 &&
               (axis > finerAtRims * limit || !atRim(block, slot, axis));
    }
    /// Does the surface end beside it?
    bool atRim(const surfel::SurfelBlock& block, int slot, float axis) const {
        if (!std::isfinite(m_surface.definition().boundaryLimit))
            return false;
        const Vec3f p = block.position(slot), n = block.normal(slot), u = base::perpendicular(n), v = cross(n, u);
        constexpr int ways = 8;
        for (int k = 0; k < ways; ++k) {
            const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / ways;
            const Vec3f there = p + (u * std::cos(a) + v * std::sin(a)) * (beside * axis);
            if (!m_surface.evaluate(there, surface::Need::Value, {n}).ok())
                return true;
        }
        return false;
    }
    template <class Fn>
    void forAll(const tree::SurfelTree& tree, const Fn& fn) const {
        tree.forBlocksInBall(m_centre, m_reach, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (distanceSq(block.position(slot), m_centre) < m_reach * m_reach)
                    fn(number, block, slot);
        });
    }
    /// What gives way or came for it.
    tree::Selection chosen(const tree::SurfelTree& tree) const {
        std::map<std::uint32_t, std::bitset<surfel::blockCapacity>> slots;
        forAll(tree, [&](std::uint32_t number, const surfel::SurfelBlock& block, int slot) {
            if (block.mask(slot) < 1 && !m_kept.contains(keyOf(block, slot)))
                slots[number].set(static_cast<std::size_t>(slot));
        });
        tree::Selection out;
        for (const auto& [number, each] : slots)
            out.push_back({number, each});
        return out;
    }
    /// Supports as spacings are.
    tree::Edit balls(const tree::SurfelTree& tree) const {
        tree::Edit edit;
        edit.inserted.layout = tree.layout();
        for (const tree::SelectedBlock& each : chosen(tree)) {
            surfel::MutableBlockPtr changed;
            const surfel::BlockPtr block = tree.block(each.block);
            for (int slot = 0; slot < block->size(); ++slot) {
                const float support = supportAt(block->position(slot));
                if (!each.slots[static_cast<std::size_t>(slot)] ||
                    (block->support(slot) == support && surfel::shapeOf(*block, slot, m_shape) == Vec3f{}))
                    continue;
                if (!changed)
                    changed = block->clone();
                surfel::setBall(*changed, slot, m_shape, support);
            }
            if (changed) {
                changed->seal();
                edit.blocks.push_back({each.block, changed, {}});
            }
        }
        return edit;
    }

    const surface::Surface& m_surface;
    Vec3f m_centre;
    float m_radius;
    int m_shape;
    float m_perSpacing; ///< support of a new sample over its spacing
    float m_reach = 0, m_coarsest = 0;
    std::set<Key> m_kept; ///< places of those within reach that are left alone
};

/// Is it of few oriented samples?
bool isReduced(const surface::Surface& surface) {
    const surface::SurfaceDefinition& d = surface.definition();
    return d.manifold == surface::Manifold::Surface && d.support <= 0 && d.neighbours <= fewNeighbours &&
           surface.tree().layout()->oriented && !surface.tree().empty();
}

} // namespace

std::optional<surface::Surface> refinedUnder(const surface::Surface& surface, const Vec3f& centre, float radius,
                                             const Along& along) {
    if (!isReduced(surface) || !(radius > 0))
        return std::nullopt;
    Refining refining(surface, centre, radius);
    if (!refining.asked() || !refining.inOneCell())
        return std::nullopt;
    return refining.refined(along);
}

} // namespace process
