// Whose turn it is under a wide brush, for tools that bring what is there to a goal in steps: a dab sees to about as
// many surfels as one of a narrow brush, and what it owes to the others is done by later dabs or by the end of the
// stroke. Strength is never lost and never done twice: cells of a part of the brush keep account of what is due to
// them. A dab looks at the blocks under it, and at the surfels of few cells.
//
//     dues.owe(tree, centre, radius, strength)       a dab
//     turn = dues.next({tree, most, ..., look})    what it does
//     dues.firstDab(), turn = dues.rest(dab, the same for that dab)      at the end, until there is none
//
// What has been seen to a few times since it is at its goal is owed nothing more. A value; its results follow from the
// dabs so far.
#pragma once

#include "core/base/cells.h"
#include "core/tree/selection.h"
#include "core/tree/surfel_tree.h"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace sculpt {

class Dues {
  public:
    /// `radius`, `centre`: of the first brush.
    Dues(const base::Vec3f& centre, float radius) : m_origin(centre), m_scale(cellsPerRadius / radius) {}

    /// A dab of this strength, above 0 and at most 1.
    void owe(const tree::SurfelTree& tree, const base::Vec3f& centre, float radius, float strength);

    /// The surfels of a cell, and a ball that holds it.
    struct Cell {
        const tree::Selection& surfels;
        base::Vec3f middle;
        float reach;
    };
    /// What the dab has to do with them.
    struct Seen {
        tree::Selection under; ///< those under the brush
        tree::Selection which; ///< those of them that it is for
        bool there = false;    ///< all of these are at their goal
        bool whole = false;    ///< all of the cell is under the brush
    };
    struct Wanted {
        const tree::SurfelTree& tree;
        std::size_t most; ///< surfels at once, to a cell
        int turnsAtGoal;  ///< that a place has once it is there: its surroundings follow, and it evens out
        bool alike;       ///< surfels that have their turn together must have about the same support
        std::function<Seen(const Cell&)> look;
    };
    struct Turn {
        tree::Selection under, which; ///< of all cells whose turn it is
        float strength = 0;           ///< that is due to all of them, at most 1
        float support = 0;            ///< the mean of `which`
    };
    /// Of cells that are owed as much, what is nearest to the last dab comes first.
    Turn next(const Wanted& wanted);

    /// The number of the first dab, counted by calls of owe(), that has left something.
    std::optional<int> firstDab() const;
    /// A turn of what that dab left. REQUIRES: firstDab() is `dab`.
    Turn rest(int dab, const Wanted& wanted);
    /// It owes nothing more.
    void forgive(int dab);

  private:
    static constexpr float cellsPerRadius = 4;
    struct Place {
        base::Cell cell;
        float due = 0;     ///< strength
        float aside = 0;   ///< squared distance to the last dab
        float nearest = 0; ///< the least of those of the dabs
        int dab = -1;      ///< that which was nearest: its aim is this place's
        int last = -1;     ///< the last dab over it
        int times = 0;     ///< its turns since it is at its goal
    };

    base::Vec3f middleOf(const base::Cell& cell) const;
    float reach() const { return 0.87f / m_scale; } ///< half a cell's diagonal, with room for rounding
    tree::Selection surfelsOf(const tree::SurfelTree& tree, const base::Cell& cell) const;
    Turn choose(std::vector<Place*> places, const Wanted& wanted);

    base::Vec3f m_origin;
    float m_scale;
    int m_dabs = 0;
    std::map<std::uint64_t, Place> m_places; ///< by cell
};

} // namespace sculpt
