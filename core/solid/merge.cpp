#include "core/solid/merge.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/cells/creases/link_bands.h"
#include "core/cells/creases/link_labels.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/seam_labels.h"
#include "core/surface/winding/winding_number.h"

#include <algorithm>

namespace solid {

using base::Vec3f;
using cells::Label;

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
/// and so the sum of the second and the mean of the others is at most 2, and at least 2.4 inside of another.
double around(const surface::WindingNumber& winding, const surfel::SurfelBlock& block, int slot) {
    constexpr double least = 0.9; // at what is inside, corners too
    const base::Vec3d x = base::cast<double>(block.position(slot)),
                      step = base::cast<double>(block.normal(slot)) * spacingOf(block.support(slot));
    const double w = winding.at(x);
    return w > least ? w + 0.5 * (winding.at(x + step) + winding.at(x - step)) : w;
}

/// Surfels inside of other parts, or on them and facing them.
class Inside {
  public:
    Inside(const tree::SurfelTree& tree, const base::Progress& progress)
        : m_tree(tree), m_first(tree.firstSurfels()), m_found(tree.size()), m_progress(progress) {}

    /// Of each surfel in tree order. Areas that are shared by all around fit everywhere but where sheets cross: there
    /// each has but half of its own. What may be beside such a place is asked with areas of sheets.
    std::vector<std::uint8_t> run() {
        constexpr double inside = 2.1, suspect = 1.6;
        const surface::WindingNumber whole(m_tree, process::part(m_progress, 0, 0.3));
        look([&](const surfel::SurfelBlock& block, int slot, Found) {
            const double sum = around(whole, block, slot);
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
                    before == Found::Inside || (isNear(near, block, slot) && around(sheets, block, slot) > inside);
                return in ? Found::Inside : Found::No;
            });
        }
        std::vector<std::uint8_t> out(m_found.size());
        std::ranges::transform(m_found, out.begin(), [](Found each) { return each == Found::Inside; });
        return out;
    }

  private:
    enum class Found : std::uint8_t { No, Suspect, Inside };

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
};

/// Parts meet where what stays on one looks at what stays on another over a place where something went.
class Seam {
  public:
    Seam(const cells::SurfelLinks& links, const tree::SurfelTree& gone) : m_links(links), m_turn(links.size()) {
        base::parallelChunks(m_turn.size(), 512, [&](std::size_t begin, std::size_t end, std::size_t) {
            std::vector<tree::Neighbour> near;
            for (std::size_t i = begin; i < end; ++i) {
                const auto number = static_cast<std::uint32_t>(i);
                gone.nearest(m_links.surfel(number).position, 1, near);
                const Vec3f nearest = near[0].block->position(near[0].slot);
                const double reach = cells::SurfelLinks::linkReach * m_links.spacing(number);
                m_turn[i] = base::distance(m_links.surfel(number).position, nearest) < static_cast<float>(reach)
                                ? usualTurn(number)
                                : std::numeric_limits<float>::infinity();
            }
        });
    }
    /// Does the link lead over the seam? Both ends are above each other's planes there, which turn by more than they do
    /// between neighbours of one part.
    bool crosses(std::uint32_t a, std::uint32_t b) const {
        constexpr float usually = 1.5f;
        const Vec3f way = m_links.surfel(b).position - m_links.surfel(a).position;
        if (std::isinf(std::max(m_turn[a], m_turn[b])))
            return false;
        const float most = usually * std::min(m_turn[a], m_turn[b]) * length(way);
        return dot(m_links.surfel(a).normal, way) > 0 && dot(m_links.surfel(b).normal, way) < 0 &&
               turn(a, b) > std::max(least, most);
    }

  private:
    static constexpr float least = 0.14f; ///< 8 degrees

    float turn(std::uint32_t a, std::uint32_t b) const { // its sine and less, of small ones the angle
        return length(m_links.surfel(a).normal - m_links.surfel(b).normal);
    }
    /// Of normals over the way: of the links, less than half of which lead over the seam.
    float usualTurn(std::uint32_t i) const {
        std::vector<float> all;
        m_links.forLinks(i, [&](std::uint32_t j, cells::Cut) {
            const float way = base::distance(m_links.surfel(i).position, m_links.surfel(j).position);
            if (way > 0)
                all.push_back(turn(i, j) / way);
        });
        if (all.empty())
            return 0;
        const auto own = all.begin() + static_cast<std::ptrdiff_t>(0.55 * static_cast<double>(all.size()));
        std::ranges::nth_element(all, own);
        return *own;
    }

    const cells::SurfelLinks& m_links;
    std::vector<float> m_turn; ///< infinity where nothing went near by
};

/// With creases where parts meet: on both sides bands, cells that are sharp to the one across and smooth to the rest of
/// their face (cells/README 1.4).
surface::Surface creased(const surface::Surface& surface, const tree::SurfelTree& gone, std::size_t& atSeam) {
    surfel::SurfelList surfels = surface.tree().surfels();
    std::vector<Label> labels = cells::labelsOf(surface.tree());
    cells::SurfelLinks links(surface.tree(), surfels.items);
    std::vector<std::uint32_t> before, faces;
    std::vector<Vec3f> normals;
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        before.push_back(labels[i].cell);
        faces.push_back(labels[i].face);
        normals.push_back(surfels.items[i].normal);
    }
    links.cutWalls(normals);
    const Seam seam(links, gone);
    bool any = false;
    for (std::uint32_t a = 0; a < links.size(); ++a)
        for (std::uint32_t e = links.begin(a); e < links.end(a); ++e)
            if (const std::uint32_t b = links.link(e).other; b > a && seam.crosses(a, b)) {
                links.cut(e, cells::Cut::Crease);
                any = true;
            }
    if (!any)
        return surface;
    const std::vector<std::uint32_t> split = cells::splitAtCreases(links, before);
    cells::moveToCells(links, split, labels);
    const std::vector<Label> moved = labels;
    cells::labelByLinks(links, split, faces, normals, 1, labels);
    atSeam = 0;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != moved[i] && labels[i].meeting != cells::Meeting::None) {
            labels[i].sharpness = 255; // also where few links lead over it: it ends nowhere
            ++atSeam;
        }
    return cells::labelled(surface, std::move(surfels), labels);
}

} // namespace

Combined merged(const surface::Surface& model, bool creases, const base::Progress& progress) {
    requireSolid(model);
    progress.step(0, "Looking for what lies inside");
    const base::Progress looking = process::part(progress, 0, 0.6);
    const std::vector<std::uint8_t> goes = Inside(model.tree(), looking).run();
    Combined out;
    tree::Edit edit;
    edit.inserted.layout = model.tree().layout();
    surfel::SurfelList gone; // places are all that is asked of these
    std::size_t next = 0;
    model.tree().forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::BlockEdit change{number, {}, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            if (goes[next++]) {
                change.removed.set(static_cast<std::size_t>(slot));
                gone.append(block.surfel(slot), {});
            }
        if (change.removed.any())
            edit.blocks.push_back(std::move(change));
    });
    out.removed = gone.size();
    out.surface = {model.tree().apply(edit), model.definition()};
    if (out.removed == 0 || !creases)
        return out;
    progress.step(0.6, "Joining");
    const base::CancelScope scope(progress.cancel);
    out.surface = creased(out.surface, tree::SurfelTree::build(gone), out.atSeam);
    return out;
}

} // namespace solid
