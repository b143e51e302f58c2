#include "core/haptics/live.h"

#include <algorithm>
#include <chrono>
#include <pthread.h>

namespace haptics {

using std::chrono::steady_clock;

namespace {

constexpr double patchEvery = 0.002; ///< seconds: a tenth of what makes a patch stale
/// Metres that a tool may move before the next patch about it: at 1 m/s that is longer than a patch may last.
constexpr double reach = 0.03;
constexpr double late = 0.002;

/// False where the system does not permit it.
bool askForDeadlines() {
    sched_param priority{};
    priority.sched_priority = 50;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority) == 0;
}

steady_clock::duration seconds(double s) {
    return std::chrono::duration_cast<steady_clock::duration>(std::chrono::duration<double>(s));
}

} // namespace

ServoOptions Live::within(ServoOptions options) const {
    const DeviceLimits limits = m_device->limits();
    options.safety.mostForce = std::min(options.safety.mostForce, limits.force);
    options.law.stiffness = std::min(options.law.stiffness, limits.stiffness);
    options.port.mass = std::min(options.port.mass, limits.mass);
    options.port.delay = std::clamp(options.port.delay, limits.delay, Passivity::mostDelay);
    options.port.tick = Live::tick;
    return options;
}

Live::Live(std::unique_ptr<Device> device, const ServoOptions& options)
    : m_device(std::move(device)), m_options(within(options)), m_geometry([this] { followModel(); }),
      m_servo([this] { followDevice(); }) {}

Live::~Live() {
    m_stop = true;
    m_servo.join();
    m_geometry.join();
}

double Live::now() const {
    return std::chrono::duration<double>(steady_clock::now() - m_begin).count();
}

void Live::show(const surface::Surface& surface) {
    const std::lock_guard lock(m_mutex);
    m_newest = surface;
}

void Live::keep(PatchPtr patch) {
    std::erase_if(m_kept, [](const PatchPtr& each) { return each.use_count() == 1; });
    m_kept.push_back(std::move(patch));
}

void Live::followModel() {
    base::Vec3d tool = m_options.workspace.place({});
    const double around = m_options.tool.radius + reach * m_options.workspace.scale;
    PatchPtr last;
    for (auto next = steady_clock::now(); !m_stop; std::this_thread::sleep_until(next)) {
        next = std::max(next + seconds(patchEvery), steady_clock::now());
        if (const base::Vec3d* place = m_tool.take())
            tool = *place;
        surface::Surface surface;
        {
            const std::lock_guard lock(m_mutex);
            surface = m_newest;
        }
        if (surface.tree().empty())
            continue;
        const bool same = last && last->surface.tree() == surface.tree() &&
                          last->surface.definition() == surface.definition() &&
                          base::distance(base::cast<double>(last->warm.centre()), tool) < 0.5 * around;
        last =
            same ? std::make_shared<Patch>(Patch{surface, now(), last->warm}) : makePatch(surface, tool, around, now());
        keep(last);
        m_patches.put(last);
    }
}

void Live::followDevice() {
    m_realtime = askForDeadlines();
    Servo servo(m_options);
    Calibration calibration(m_options.workspace);
    DeviceState state;
    bool touches = false, heard = false; // before the device says where it is nothing can be felt
    PatchPtr patch;
    double device = -SafetyLimits::none, before = now();
    for (auto next = steady_clock::now(); !m_stop && !m_device->ended(); std::this_thread::sleep_until(next)) {
        next += seconds(tick);
        const double time = now();
        m_missed += time - before > late ? 1 : 0;
        before = time;
        if (const ServoOptions* tuned = m_tuned.take())
            servo.tune(*tuned);
        if (const ViewFrame* frame = m_looks.take())
            calibration.look(*frame);
        if (m_device->read(state)) {
            device = time;
            heard = true;
            servo.setWorkspace(calibration.step(state, touches));
            m_states.put(state);
        }
        m_connected = m_device->connected();
        if (const PatchPtr* newest = m_patches.take())
            patch = *newest;
        const Tick done = servo.step(heard ? patch : nullptr, state, {time, 0, device, m_focus});
        m_device->send(done.sent);
        touches = done.contact || done.touched.working();
        m_tool.put(done.proxy);
        m_told.put(done);
        ++m_ticks;
    }
    m_device->send({});
    m_ended = true;
}

} // namespace haptics
