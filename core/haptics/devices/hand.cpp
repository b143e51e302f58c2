#include "core/haptics/devices/hand.h"

#include <deque>
#include <limits>

namespace haptics {

using base::Vec3d;

namespace {

class Hand final : public Device {
  public:
    Hand(const Trajectory& trajectory, const HandModel& model)
        : m_trajectory(trajectory), m_model(model), m_forces(model.delay + 1) {
        m_state = {trajectory.front().place, {}, 0, trajectory.front().time};
    }

    bool read(DeviceState& out) override {
        if (ended())
            return false;
        if (m_ticks++ > 0)
            swing(m_forces.front());
        out = m_state;
        return true;
    }
    void send(const Vec3d& force) override {
        m_forces.push_back(force);
        m_forces.pop_front();
    }
    bool ended() const override { return m_state.time >= m_trajectory.back().time + m_model.settling; }
    DeviceLimits limits() const override {
        return {std::numeric_limits<double>::infinity(), 3000, m_model.mass, m_model.delay};
    }

  private:
    /// One tick under a constant force; semi-implicit Euler, which does not gain energy.
    void swing(const Vec3d& force) {
        constexpr int parts = 20;
        const double step = m_model.tick / parts;
        for (int i = 0; i < parts; ++i) {
            const double t = m_state.time + step;
            const Vec3d wanted = placeAt(m_trajectory, t);
            const Vec3d pull = (wanted - m_state.position) * m_model.muscle - m_state.velocity * m_model.damping;
            m_state.velocity += (pull + force) * (step / m_model.mass);
            m_state.position += m_state.velocity * step;
            m_state.time = t;
        }
    }

    Trajectory m_trajectory;
    HandModel m_model;
    std::deque<Vec3d> m_forces; ///< under way; the front acts
    DeviceState m_state;
    std::size_t m_ticks = 0;
};

} // namespace

std::unique_ptr<Device> makeHand(const Trajectory& trajectory, const HandModel& model) {
    requireValid(trajectory);
    return std::make_unique<Hand>(trajectory, model);
}

std::unique_ptr<Device> openHand(const DeviceSetup& setup) {
    return makeHand(setup.trajectory, {});
}

} // namespace haptics
