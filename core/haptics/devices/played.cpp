#include "core/haptics/devices/played.h"

#include <limits>

namespace haptics {

namespace {

class Played final : public Device {
  public:
    explicit Played(Trajectory trajectory) : m_trajectory(std::move(trajectory)) {}

    bool read(DeviceState& out) override {
        if (ended())
            return false;
        const TimedPlace& at = m_trajectory[m_next];
        out = {at.place, {}, 0, at.time};
        if (m_next > 0) {
            const TimedPlace& before = m_trajectory[m_next - 1];
            out.velocity = (at.place - before.place) / (at.time - before.time);
        }
        ++m_next;
        return true;
    }
    void send(const base::Vec3d&) override {}
    bool ended() const override { return m_next == m_trajectory.size(); }
    DeviceLimits limits() const override {
        constexpr double none = std::numeric_limits<double>::infinity();
        return {none, none, none};
    }

  private:
    Trajectory m_trajectory;
    std::size_t m_next = 0;
};

} // namespace

std::unique_ptr<Device> openPlayed(const DeviceSetup& setup) {
    requireValid(setup.trajectory);
    return std::make_unique<Played>(setup.trajectory);
}

} // namespace haptics
