#include "ui/work/section_tracer.h"

#include "core/cells/cell_section.h"

namespace ui {

SectionTracer::SectionTracer(Deliver deliver, std::function<void(const std::exception&)> failed)
    : m_worker(
          [deliver = std::move(deliver)](const Request& request, const base::Progress& progress) {
              TracedSections out{request.planes, {}};
              for (const base::Plane& plane : request.planes.all())
                  out.curves.push_back(cells::findSection(request.surface, plane, progress));
              deliver(std::move(out));
          },
          std::move(failed)) {}

void SectionTracer::request(const surface::Surface& surface, const render::ClipPlanes& planes) {
    m_worker.request({surface, planes}, !(m_asked == planes));
    m_asked = planes;
}

} // namespace ui
