// Sculpting by touch: contact is hover, pressing beyond a threshold makes the tool work with a strength that follows
// from the force, and tools that hold take what they press on along until the hand rests (haptics/README 8).
//
//     Hovers --pressed beyond the threshold--> Works  --less than half of it, or let go--> Hovers
//                                        \---> Holds  --rests after a pull, or tears-----> Hovers, and again only
//                                                                                          after it was not pressed
//
// Clay is felt as viscous: a damper while the tool works, a Maxwell element (spring and damper in series) while it
// holds. Plain values of one tick each; knows no tool by name and changes nothing.
#pragma once

#include "core/haptics/proxy.h"

#include <cstdint>

namespace haptics {

/// Forces are in newtons, those of the device; lengths in model units.
struct TouchLaw {
    bool works = false; ///< off: the model is only felt
    bool holds = false; ///< the tool takes hold of what it presses on
    double threshold = 0.5;
    double full = 3;                       ///< the force of pressure 1
    double viscosity = 0;                  ///< newton seconds per metre of the hand
    double tear = 8;                       ///< a pull of more than this tears the hold
    double slack = 0;                      ///< a hold that was pulled farther than this ends where the hand rests
    double above = 0;                      ///< samples begin so far above the clay, where there is room
    static constexpr double release = 0.5; ///< of the threshold: less ends the work
    bool operator==(const TouchLaw&) const = default;
};

enum class Touching { Nothing, Hovers, Works, Holds };

struct Touched {
    Touching phase = Touching::Nothing;
    std::uint64_t stroke = 0; ///< how many have begun
    base::Vec3d place;        ///< on the clay: where the tool works, where what it holds is to be
    base::Vec3d normal;       ///< of the clay there, towards the tool; while it holds, where the hold began
    double room = 0;          ///< above `place` along `normal`, at most TouchLaw::above
    double pressure = 0;      ///< 0 to 1
    double seconds = 0;       ///< since the stroke began

    bool working() const { return phase >= Touching::Works; }
};

/// What a tick of the servo knows.
struct TouchTick {
    double time = 0;
    base::Vec3d tool, velocity; ///< in the model
    base::Vec3d force;          ///< of the law
    double stiffness = 1;       ///< newtons per metre
    double scale = 1;           ///< model units per metre
    bool held = false;          ///< a button keeps hold of what is held
};

class Touch {
  public:
    explicit Touch(const TouchLaw& law = {}) : m_law(law) {}

    const TouchLaw& law() const { return m_law; }
    /// Another law from the next tick on; what goes on ends where the new one would not have begun it.
    void setLaw(const TouchLaw& law);
    /// The force with what the clay does to the tool, in the units of `at.force`. Once a tick.
    base::Vec3d step(const TouchTick& at, const Proxy& proxy, const surface::Surface& surface);
    const Touched& now() const { return m_now; }

  private:
    void begin(const TouchTick& at, const Proxy& proxy, const surface::Surface& surface);
    void work(const TouchTick& at, const Proxy& proxy, const surface::Surface& surface, double pressing);
    void hold(const TouchTick& at, double seconds);
    double roomAbove(const surface::Surface& surface, const Foot& foot) const;

    TouchLaw m_law;
    Touched m_now;
    double m_last = 0, m_begun = 0; ///< times
    bool m_first = true, m_pressed = false;
    // Of a hold.
    base::Vec3d m_from, m_clay, m_foot; ///< tool and clay's element where it began and now, what was held
    base::Vec3d m_pull;                 ///< its force
    double m_share = 0;                 ///< 1 while holding, 0 otherwise, and in between for a moment
    double m_resting = 0;               ///< seconds
    bool m_pulled = false;
};

} // namespace haptics
