// A device that is felt: the geometry thread, which follows the model, and the servo thread, which follows the device a
// thousand times a second (haptics/README 6).
//
//     Live live(device, options);      both threads run
//     live.show(surface)               whenever there is a new version; any thread
//     live.focus(false)                forces are zero until focus(true); any thread
//     live.newest()                    what the servo did last; one thread, at its leisure
//
// The servo takes no locks. Destroying it sends a zero force and joins both.
#pragma once

#include "core/haptics/calibration.h"
#include "core/haptics/mailbox.h"
#include "core/haptics/servo.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <mutex>
#include <thread>

namespace haptics {

class Live {
  public:
    static constexpr double tick = 0.001; ///< seconds

    Live(std::unique_ptr<Device> device, const ServoOptions& options);
    ~Live();
    Live(const Live&) = delete;
    Live& operator=(const Live&) = delete;

    void show(const surface::Surface& surface);
    void focus(bool has) { m_focus = has; }
    /// Another tool, stiffness, what it does: from the next tick on, within what the device can. One thread.
    void tune(const ServoOptions& options) { m_tuned.put(within(options)); }
    /// The view is another one. One thread.
    void look(const ViewFrame& frame) { m_looks.put(frame); }
    /// The device is there.
    bool connected() const { return m_connected; }
    /// The newest state of the device, as it tells it. One thread.
    const DeviceState* state() { return m_states.take(); }
    /// Null where there is nothing new since the last call.
    const Tick* newest() { return m_told.take(); }

    /// The servo thread has a deadline that the system keeps (SCHED_FIFO); elsewhere ticks may come late.
    bool realtime() const { return m_realtime; }
    std::uint64_t ticks() const { return m_ticks; }
    /// Ticks that came more than 2 ms after the one before.
    std::uint64_t missed() const { return m_missed; }
    /// The device has ended.
    bool ended() const { return m_ended; }

  private:
    double now() const;
    /// What a device can do goes before what is asked for.
    ServoOptions within(ServoOptions options) const;
    void followModel();
    void followDevice();
    /// Keeps what was published until the servo has let go of it, so that it never frees memory.
    void keep(PatchPtr patch);

    std::unique_ptr<Device> m_device;
    ServoOptions m_options;
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();

    std::mutex m_mutex; ///< of m_newest; the servo does not take it
    surface::Surface m_newest;

    Mailbox<PatchPtr> m_patches; ///< geometry to servo
    Mailbox<base::Vec3d> m_tool; ///< servo to geometry
    Mailbox<Tick> m_told;        ///< servo to whoever shows it
    Mailbox<DeviceState> m_states;
    Mailbox<ServoOptions> m_tuned; ///< and back
    Mailbox<ViewFrame> m_looks;
    std::deque<PatchPtr> m_kept;
    std::atomic<bool> m_stop = false, m_focus = true, m_realtime = false, m_ended = false, m_connected = false;
    std::atomic<std::uint64_t> m_ticks = 0, m_missed = 0;
    std::thread m_geometry, m_servo; ///< last: everything else is there before they run
};

} // namespace haptics
