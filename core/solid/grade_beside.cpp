#include "core/solid/grade_beside.h"

#include "core/process/resampling/resample_cells.h"
#include "core/process/resampling/resample_fit.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solid {

using base::Vec3f;

namespace {

constexpr float perSupport = static_cast<float>(surface::spacingOfUnit);
constexpr float coarse = 3;      ///< times the other one's spacing: from there on crumbs were seen
constexpr float besideSeam = 2;  ///< the same, of what comes
constexpr float growth = 0.25f;  ///< of the spacing, per length: less than what a support takes to reach the seam
constexpr float worth = 1.25f;   ///< coarser than wanted
constexpr float supports = 3.5f; ///< in spacings
constexpr int mostRounds = 12, fitRounds = 4;

class Grading {
  public:
    Grading(const surface::Surface& version, const SeamFeet& others) : m_version(version) {
        surfel::SurfelList places;
        places.layout = std::make_shared<surfel::AttributeLayout>();
        for (const std::vector<SeamFoot>& block : others)
            for (const SeamFoot& foot : block) {
                surfel::Surfel s;
                s.position = base::cast<float>(foot.place);
                s.support = static_cast<float>(foot.spacing);
                m_finest = std::min(m_finest, s.support);
                places.append(s, {});
            }
        if (places.size() > 0)
            m_places = tree::SurfelTree::build(places);
    }

    /// Beside the seam, as samples of the other one find it: those of this one may be too far away to have feet on it.
    bool asked() const {
        bool out = false;
        std::vector<tree::Neighbour> near;
        m_places.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size() && !out; ++slot) {
                m_version.tree().nearest(block.position(slot), 1, near);
                out = spacingOf(*near[0].block, near[0].slot) > coarse * block.support(slot);
            }
        });
        return out;
    }

    surface::Surface graded() const {
        process::ResampleOptions options;
        options.fitRounds = 0; // once, at the end
        options.targetOf = [this](const surfel::SurfelBlock& block, int slot) {
            return std::min(spacingAt(block.position(slot)), spacingOf(block, slot));
        };
        float coarsest = 0;
        forChosen(m_version.tree(), [&](const surfel::SurfelBlock& block, int slot) {
            options.spacing = std::max(options.spacing, options.targetOf(block, slot));
            coarsest = std::max(coarsest, spacingOf(block, slot));
        });
        tree::SurfelTree tree = m_version.tree();
        const auto apply = [&](const tree::Edit& edit) {
            if (!edit.empty())
                tree = tree.apply(edit);
            return !edit.inserted.items.empty();
        };
        const auto again = [&] {
            return apply(process::resample({tree, m_version.definition()}, chosen(tree), options, m_version));
        };
        for (int round = 0; round < mostRounds && again(); ++round)
            ;
        options.relaxAll = true;
        options.order = process::Order::RelaxOnly;
        again();
        apply(balls(tree));
        if (!process::hasCells(m_version)) // each is the surface of its own surfels
            apply(process::fit(
                tree, within(tree, coarsest * (1 / growth + supports)), m_version,
                {[this](const Vec3f& x) { return spacingAt(x); }, m_version.definition().boundaryLimit, fitRounds}));
        return {tree, m_version.definition()};
    }

  private:
    /// The spacing on the seam there, and how far that is.
    std::pair<float, float> nearestPlace(const Vec3f& x) const {
        std::vector<tree::Neighbour> near;
        m_places.nearest(x, 1, near);
        return {near[0].block->support(near[0].slot), std::sqrt(near[0].distanceSq)};
    }
    float distanceTo(const Vec3f& x) const { return nearestPlace(x).second; }
    float spacingAt(const Vec3f& x) const {
        const auto [there, distance] = nearestPlace(x);
        return besideSeam * there + growth * distance;
    }
    static float spacingOf(const surfel::SurfelBlock& block, int slot) { return block.support(slot) * perSupport; }

    /// Of one block at a time; whole ones away from the seam are asked about once.
    template <class Wanted>
    tree::Selection select(const tree::SurfelTree& tree, const Wanted& wanted) const {
        tree::Selection out;
        tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            const base::Box3f box = block.box();
            if (!wanted(block.maxSupport() * perSupport, m_finest,
                        std::max(0.0f, distanceTo((box.lo + box.hi) / 2) - box.diagonal() / 2)))
                return;
            tree::SelectedBlock selected{number, {}};
            for (int slot = 0; slot < block.size(); ++slot) {
                const auto [there, distance] = nearestPlace(block.position(slot));
                selected.slots[static_cast<std::size_t>(slot)] = wanted(spacingOf(block, slot), there, distance);
            }
            if (selected.slots.any())
                out.push_back(selected);
        });
        return out;
    }
    /// Those that are coarser than wanted.
    tree::Selection chosen(const tree::SurfelTree& tree) const {
        return select(tree, [](float spacing, float there, float distance) {
            return spacing > worth * (besideSeam * there + growth * distance);
        });
    }
    tree::Selection within(const tree::SurfelTree& tree, float reach) const {
        return select(tree, [reach](float, float, float distance) { return distance < reach; });
    }
    template <class Fn>
    void forChosen(const tree::SurfelTree& tree, const Fn& fn) const {
        for (const tree::SelectedBlock& each : chosen(tree)) {
            const surfel::BlockPtr block = tree.block(each.block);
            for (int slot = 0; slot < block->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)])
                    fn(*block, slot);
        }
    }
    /// Supports as spacings are wanted.
    tree::Edit balls(const tree::SurfelTree& tree) const {
        tree::Edit edit;
        edit.inserted.layout = tree.layout();
        const int shape = surfel::shapeChannel(*tree.layout());
        for (const tree::SelectedBlock& each : chosen(tree)) {
            const surfel::BlockPtr block = tree.block(each.block);
            const surfel::MutableBlockPtr changed = block->clone();
            for (int slot = 0; slot < block->size(); ++slot)
                if (each.slots[static_cast<std::size_t>(slot)])
                    surfel::setBall(*changed, slot, shape, spacingAt(block->position(slot)) / perSupport);
            changed->seal();
            edit.blocks.push_back({each.block, changed, {}});
        }
        return edit;
    }

    const surface::Surface& m_version;
    float m_finest = std::numeric_limits<float>::infinity(); ///< spacing on the seam
    tree::SurfelTree m_places;                               ///< on the seam; each one's support is the spacing there
};

} // namespace

std::optional<surface::Surface> gradedBeside(const surface::Surface& version, const SeamFeet& others) {
    const Grading grading(version, others);
    return grading.asked() ? std::optional(grading.graded()) : std::nullopt;
}

} // namespace solid
