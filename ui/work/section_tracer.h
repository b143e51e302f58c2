// Traces sections off the interface's thread. Only the latest request counts; the one at work is stopped if its planes
// are no longer wanted, and finished if only the model has changed, so that curves follow a stroke.
#pragma once

#include "core/render/clip_planes.h"
#include "core/surface/curves/section.h"
#include "ui/work/latest_worker.h"

namespace ui {

/// The curves of each plane, in the order of the planes.
struct TracedSections {
    render::ClipPlanes planes;
    std::vector<std::vector<surface::SectionCurve>> curves;
};

class SectionTracer {
  public:
    using Deliver = std::function<void(TracedSections)>;

    /// Both are called on the tracing thread.
    SectionTracer(Deliver deliver, std::function<void(const std::exception&)> failed);
    void request(const surface::Surface& surface, const render::ClipPlanes& planes); ///< one thread

  private:
    struct Request {
        surface::Surface surface;
        render::ClipPlanes planes;
    };

    render::ClipPlanes m_asked; ///< last
    LatestWorker<Request> m_worker;
};

} // namespace ui
