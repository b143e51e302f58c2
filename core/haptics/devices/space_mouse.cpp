#include "core/haptics/devices/space_mouse.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace haptics {

using base::Vec3d;

namespace {

/// Of an axis at its stop, about; and what that is in metres and radians a second.
constexpr double fullAxis = 350, fullSpeed = 0.1, fullTurn = 1.5;
/// Events that come later than this moved nothing meanwhile.
constexpr int longestPeriod = 50;

class SpaceMouse final : public LineProtocol {
  public:
    void begin(std::string&) override {}
    bool take(std::string& in, std::string&, std::optional<DeviceState>& state) override {
        std::array<std::int32_t, 8> event{};
        std::size_t done = 0;
        for (; in.size() - done >= sizeof event; done += sizeof event) {
            std::memcpy(event.data(), in.data() + done, sizeof event);
            if (!apply(event))
                return false;
            state = m_state;
        }
        in.erase(0, done);
        return true;
    }
    void force(const Vec3d&, std::string&) override {}
    void end(std::string&) override {}

  private:
    static double axis(std::int32_t value) { return std::clamp(static_cast<double>(value) / fullAxis, -1.5, 1.5); }
    bool apply(const std::array<std::int32_t, 8>& event) {
        if (event[0] == 0) {
            const double seconds = 0.001 * std::clamp(event[7], 0, longestPeriod);
            m_state.velocity = Vec3d{axis(event[1]), axis(event[2]), -axis(event[3])} * fullSpeed;
            m_state.turning = Vec3d{axis(event[4]), axis(event[5]), -axis(event[6])} * fullTurn;
            m_state.position += m_state.velocity * seconds;
            m_state.time += seconds;
        } else if (event[0] == 1 || event[0] == 2) {
            if (event[1] < 0 || event[1] > 255)
                return false;
            const unsigned bit = event[1] < 31 ? 1u << event[1] : 0;
            m_state.buttons = event[0] == 1 ? m_state.buttons | bit : m_state.buttons & ~bit;
        } else {
            return event[0] > 0 && event[0] < 256; // later kinds of spacenavd
        }
        return true;
    }

    DeviceState m_state;
};

} // namespace

std::unique_ptr<LineProtocol> makeSpaceMouse(const std::string&) {
    return std::make_unique<SpaceMouse>();
}

std::unique_ptr<Device> openSpaceMouse(const DeviceSetup& setup) {
    constexpr double none = std::numeric_limits<double>::infinity();
    return openLineDevice(setup.address.empty() ? "/var/run/spnav.sock" : setup.address,
                          {makeSpaceMouse, {none, none, none}});
}

} // namespace haptics
