// All that is painted over the picture: section curves, sharp edges, the pivot, symmetry, the clone source,
// annotations, the brush, a notice of what is still working. Interface's thread only.
#pragma once

#include "ui/interaction/edge_lines.h"
#include "ui/interaction/picker.h"
#include "ui/interaction/picture_look.h"
#include "ui/interaction/placement_tool.h"
#include "ui/interaction/pointer_router.h"
#include "ui/interaction/symmetry_curves.h"
#include "ui/interaction/touch_input.h"
#include "ui/overlay/notice_overlay.h"

namespace ui {

class ViewOverlay {
  public:
    /// What is shown; all of it outlives the overlay.
    struct Parts {
        const Editor& editor;
        const Settings& settings;
        const ViewMotion& motion;
        const CutPlanes& cuts;
        const EdgeLines& edges;
        const SymmetryCurves& symmetry;
        const CloneSource& source;
        const StrokeInput& strokes;
        const PictureLook& look;
        const PointerRouter& pointer;
        const BrushCursor& cursor;
        const TouchInput& touch;
        const Picker& picker;
        const PlacementTool& placement;
    };
    explicit ViewOverlay(const Parts& parts) : m_parts(parts) {}

    /// Paints for the camera that the picture shows. The painter is a widget's, `pixelRatio` device pixels to a unit.
    void paint(QPainter& painter, double pixelRatio) const;
    /// Painted before all of that, and after, in device pixels of the camera.
    std::function<void(QPainter&, const render::Camera&)> beneath, above;
    std::vector<base::Vec3d> gone; ///< places of surfels that a command would take out
    Notice notice;                 ///< painted last

  private:
    void paintSource(QPainter& painter, const render::Camera& seen) const;

    Parts m_parts;
};

} // namespace ui
