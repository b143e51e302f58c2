#include "core/solid/inside_others.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/estimation/part_progress.h"
#include "core/surface/definition.h"
#include "core/surface/winding/winding_number.h"

#include <algorithm>

namespace solid {

using base::Vec3f;

namespace {

double spacingOf(float support) {
    return static_cast<double>(support) * surface::spacingOfUnit;
}

/// Does a surfel that faces the other way lie in the same place, and is there more than a plate without thickness?
bool facesAnother(const tree::SurfelTree& tree, const surface::WindingNumber& winding, const surfel::SurfelBlock& block,
                  int slot) {
    constexpr double plate = 0.3;
    constexpr std::size_t looked = 12;
    constexpr float opposite = -0.9f;
    const Vec3f p = block.position(slot), n = block.normal(slot);
    const auto spacing = static_cast<float>(spacingOf(block.support(slot)));
    std::vector<tree::Neighbour> near;
    tree.nearest(p, looked, near);
    const bool another = std::ranges::any_of(near, [&](const tree::Neighbour& each) {
        const Vec3f apart = each.block->position(each.slot) - p;
        return dot(each.block->normal(each.slot), n) < opposite && std::abs(dot(apart, n)) < 0.1f * spacing &&
               lengthSq(apart) < 1.44f * spacing * spacing;
    });
    return another && winding.at(base::cast<double>(p)) > plate;
}

/// Winding numbers at a surfel and a spacing above and below are, each with one more for every part around,
///
///     surface (1, 1/2, 0)    edge (1, 1/8 to 3/4, 0)    thin wall (0, 1/2, 0)    narrow gap (1, 1/2 to 1, 1)
///
/// and so the sum of the second and the mean of the others is at most 2, and at least 2.4 inside of another. With 1 - w
/// in place of w the same is true of voids: what is solid and what is not change their parts.
double around(const surface::WindingNumber& winding, const surfel::SurfelBlock& block, int slot, bool ofVoids) {
    constexpr double least = 0.9; // at what is inside, corners too
    const base::Vec3d x = base::cast<double>(block.position(slot)),
                      step = base::cast<double>(block.normal(slot)) * spacingOf(block.support(slot));
    const auto at = [&](const base::Vec3d& place) { return ofVoids ? 1 - winding.at(place) : winding.at(place); };
    const double w = at(x);
    return w > least ? w + 0.5 * (at(x + step) + at(x - step)) : w;
}

class Inside {
  public:
    Inside(const tree::SurfelTree& tree, const base::Progress& progress, Overlaps overlaps)
        : m_tree(tree), m_first(tree.firstSurfels()), m_found(tree.size()), m_progress(progress),
          m_voids(overlaps == Overlaps::AndVoids) {}

    /// Of each surfel in tree order. Areas that are shared by all around fit everywhere but where sheets cross: there
    /// each has but half of its own. What may be beside such a place is asked with areas of sheets.
    std::vector<std::uint8_t> run() {
        constexpr double inside = 2.1, suspect = 1.6;
        const surface::WindingNumber whole(m_tree, process::part(m_progress, 0, 0.3));
        look([&](const surfel::SurfelBlock& block, int slot, Found) {
            const double sum = mostAround(whole, block, slot);
            return sum > inside || facesAnother(m_tree, whole, block, slot) ? Found::Inside
                   : sum > suspect                                          ? Found::Suspect
                                                                            : Found::No;
        });
        const surfel::SurfelList found = suspects();
        if (found.size() > 0) {
            const tree::SurfelTree near = tree::SurfelTree::build(found);
            const surface::WindingNumber sheets(m_tree, process::part(m_progress, 0.5, 0.8), surface::Areas::Sheet);
            look([&](const surfel::SurfelBlock& block, int slot, Found before) {
                const bool in =
                    before == Found::Inside || (isNear(near, block, slot) && mostAround(sheets, block, slot) > inside);
                return in ? Found::Inside : Found::No;
            });
        }
        std::vector<std::uint8_t> out(m_found.size());
        std::ranges::transform(m_found, out.begin(), [](Found each) { return each == Found::Inside; });
        return out;
    }

  private:
    enum class Found : std::uint8_t { No, Suspect, Inside };

    double mostAround(const surface::WindingNumber& winding, const surfel::SurfelBlock& block, int slot) const {
        const double sum = around(winding, block, slot, false);
        return m_voids ? std::max(sum, around(winding, block, slot, true)) : sum;
    }

    /// found(block, slot, before) for all. In parallel.
    template <class Fn>
    void look(const Fn& found) {
        const base::CancelScope scope(m_progress.cancel);
        base::parallelFor(m_tree.blockCount(), 1, [&](std::size_t b) {
            const surfel::BlockPtr block = m_tree.block(static_cast<std::uint32_t>(b));
            for (int slot = 0; slot < block->size(); ++slot) {
                Found& here = m_found[m_first[b] + static_cast<std::size_t>(slot)];
                here = found(*block, slot, here);
            }
        });
    }
    /// And what is inside; their places at least.
    surfel::SurfelList suspects() const {
        surfel::SurfelList out;
        m_tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (m_found[m_first[number] + static_cast<std::size_t>(slot)] != Found::No)
                    out.append(block.surfel(slot), {});
        });
        return out;
    }
    static bool isNear(const tree::SurfelTree& others, const surfel::SurfelBlock& block, int slot) {
        std::vector<tree::Neighbour> near;
        others.nearest(block.position(slot), 1, near);
        return base::distance(near[0].block->position(near[0].slot), block.position(slot)) < block.support(slot);
    }

    const tree::SurfelTree& m_tree;
    std::vector<std::size_t> m_first;
    std::vector<Found> m_found;
    const base::Progress& m_progress;
    bool m_voids;
};

} // namespace

std::vector<std::uint8_t> insideOthers(const tree::SurfelTree& tree, const base::Progress& progress,
                                       Overlaps overlaps) {
    return Inside(tree, progress, overlaps).run();
}

} // namespace solid
