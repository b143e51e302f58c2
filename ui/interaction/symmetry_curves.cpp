#include "ui/interaction/symmetry_curves.h"

#include "ui/work/post.h"

namespace ui {

using base::Vec3d;

SymmetryCurves::SymmetryCurves(const Editor& editor, QObject* parent) : QObject(parent), m_editor(editor) {}

SymmetryCurves::~SymmetryCurves() = default;

/// What is mirrored at is zero in the file's coordinates.
static base::Plane planeOf(int axis, const Vec3d& origin) {
    Vec3d normal;
    normal[static_cast<std::size_t>(axis)] = 1;
    return {normal, -origin[static_cast<std::size_t>(axis)]};
}

static int axisOf(const base::Plane& plane) {
    return plane.normal.x != 0 ? 0 : plane.normal.y != 0 ? 1 : 2;
}

void SymmetryCurves::trace(const sculpt::MirrorPlanes& planes) {
    const Snapshot& now = m_editor.snapshot();
    const bool on[] = {planes.x, planes.y, planes.z};
    render::ClipPlanes wanted;
    for (int axis = 0; axis < 3; ++axis) {
        if (on[axis])
            wanted.add(planeOf(axis, now.origin));
        else
            m_curves[static_cast<std::size_t>(axis)].clear();
    }
    const bool traceable =
        !now.surface.tree().empty() && now.surface.definition().manifold == surface::Manifold::Surface;
    if (wanted.empty() || !traceable) {
        m_curves = {};
        m_root = nullptr;
        m_planes = {};
        return;
    }
    if (m_root == now.surface.tree().root().get() && m_planes == wanted)
        return;
    m_root = now.surface.tree().root().get();
    m_planes = wanted;
    if (!m_tracer) // what cannot be traced is not shown: nothing that a person asked for has failed
        m_tracer = std::make_unique<SectionTracer>(
            [this](TracedSections traced) { post(this, [this, traced = std::move(traced)] { receive(traced); }); },
            [](const std::exception&) {});
    m_tracer->request(now.surface, wanted);
}

void SymmetryCurves::receive(const TracedSections& found) {
    if (!(found.planes == m_planes))
        return; // others are on their way
    const auto planes = found.planes.all();
    for (std::size_t k = 0; k < planes.size(); ++k)
        m_curves[static_cast<std::size_t>(axisOf(planes[k]))] = found.curves[k];
    Q_EMIT traced();
}

} // namespace ui
