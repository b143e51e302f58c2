#include "ui/interaction/cut_planes.h"

#include "ui/work/post.h"

namespace ui {

CutPlanes::CutPlanes(const Editor& editor, QObject* parent) : QObject(parent), m_editor(editor) {}

CutPlanes::~CutPlanes() = default;

void CutPlanes::set(const Cuts& cuts) {
    m_cuts = cuts;
    trace();
    Q_EMIT moved();
}

void CutPlanes::reset() {
    const bool section = m_cuts.section;
    m_cuts = {};
    m_cuts.section = section;
    const base::Box3f box = m_editor.snapshot().surface.tree().bounds();
    for (Cut& cut : m_cuts.each)
        cut.offset = offsetRange(box, cut.normal).middle();
    Q_EMIT changed();
}

void CutPlanes::turnFreePlane(const base::Vec3d& towardsEye) {
    Cuts cuts = m_cuts;
    Cut& cut = cuts.each[Cuts::free];
    cut.normal = base::normalized(towardsEye);
    cut.offset = offsetRange(m_editor.snapshot().surface.tree().bounds(), cut.normal).middle();
    cut.flipped = false;
    set(cuts);
    Q_EMIT changed();
}

void CutPlanes::trace() {
    const render::ClipPlanes planes = m_cuts.planes();
    const surface::Surface& surface = m_editor.snapshot().surface;
    if (!m_cuts.section || planes.empty() || surface.definition().manifold != surface::Manifold::Surface) {
        m_sections.clear();
        m_tracedRoot = nullptr;
        return;
    }
    if (m_tracedRoot == surface.tree().root().get() && m_tracedPlanes == planes)
        return;
    if (m_tracedPlanes != planes) // curves of other planes would hang in the air
        m_sections.clear();
    m_tracedRoot = surface.tree().root().get();
    m_tracedPlanes = planes;
    if (!m_tracer)
        m_tracer = std::make_unique<SectionTracer>(
            [this](TracedSections traced) { post(this, [this, traced = std::move(traced)] { receive(traced); }); },
            [this](const std::exception& error) { post(this, [this, text = textOf(error)] { Q_EMIT failed(text); }); });
    m_tracer->request(surface, planes);
}

void CutPlanes::receive(TracedSections found) {
    if (!m_cuts.section || found.planes != m_cuts.planes())
        return; // others are on their way
    m_sections = std::move(found.curves);
    Q_EMIT traced();
}

} // namespace ui
