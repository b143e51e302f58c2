// The part of the ViewController that moves and cuts the view.
#include "core/base/parallel.h"
#include "ui/viewport/view_controller.h"
#include "ui/work/post.h"

#include <QCursor>
#include <QWidget>

namespace ui {

using base::Vec3d;

render::Camera ViewController::cameraOf(const View& view) const {
    const QWidget* widget = m_viewport.widget();
    const double scale = widget->devicePixelRatioF();
    render::Camera out =
        view.camera(std::max(1, qRound(widget->width() * scale)), std::max(1, qRound(widget->height() * scale)));
    out.clips = m_cuts.planes();
    return out.before(m_editor.snapshot().surface.tree().bounds());
}

void ViewController::viewMoved(bool more) {
    m_viewInput = m_inputs;
    refresh(more);
}

void ViewController::showColours(std::shared_ptr<const render::BlockColours> colours,
                                 const std::optional<render::ColourScale>& scale) {
    m_scale = scale;
    if (colours == m_colours)
        return;
    m_colours = std::move(colours);
    refresh(m_gesture != Gesture::None);
}

render::RenderOptions ViewController::look() const {
    render::RenderOptions out = lookOf(m_settings);
    out.pixelScale = static_cast<float>(m_viewport.widget()->devicePixelRatioF());
    if (m_settings.grid)
        out.grid = m_grid;
    return out;
}

std::optional<TrueSurface> ViewController::truth() const {
    const Snapshot& now = m_editor.snapshot();
    if (!m_settings.truth.on || now.surface.tree().empty())
        return {};
    TrueSurface out{now.surface, m_settings.truth.quality, m_settings.truth.lighting, nullptr};
    const std::optional<render::MeasureRow>& row = render::shadingRow(m_settings.shading).measure;
    if (row && m_scale)
        out.measured =
            std::make_shared<render::Measured>(render::Measured{{row->quantity, now.surface, now.reference}, *m_scale});
    return out;
}

/// The model's shape as far as framing needs it: a box for each block.
static std::vector<base::Box3f> boxesOf(const tree::SurfelTree& tree) {
    std::vector<base::Box3f> out;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(block.box()); });
    return out;
}

/// A box for each block's surfels whose mask is below a half; none where no surfel's is above.
static std::vector<base::Box3f> unmaskedBoxes(const tree::SurfelTree& tree) {
    if (!tree.layout()->masks)
        return {};
    std::vector<base::Box3f> out;
    bool masked = false;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        base::Box3f box;
        for (int slot = 0; slot < block.size(); ++slot) {
            if (block.mask(slot) < 0.5f)
                box.extend(block.position(slot));
            else
                masked = true;
        }
        if (!box.empty())
            out.push_back(box);
    });
    return masked ? out : std::vector<base::Box3f>{};
}

void ViewController::followModel() {
    const Snapshot& snapshot = m_editor.snapshot();
    if (snapshot.models != m_models) {
        m_models = snapshot.models;
        chooseSource({});
        resetCuts();
        m_grid = render::gridBelow(snapshot.surface.tree().bounds(), {0, 1, 0}, snapshot.origin);
        const render::Camera now = camera();
        View fresh = View::threeQuarter(boxesOf(snapshot.surface.tree()), now.width, now.height);
        fresh.parallel = view().parallel;
        m_navigator.set(fresh);
    }
    traceSections();
    refresh(m_gesture != Gesture::None);
}

// --- views ---

void ViewController::frameAll() {
    const render::Camera now = camera();
    View there = view();
    there.frame(boxesOf(m_editor.snapshot().surface.tree()), now.width, now.height);
    m_navigator.goTo(there);
}

void ViewController::frameSelection() {
    std::vector<base::Box3f> boxes = unmaskedBoxes(m_editor.snapshot().surface.tree());
    if (boxes.empty() && m_inside)
        if (const auto contact = contactAt(m_pointer.place)) {
            constexpr double around = 3; // radii of the brush
            const float reach = static_cast<float>(around * worldRadius(contact->position));
            const base::Vec3f middle = base::cast<float>(contact->position);
            boxes = {{middle - base::Vec3f{reach, reach, reach}, middle + base::Vec3f{reach, reach, reach}}};
        }
    if (boxes.empty())
        return frameAll();
    const render::Camera now = camera();
    View there = view();
    there.frame(boxes, now.width, now.height);
    m_navigator.goTo(there);
}

void ViewController::turnTo(const render::NamedView& named) {
    View there = view();
    there.turnTo(named.toEye, named.up);
    there.target = there.turningPoint() - there.turn(view().turn.inverse()(there.turningPoint() - view().target));
    m_navigator.goTo(there);
}

void ViewController::toggleParallel() {
    m_navigator.setParallel(!view().parallel);
    Q_EMIT viewChanged();
}

void ViewController::pickPivotAt(const QPointF& place) {
    const auto contact = contactAt(place);
    m_navigator.setPivot(contact ? std::optional(contact->position) : std::nullopt);
    Q_EMIT hinted(contact ? tr("The view turns about this place now.")
                          : tr("The view turns about the middle of the picture now."));
    m_viewport.widget()->update();
}

void ViewController::pickPivot() {
    pickPivotAt(m_inside ? m_pointer.place : QPointF(-1, -1));
}

SavedView ViewController::savedView(const std::string& name) const {
    return {name, view(), m_editor.snapshot().origin};
}

void ViewController::recall(const SavedView& saved) {
    m_navigator.goTo(saved.forOrigin(m_editor.snapshot().origin));
    Q_EMIT viewChanged();
}

void ViewController::turn(const Pointer& pointer) {
    const render::Camera now = camera();
    const QPointF from = m_pointer.place, to = pointer.place;
    m_pointer = pointer;
    if (m_gesture == Gesture::Orbit)
        m_navigator.drag({from.x(), from.y()}, {to.x(), to.y()}, now.width, now.height);
    else
        m_navigator.pan(to.x() - from.x(), to.y() - from.y(), now.height);
    viewMoved(true);
}

// --- flying ---

void ViewController::fly() {
    if (m_gesture != Gesture::None || m_navigator.flying())
        return;
    constexpr double crossing = 4; // seconds through the model
    const double diagonal = static_cast<double>(m_editor.snapshot().surface.tree().bounds().diagonal());
    m_warped = false;
    m_navigator.takeOff(std::max(diagonal, 1e-30) / crossing);
    m_viewport.widget()->setFocus();
    Q_EMIT hinted(tr("Flying: W A S D and Q E move, Shift hastens, the pointer looks, the wheel sets the speed; Esc "
                     "lands."));
}

/// Near the border the pointer is put back into the middle, where the window system lets us.
void ViewController::lookAround(const Pointer& pointer) {
    QWidget* widget = m_viewport.widget();
    const double scale = widget->devicePixelRatioF();
    const QPointF middle = QRectF(widget->rect()).center() * scale, by = pointer.place - m_pointer.place;
    const double leap = 0.25 * std::min(widget->width(), widget->height()) * scale;
    const bool refused = m_warped && by.manhattanLength() > leap;
    m_mayWarp = m_mayWarp && !refused;
    m_warped = false;
    m_pointer = pointer;
    if (!refused)
        m_navigator.look(by.x(), by.y(), camera().height);
    const QRectF inner = QRectF(widget->rect()).adjusted(60, 60, -60, -60);
    if (m_mayWarp && inner.isValid() && !inner.contains(pointer.place / scale)) {
        QCursor::setPos(widget->mapToGlobal((middle / scale).toPoint()));
        m_pointer.place = middle;
        m_warped = true;
    }
}

// --- cutting ---

void ViewController::setCuts(const Cuts& cuts) {
    m_cuts = cuts;
    traceSections();
    refresh(true);
}

void ViewController::resetCuts() {
    const bool section = m_cuts.section;
    m_cuts = {};
    m_cuts.section = section;
    const base::Box3f box = m_editor.snapshot().surface.tree().bounds();
    for (Cut& cut : m_cuts.each)
        cut.offset = offsetRange(box, cut.normal).middle();
    Q_EMIT cutsChanged();
}

void ViewController::faceFreeCut() {
    Cuts cuts = m_cuts;
    Cut& cut = cuts.each[Cuts::free];
    cut.normal = base::normalized(view().turn({0, 0, 1}));
    cut.offset = offsetRange(m_editor.snapshot().surface.tree().bounds(), cut.normal).middle();
    cut.flipped = false;
    setCuts(cuts);
    Q_EMIT cutsChanged();
}

void ViewController::traceSections() {
    const render::ClipPlanes planes = m_cuts.planes();
    const surface::Surface& surface = m_editor.snapshot().surface;
    if (!m_cuts.section || planes.empty() || surface.definition().manifold == surface::Manifold::Curve) {
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
    if (!m_tracer) {
        m_tracer = std::make_unique<SectionTracer>(
            [this](TracedSections traced) {
                post(this, [this, traced = std::move(traced)]() mutable {
                    if (!m_cuts.section || traced.planes != m_cuts.planes())
                        return; // others are on their way
                    m_sections = std::move(traced.curves);
                    m_viewport.widget()->update();
                });
            },
            [this](const std::exception& error) { post(this, [this, text = textOf(error)] { Q_EMIT hinted(text); }); });
    }
    m_tracer->request(surface, planes);
}

} // namespace ui
