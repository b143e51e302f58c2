#include "ui/interaction/sculpt_view.h"

#include "ui/interaction/framing.h"

#include <QPainter>
#include <QWidget>

namespace ui {

SculptView::SculptView(Editor& editor, Settings& settings, Viewport& viewport, QObject* parent)
    : QObject(parent), m_editor(editor), m_settings(settings), m_viewport(viewport), m_cuts(editor), m_edges(editor),
      m_symmetry(editor), m_motion(editor, m_cuts, *viewport.widget()),
      m_sizing(settings, m_motion, *viewport.widget()), m_source(editor),
      m_strokes(editor, settings, m_motion, m_sizing, m_source),
      m_flight(m_motion.navigator(), editor, *viewport.widget()), m_look(editor, settings, *viewport.widget()),
      m_cursor(editor, settings, m_motion, m_sizing, *viewport.widget()),
      m_pointer({editor, settings, m_motion, m_flight, m_sizing, m_source, m_strokes, m_cursor}, *viewport.widget()),
      m_touch({editor, settings, m_motion, m_sizing, m_source, m_pointer}, *viewport.widget()),
      m_picker(editor, m_motion, *viewport.widget()), m_placement(m_motion, *viewport.widget()),
      m_overlay({editor, settings, m_motion, m_cuts, m_edges, m_symmetry, m_source, m_strokes, m_look, m_pointer,
                 m_cursor.cursor(), m_touch, m_picker, m_placement}) {
    viewport.paintOverlay = [this](QPainter& painter) {
        m_overlay.paint(painter, m_viewport.widget()->devicePixelRatioF());
    };
    connectParts();
    connect(&editor, &Editor::changed, this, &SculptView::followModel);
    m_motion.navigator().chooseStyle(navigation(settings.navigation));
}

SculptView::~SculptView() = default;

void SculptView::connectParts() {
    connect(&m_motion, &ViewMotion::moved, this, [this](bool more) {
        m_viewInput = m_pointer.inputs();
        refresh(more);
    });
    connect(&m_pointer, &PointerRouter::pictureChanged, this, &SculptView::refresh);
    connect(&m_sizing, &BrushSizing::changed, &m_pointer, &PointerRouter::followCursor);
    connect(&m_cuts, &CutPlanes::moved, this, [this] { refresh(true); });
    connect(&m_cuts, &CutPlanes::traced, this, [this] { m_viewport.widget()->update(); });
    connect(&m_edges, &EdgeLines::looked, this, [this] { m_viewport.widget()->update(); });
    connect(&m_edges, &EdgeLines::failed, this, &SculptView::hinted);
    connect(&m_symmetry, &SymmetryCurves::traced, this, [this] { m_viewport.widget()->update(); });
    connect(&m_cuts, &CutPlanes::failed, this, &SculptView::hinted);
    connect(&m_touch, &TouchInput::felt, this, [this] { m_viewport.widget()->update(); });
    connect(&m_pointer, &PointerRouter::touched, &m_touch, &TouchInput::letGo);
    connect(&m_touch, &TouchInput::hinted, this, &SculptView::hinted);
    connect(&m_picker, &Picker::hinted, this, &SculptView::hinted);
    connect(&m_flight, &Flight::hinted, this, &SculptView::hinted);
    connect(&m_pointer, &PointerRouter::hinted, this, &SculptView::hinted);
    connect(&m_pointer, &PointerRouter::modelPicked, this, &SculptView::modelPicked);
}

void SculptView::refresh(bool moving) {
    if (!busy())
        m_symmetry.trace(m_settings.shared.symmetry.planes);
    if (!busy() && !moving)
        m_edges.look(m_motion.shownCamera());
    m_viewport.show(m_look.frame(m_motion.shownCamera(), moving, m_viewInput));
    m_pointer.followCursor();
    Q_EMIT pictureAsked();
}

void SculptView::showColours(std::shared_ptr<const render::BlockColours> colours,
                             const std::optional<render::ColourScale>& scale) {
    if (m_look.showColours(std::move(colours), scale))
        refresh(busy());
}

void SculptView::followModel() {
    const Snapshot& now = m_editor.snapshot();
    if ((m_look.showsInstead() || !m_overlay.gone.empty()) && !(now.whole == m_insteadOf))
        showInstead({});
    if (now.models != m_models) {
        m_models = now.models;
        m_source.choose({});
        m_cuts.reset();
        m_look.placeGrid();
        m_motion.showNewModel();
    } else if (now.stand != m_stand) { // another model is active, or this one has moved
        m_source.choose({});
        m_cuts.reset();
        m_look.placeGrid();
        m_motion.follow(now.stand.inverse() * m_stand);
    } else if (now.up != m_motion.view().upAxis) {
        m_look.placeGrid();
        m_motion.stand(now.up);
    }
    m_stand = now.stand;
    m_cuts.trace();
    refresh(busy());
}

void SculptView::frameSelection() {
    constexpr double around = 3; // radii of the brush
    const tree::SurfelTree& model = m_editor.snapshot().surface.tree();
    std::vector<base::Box3f> boxes = selectedBoxes(model);
    if (boxes.empty())
        boxes = unmaskedBoxes(model);
    if (boxes.empty())
        if (const auto contact = m_pointer.contactUnderPointer())
            boxes = {boxAround(contact->position, around * m_sizing.radiusAt(contact->position))};
    if (boxes.empty())
        m_motion.frameAll();
    else
        m_motion.frame(boxes);
}

void SculptView::setNotice(const Notice& notice) {
    if (m_overlay.notice == notice)
        return;
    m_overlay.notice = notice;
    m_viewport.widget()->update();
}

void SculptView::showInstead(std::optional<Snapshot> after, std::vector<base::Vec3d> gone) {
    const Snapshot& now = m_editor.snapshot();
    if (after && after->stand != now.stand) // seen from elsewhere
        after.reset();
    if (after)
        after->reference = now.reference, after->models = now.models;
    m_insteadOf = now.whole;
    m_look.showInstead(std::move(after));
    m_overlay.gone = std::move(gone);
    Q_EMIT shownChanged();
    refresh();
}

void SculptView::showErrorOf(const Snapshot& after) {
    Snapshot measured = m_editor.snapshot();
    if (after.stand != measured.stand) // seen from elsewhere
        return showInstead({});
    measured.reference = after.surface;
    m_insteadOf = measured.whole;
    m_look.showInstead(std::move(measured), render::Shading::Deviation);
    m_overlay.gone.clear();
    Q_EMIT shownChanged();
    refresh();
}

void SculptView::faceFreePlane() {
    m_cuts.turnFreePlane(m_motion.view().turn({0, 0, 1}));
}

} // namespace ui
