#include "core/solid/merge.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/base/ranked.h"
#include "core/process/cleaning/list_change.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/link_creases.h"

#include <algorithm>

namespace solid {

using base::Vec3f;

namespace {

/// Parts meet where what stays on one looks at what stays on another over a place where something went.
class Seam {
  public:
    Seam(const cells::SurfelLinks& links, const tree::SurfelTree& gone, Overlaps overlaps)
        : m_links(links), m_turn(links.size()), m_voids(overlaps == Overlaps::AndVoids) {
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
    /// Does the link lead over the seam? Both ends are above each other's planes there, below them around voids, and
    /// turn by more than they do between neighbours of one part.
    bool crosses(std::uint32_t a, std::uint32_t b) const {
        constexpr float usually = 1.5f;
        const Vec3f way = m_links.surfel(b).position - m_links.surfel(a).position;
        if (std::isinf(std::max(m_turn[a], m_turn[b])))
            return false;
        const float most = usually * std::min(m_turn[a], m_turn[b]) * length(way);
        const float ahead = dot(m_links.surfel(a).normal, way), back = -dot(m_links.surfel(b).normal, way);
        return ((ahead > 0 && back > 0) || (m_voids && ahead < 0 && back < 0)) && turn(a, b) > std::max(least, most);
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
        return base::ranked(all, static_cast<std::size_t>(0.55 * static_cast<double>(all.size())));
    }

    const cells::SurfelLinks& m_links;
    std::vector<float> m_turn; ///< infinity where nothing went near by
    bool m_voids;
};

/// With creases where parts meet.
surface::Surface creased(const surface::Surface& surface, const tree::SurfelTree& gone, Overlaps overlaps,
                         std::size_t& atSeam) {
    return creasedWhere(
        surface,
        [&](const cells::SurfelLinks& links) -> LeadsOver {
            return [seam = std::make_shared<Seam>(links, gone, overlaps), &links](std::uint32_t a, std::uint32_t e) {
                return seam->crosses(a, links.link(e).other);
            };
        },
        atSeam);
}

} // namespace

Combined merged(const surface::Surface& model, bool creases, const base::Progress& progress, Overlaps overlaps) {
    requireSolid(model);
    progress.step(0, "Looking for what lies inside");
    const std::vector<std::uint8_t> goes = insideOthers(model.tree(), process::part(progress, 0, 0.6), overlaps);
    const surfel::SurfelList surfels = model.tree().surfels();
    surfel::SurfelList gone; // places are all that is asked of these
    for (std::size_t i = 0; i < goes.size(); ++i)
        if (goes[i])
            gone.append(surfels.items[i], {});
    Combined out;
    out.removed = gone.size();
    out.surface = {process::changed(model.tree(), {goes, {}, {}, {}, {}}), model.definition()};
    if (out.removed == 0 || !creases)
        return out;
    progress.step(0.6, "Joining");
    const base::CancelScope scope(progress.cancel);
    out.surface = creased(out.surface, tree::SurfelTree::build(gone), overlaps, out.atSeam);
    return out;
}

} // namespace solid
