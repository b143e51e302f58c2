#include "core/haptics/devices/line_device.h"

#include "core/haptics/devices/line.h"
#include "core/haptics/mailbox.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace haptics {

using base::Vec3d;
using std::chrono::steady_clock;

namespace {

constexpr std::size_t mostAtOnce = 1 << 16;                     ///< bytes read before the force has its turn
constexpr int triesApart = 250, patience = 2000, farewell = 50; ///< milliseconds
constexpr double staleForce = 0.020;

double secondsSince(steady_clock::time_point then) {
    return std::chrono::duration<double>(steady_clock::now() - then).count();
}

class LineDevice final : public Device {
  public:
    LineDevice(LineAddress address, std::string name, const LineRow& row)
        : m_address(std::move(address)), m_name(std::move(name)), m_row(row), m_thread([this] { keep(); }) {}
    ~LineDevice() override {
        m_stop = true;
        m_thread.join();
    }

    bool read(DeviceState& out) override {
        const DeviceState* newest = m_states.take();
        if (newest)
            out = *newest;
        return newest != nullptr;
    }
    void send(const Vec3d& force) override { m_forces.put({force, steady_clock::now()}); }
    bool ended() const override { return false; }
    bool connected() const override { return m_connected; }
    DeviceLimits limits() const override { return m_row.limits; }

  private:
    struct Force {
        Vec3d newtons;
        steady_clock::time_point when;
    };

    void keep() {
        while (!m_stop) {
            Line line;
            if (connect(line))
                speak(line);
            m_connected = false;
            for (int waited = 0; waited < triesApart && !m_stop; waited += 10)
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }

    bool connect(Line& line) {
        line.open(m_address);
        for (int waited = 0; !line.failed() && !line.connected() && waited < patience && !m_stop; waited += 10)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return line.connected();
    }

    void speak(Line& line) {
        const auto protocol = m_row.make(m_name);
        std::string in, out;
        m_force = {};
        protocol->begin(out);
        while (!m_stop && !line.failed()) {
            line.wait(1, !out.empty());
            line.read(in, mostAtOnce);
            std::optional<DeviceState> state;
            if (!protocol->take(in, out, state) || in.size() > mostWaiting || out.size() > mostWaiting)
                break;
            if (state && isFinite(state->position) && isFinite(state->velocity) && isFinite(state->turning)) {
                m_connected = true;
                m_states.put(*state);
            }
            if (out.empty()) // behind what waits it would come late, and be acted on as if it were new
                protocol->force(newestForce(), out);
            line.write(out);
        }
        protocol->end(out);
        const auto since = steady_clock::now();
        while (!line.failed() && !out.empty() && secondsSince(since) < 0.001 * farewell) {
            line.wait(5, true);
            line.write(out);
        }
    }

    Vec3d newestForce() {
        if (const Force* newest = m_forces.take())
            m_force = *newest;
        return secondsSince(m_force.when) > staleForce || !isFinite(m_force.newtons) ? Vec3d{} : m_force.newtons;
    }

    LineAddress m_address;
    std::string m_name;
    LineRow m_row;
    Mailbox<DeviceState> m_states; ///< from the line to the servo
    Mailbox<Force> m_forces;       ///< and back
    Force m_force;
    std::atomic<bool> m_stop = false, m_connected = false;
    std::thread m_thread; ///< last
};

} // namespace

std::unique_ptr<Device> openLineDevice(const std::string& address, const LineRow& row) {
    const std::size_t at = address.starts_with('/') ? std::string::npos : address.find('@'); // paths may hold some
    const std::string name = at == std::string::npos ? std::string() : address.substr(0, at);
    return std::make_unique<LineDevice>(lineAddress(at == std::string::npos ? address : address.substr(at + 1)), name,
                                        row);
}

} // namespace haptics
