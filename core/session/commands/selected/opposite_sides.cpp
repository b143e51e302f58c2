#include "core/session/commands/selected/opposite_sides.h"

#include "core/base/error.h"
#include "core/base/short_number.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/measuring/thickness.h"
#include "core/session/place_text.h"

#include <algorithm>

namespace session {

using base::Vec3d;

namespace {

/// How far inwards each surfel moves.
class InwardMoves {
  public:
    InwardMoves(const tree::SurfelTree& before, const tree::SurfelTree& after)
        : m_tree(before), m_first(before.firstSurfels()) {
        const surfel::SurfelList was = before.surfels(), is = after.surfels();
        for (std::size_t i = 0; i < was.size(); ++i)
            m_moves.push_back(dot(base::cast<double>(was.items[i].position - is.items[i].position),
                                  base::cast<double>(was.items[i].normal)));
    }
    double operator[](std::size_t surfel) const { return m_moves[surfel]; }
    double most() const { return *std::max_element(m_moves.begin(), m_moves.end()); }
    /// Of the surfel that is nearest to a place.
    double at(const Vec3d& place) {
        m_tree.nearest(base::cast<float>(place), 1, m_near);
        const tree::Neighbour& found = m_near.front();
        return m_moves[m_first[found.blockNumber] + static_cast<std::size_t>(found.slot)];
    }

  private:
    const tree::SurfelTree& m_tree;
    std::vector<double> m_moves;
    std::vector<std::size_t> m_first; ///< of each block
    std::vector<tree::Neighbour> m_near;
};

} // namespace

void requireApart(const Context& context, const tree::SurfelTree& after) {
    const surface::Surface& surface = context.document.surface();
    const surfel::SurfelList surfels = surface.tree().surfels();
    InwardMoves moves(surface.tree(), after);
    const process::Thicknesses thick = process::thicknessesOf(surface, process::part(context.progress, 0.5, 1));
    const double most = moves.most();
    double least = 0; // that is left, below 0 where the sides pass through each other
    std::size_t worst = surfels.size();
    for (std::size_t i = 0; i < surfels.size(); ++i) {
        const double t = thick.at[i]; // NaN: nothing is opposite
        if (!(moves[i] > 0) || !(t <= moves[i] + most))
            continue;
        const Vec3d x = base::cast<double>(surfels.items[i].position), n = base::cast<double>(surfels.items[i].normal);
        const double left = t - moves[i] - moves.at(x - n * t);
        if (left < least || (left <= least && worst == surfels.size()))
            least = left, worst = i;
    }
    if (worst == surfels.size())
        return;
    throw base::Error(
        "the model is " + base::shortNumber(thick.at[worst], 3) + " thick at " +
            placeText(base::cast<double>(surfels.items[worst].position) + context.document.provenance().origin,
                      thick.at[worst]) +
            ": both sides would meet",
        "inflate", "go less deep, or mask what is thin");
}

} // namespace session
