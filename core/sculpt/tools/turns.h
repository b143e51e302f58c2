// Whose turn it is under the brush: a dab of a wide brush sees to about as many surfels as one of a narrow brush, those
// that have waited longest, and the end of the stroke to what no dab has come to. A place that a stroke goes over lies
// under some twenty of its dabs, and few of them do as well as all.
//
//     which = turns.next(tree, under, centre)       of a dab
//     which = turns.rest(tree)                      at the end, until none is left
//
// It goes by cells of a part of the brush, since what lies together has its surroundings in common. For tools that
// leave the surface where it is: what has not had its turn has not moved. A value; its results follow from the dabs so
// far.
#pragma once

#include "core/base/cells.h"
#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <map>

namespace sculpt {

class Turns {
  public:
    /// So many surfels have their turn at once, to a cell.
    static constexpr std::size_t atOnce = 4000;

    /// `radius`, `centre`: of the first brush.
    Turns(const base::Vec3f& centre, float radius) : m_origin(centre), m_scale(cellsPerRadius / radius) {}

    /// Of the surfels under a dab those whose turn it is: of cells that have waited as long, what is nearest to the
    /// centre.
    tree::Selection next(const tree::SurfelTree& tree, const tree::Selection& under, const base::Vec3f& centre);
    /// Of the cells that have had no turn, as many surfels of those that were under dabs. Empty: none is left.
    tree::Selection rest(const tree::SurfelTree& tree);

  private:
    static constexpr float cellsPerRadius = 4;
    struct Place {
        base::Cell cell;
        int waited = 0; ///< dabs since its last turn
        int turn = 0;   ///< the last, by dabs; 0: none yet
        /// Without a turn yet: what was under dabs.
        std::vector<base::Vec3f> left;
        std::size_t known = 0; ///< so many of these are ascending, none twice
    };
    struct Here; ///< a place under a dab

    base::Cell cellAt(const base::Vec3f& p) const { return base::cellOf(p, m_origin, m_scale); }
    std::vector<Here> placesOf(const tree::SurfelTree& tree, const tree::Selection& under, const base::Vec3f& centre);
    void choose(std::vector<Here>& here);
    void leave(Place& place, const base::Vec3f& p);
    static void settle(Place& place);

    base::Vec3f m_origin;
    float m_scale;
    int m_dabs = 0;
    std::map<std::uint64_t, Place> m_places; ///< by cell
};

} // namespace sculpt
