// Passivity observer and controller in the time domain [Hannaford02]: what a sampled spring would give to the hand
// beyond what the hand has put in is taken from the force before it acts (haptics/README 4).
//
// Newtons, metres, seconds, joules of the device. A plain value, one thread; takes no memory.
#pragma once

#include "core/base/vec.h"

#include <array>
#include <cstddef>
#include <limits>

namespace haptics {

struct Port {
    std::size_t delay = 0; ///< ticks from when a force is computed until it acts, for one tick
    /// The least mass that forces accelerate, the device's and the hand's: kilograms where forces are newtons.
    double mass = std::numeric_limits<double>::infinity();
    double tick = 0.001; ///< seconds
    /// What a hand that has been calm may all at once do to its speed, in metres per second squared; who was seen to do
    /// more may do so again.
    double acceleration = 5;
    /// How far told positions are from the true ones at most.
    double resolution = 0;
};

/// What makes the force, as far as it stores what the hand puts in.
struct Spring {
    double stiffness = 0; ///< 0: nobody knows, and nothing that was put in is ever forgotten
    double length = 0;    ///< of what it is pressed by
};

class Passivity {
  public:
    static constexpr std::size_t mostDelay = 8;
    /// What may be given to the hand beyond what it put in: without it no contact could begin. A little comes anew with
    /// time where all is gone, so that a hand that once was paid too much feels something again.
    static constexpr double allowance = 5e-7, alms = 1e-8, almsSeconds = 0.1;

    /// REQUIRES: port.delay <= mostDelay.
    explicit Passivity(const Port& port = {}) : m_port(port) {}

    const Port& port() const { return m_port; }
    /// Of the force computed for a tool at x, what may be sent. Called once for each state of the device, in order;
    /// `seconds` is the time since the one before, where it is not a tick.
    base::Vec3d limit(const base::Vec3d& x, const base::Vec3d& force, const Spring& spring = {}, double seconds = 0);
    /// Where nothing new is known of the device: what was sent, or less if no more than `force` is wanted.
    base::Vec3d hold(const base::Vec3d& force);
    /// Work done on the hand so far, by the forces sent and the ways told.
    double workOnHand() const { return m_work; }
    /// What may still be given: what the hand has put in and not got back, of it no more than the spring holds.
    double left() const { return m_left; }

  private:
    double slack(std::size_t ticks) const;
    void observe(const base::Vec3d& way, double ticks);
    double half() const { return 0.5 * m_port.tick * m_port.tick / m_port.mass; }

    Port m_port;
    std::array<base::Vec3d, mostDelay + 1> m_sent{}; ///< the one that acts first comes first
    base::Vec3d m_acted;                             ///< over the last tick
    bool m_begun = false;
    base::Vec3d m_last, m_way; ///< the last place, the way of a tick at the speed that it was come to by
    double m_shake = 0;        ///< what the hand lately did to a way, in metres
    double m_work = 0, m_left = allowance, m_waited = 0;
};

} // namespace haptics
