// Traces sections away from the interface's thread. Only the latest request counts; one that is being worked on is
// stopped where its planes are no longer wanted, and finished where only the model has changed, so that curves follow
// a stroke.
#pragma once

#include "core/surface/section.h"
#include "ui/render/clip_planes.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace ui {

/// The curves of each plane, in the order of the planes.
struct TracedSections {
    render::ClipPlanes planes;
    std::vector<std::vector<surface::SectionCurve>> curves;
};

class SectionTracer {
  public:
    using Deliver = std::function<void(TracedSections)>;

    /// `deliver` is called on the tracing thread.
    explicit SectionTracer(Deliver deliver);
    ~SectionTracer();
    void request(const surface::Surface& surface, const render::ClipPlanes& planes); ///< any thread

  private:
    struct Request {
        surface::Surface surface;
        render::ClipPlanes planes;
    };
    void work();

    Deliver m_deliver;
    std::mutex m_mutex;
    std::condition_variable m_asked;
    std::optional<Request> m_request;
    render::ClipPlanes m_current; ///< being worked on
    std::atomic<bool> m_cancel = false;
    bool m_ending = false;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace ui
