// What a stroke has brought to where it is to be: cells of space under the brush that have been seen to a few times
// since all of them was at its goal. Further dabs leave them alone, or each of the twenty that a place lies under would
// do the whole again, and find little to do.
//
//     which = settled.drop(tree, which, {centre, within}, atGoal)
//
// A value; its results follow from the dabs so far.
#pragma once

#include "core/base/cells.h"
#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <functional>

namespace sculpt {

class Settled {
  public:
    /// `centre`, `radius`: of the first brush.
    Settled(const base::Vec3f& centre, float radius) : m_origin(centre), m_scale(cellsPerRadius / radius) {}

    /// What the dab sees to: a cell counts where all of it does.
    struct Ball {
        base::Vec3f centre;
        float radius;
    };
    using AtGoal = std::function<bool(const surfel::SurfelBlock&, int slot)>;
    /// Of the surfels in the ball, those that are left to do.
    tree::Selection drop(const tree::SurfelTree& tree, tree::Selection which, const Ball& ball, const AtGoal& atGoal);

  private:
    static constexpr float cellsPerRadius = 16;
    /// Once at the goal, a place has its surroundings follow and then evens out.
    static constexpr int enough = 2;
    struct Place {
        int times = 0;      ///< seen to since it is at its goal
        int dab = 0;        ///< the last that looked
        bool there = false; ///< all that the last saw was at its goal
    };

    base::Vec3f m_origin;
    float m_scale;
    int m_dabs = 0;
    base::CellMap<Place> m_places;
};

} // namespace sculpt
