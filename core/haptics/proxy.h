// The proxy (god-object): where the tool would be if the surface were impenetrable [Zilles95], [Ruspini97]. Its way is
// a path that never crosses the exact surface; among the places it can get to it is one nearest to the tool, but for
// what friction holds back (haptics/README 2).
//
//     proxy.place(surface, x)            once, where the tool begins
//     proxy.move(surface, x)             every tick
//     proxy.follow(before, now)          whenever another version of the model takes over
//
// Lengths are in model units, positions relative to the model's origin. A step takes no locks and, once its scratch has
// grown, no memory. One thread at a time.
#pragma once

#include "core/haptics/contacts.h"

namespace haptics {

struct ToolShape {
    double radius = 0;   ///< of the spherical tool, in model units; 0: a point
    double friction = 0; ///< coefficient of dry friction: largest tangential force over the normal force
    bool operator==(const ToolShape&) const = default;
};

class Proxy {
  public:
    /// Of steps in a tick: what a deadline permits, and what a trajectory with places far apart may want.
    static constexpr int timely = 32, patient = 2000;

    explicit Proxy(const ToolShape& tool = {}, int mostSteps = timely) : m_tool(tool), m_mostSteps(mostSteps) {}

    const ToolShape& tool() const { return m_tool; }
    /// Another tool from the next step on: a larger one is pushed out of what it is then in.
    void setTool(const ToolShape& tool) { m_tool = tool; }
    bool placed() const { return m_placed; }

    /// Begins at x. Inside of a closed model it begins on the surface, pressed outwards; open ones have no inside.
    void place(const surface::Surface& surface, const base::Vec3d& x);
    /// Takes the proxy along where the surface has moved since.
    void follow(const surface::Surface& before, const surface::Surface& now);
    /// Moves the proxy towards the tool at x. REQUIRES: placed.
    void move(const surface::Surface& surface, const base::Vec3d& x);

    /// The centre of the proxy: off the surface by the tool's radius where it touches.
    const base::Vec3d& position() const { return m_position; }
    /// Does the surface hold the proxy back from where the tool was last?
    bool touches() const { return m_depth > 0; }
    /// How far the tool is in the surface, along `normal`: the unit vector that the surface pushes along. Of several
    /// contacts the sum of what they do. 0 where it does not touch.
    double depth() const { return m_depth; }
    const base::Vec3d& normal() const { return m_normal; }
    const Contacts& contacts() const { return m_contacts; }

  private:
    struct Pull;
    struct Way;
    Pull pullOf(const base::Vec3d& x) const;
    base::Vec3d stepTo(const base::Vec3d& x) const;
    bool advance(const surface::Surface& surface, base::Vec3d step, const base::Vec3d& x);
    bool go(const surface::Surface& surface, const base::Vec3d& step, const Way& way);
    bool refresh(const surface::Surface& surface, const Way& way);
    void settle(const surface::Surface& surface, const Way& way);
    bool crossesFreely(const base::Vec3d& step) const;
    double leastUnit() const;

    ToolShape m_tool;
    int m_mostSteps, m_stepsLeft = 0;
    bool m_placed = false;
    base::Vec3d m_position, m_normal;
    double m_depth = 0;
    Contacts m_contacts;
    Surroundings m_surroundings;
};

} // namespace haptics
