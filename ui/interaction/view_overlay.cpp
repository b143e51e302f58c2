#include "ui/interaction/view_overlay.h"

#include "ui/overlay/annotation_overlay.h"
#include "ui/overlay/gone_overlay.h"
#include "ui/overlay/pick_overlay.h"
#include "ui/overlay/pivot_overlay.h"
#include "ui/overlay/section_overlay.h"
#include "ui/overlay/symmetry_overlay.h"

#include <QPainter>

namespace ui {

using Gesture = PointerRouter::Gesture;

void ViewOverlay::paint(QPainter& painter, double pixelRatio) const {
    painter.save();
    painter.scale(1 / pixelRatio, 1 / pixelRatio);
    const Snapshot& now = m_parts.editor.snapshot();
    const Settings& settings = m_parts.settings;
    const ViewMotion& motion = m_parts.motion;
    const render::Camera seen = motion.shownCamera();
    if (beneath)
        beneath(painter, seen);
    paintGone(painter, gone, seen, pixelRatio);
    if (m_parts.cuts.sections().size() == seen.clips.all().size())
        paintSections(painter, sectionLines(m_parts.cuts.sections(), seen), 1.6 * pixelRatio);
    paintSections(painter, curveLines(m_parts.edges.visible(seen), seen), 1.2 * pixelRatio);
    const bool turning = m_parts.pointer.gesture() == Gesture::Orbit;
    if (motion.view().picked || turning)
        paintPivot(painter, motion.view().turningPoint(), seen, turning);
    const surface::Surface& surface = now.surface;
    if (settings.shared.symmetry != sculpt::Symmetry{} && !surface.tree().empty())
        ui::paint(painter,
                  SymmetryOverlay{settings.shared.symmetry, now.origin, surface.tree().bounds(), m_parts.cursor.contact,
                                  &m_parts.symmetry.curves(), 1.5 * pixelRatio},
                  seen);
    paintSource(painter, seen);
    const render::RenderOptions look = m_parts.look.options();
    ui::paint(painter,
              render::annotate(settings.annotated, seen, m_parts.look.scale(), settings.backdrop, look.pixelScale));
    if (!motion.navigator().flying() && !m_parts.picker.on() && !m_parts.placement.held())
        ui::paint(painter, m_parts.cursor, seen);
    paintOutline(painter, m_parts.picker.outline(), m_parts.picker.shape() == PickShape::Rectangle, pixelRatio);
    m_parts.placement.paint(painter, seen);
    ui::paint(painter, m_parts.touch.look(), seen, pixelRatio);
    if (above)
        above(painter, seen);
    ui::paint(painter, notice, seen.width, pixelRatio);
    painter.restore();
}

/// During a stroke the source goes along with the brush.
void ViewOverlay::paintSource(QPainter& painter, const render::Camera& seen) const {
    const std::optional<base::Vec3d>& place = m_parts.source.place();
    if (!place || !m_parts.settings.toolRow().needs.source)
        return;
    const std::optional<BrushContact>& contact = m_parts.cursor.contact;
    const bool going = m_parts.pointer.gesture() == Gesture::Sculpt && contact;
    ui::paintSource(painter, *place + (going ? contact->position - m_parts.strokes.start() : base::Vec3d{}), seen);
}

} // namespace ui
