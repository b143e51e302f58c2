#include "core/haptics/devices/mouse.h"

#include "core/base/error.h"

#include <limits>

namespace haptics {

namespace {

class Mouse final : public Device {
  public:
    explicit Mouse(std::shared_ptr<Mailbox<DeviceState>> pointer) : m_pointer(std::move(pointer)) {}

    /// A mouse that rests says nothing and is where it was: that is no silence.
    bool read(DeviceState& out) override {
        const DeviceState* newest = m_pointer->take();
        if (newest) {
            const double seconds = newest->time - m_state.time;
            const base::Vec3d way = newest->position - m_state.position;
            m_state = *newest;
            m_state.velocity = m_heard && seconds > 0 ? way / seconds : base::Vec3d{};
            m_heard = true;
        } else {
            m_state.velocity = {};
        }
        out = m_state;
        return m_heard;
    }
    void send(const base::Vec3d&) override {}
    bool ended() const override { return false; }
    bool connected() const override { return m_heard; }
    DeviceLimits limits() const override {
        constexpr double none = std::numeric_limits<double>::infinity();
        return {none, none, none};
    }

  private:
    std::shared_ptr<Mailbox<DeviceState>> m_pointer;
    DeviceState m_state;
    std::atomic<bool> m_heard = false;
};

} // namespace

std::unique_ptr<Device> openMouse(const DeviceSetup& setup) {
    if (!setup.pointer)
        throw base::Error("a mouse can be felt with in the window only");
    return std::make_unique<Mouse>(setup.pointer);
}

} // namespace haptics
