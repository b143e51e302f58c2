#include "ui/section_tracer.h"

namespace ui {

SectionTracer::SectionTracer(Deliver deliver) : m_deliver(std::move(deliver)) {
    m_thread = std::thread([this] { work(); });
}

SectionTracer::~SectionTracer() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
        m_cancel = true;
    }
    m_asked.notify_one();
    m_thread.join();
}

void SectionTracer::request(const surface::Surface& surface, const render::ClipPlanes& planes) {
    {
        const std::lock_guard lock(m_mutex);
        m_request = Request{surface, planes};
        if (!(m_current == planes))
            m_cancel = true;
    }
    m_asked.notify_one();
}

void SectionTracer::work() {
    for (;;) {
        Request request;
        {
            std::unique_lock lock(m_mutex);
            m_asked.wait(lock, [this] { return m_ending || m_request; });
            if (m_ending)
                return;
            request = std::move(*m_request);
            m_request.reset();
            m_current = request.planes;
            m_cancel = false;
        }
        base::Progress progress;
        progress.cancel = &m_cancel;
        try {
            TracedSections out{request.planes, {}};
            for (const base::Plane& plane : request.planes.all())
                out.curves.push_back(findSection(request.surface, plane, progress));
            m_deliver(std::move(out));
        } catch (const base::Cancelled&) {
            // another request waits, or the end
        }
    }
}

} // namespace ui
