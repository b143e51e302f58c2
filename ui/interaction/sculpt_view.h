// The viewport with all that works in it: the parts that move the view, cut the model, size the brush, make strokes
// and paint over the picture. It makes them in the order of their dependencies, connects them, and keeps the picture
// up to date. What each part does is described in its own header; nothing is done here.
//
// Interface's thread only.
#pragma once

#include "ui/interaction/view_overlay.h"
#include "ui/viewport/viewport.h"

namespace ui {

class SculptView : public QObject {
    Q_OBJECT
  public:
    /// All three outlive it.
    SculptView(Editor& editor, Settings& settings, Viewport& viewport, QObject* parent = nullptr);
    ~SculptView() override;

    CutPlanes& cuts() { return m_cuts; }
    EdgeLines& edges() { return m_edges; }
    ViewMotion& motion() { return m_motion; }
    BrushSizing& sizing() { return m_sizing; }
    CloneSource& source() { return m_source; }
    const PictureLook& look() const { return m_look; }
    PointerRouter& pointer() { return m_pointer; }
    ViewOverlay& overlay() { return m_overlay; }
    TouchInput& touch() { return m_touch; }
    Picker& picker() { return m_picker; }
    PlacementTool& placement() { return m_placement; }
    const BrushCursor& cursor() const { return m_cursor.cursor(); }

    /// Another picture: the settings that show in it have changed.
    void refresh(bool moving = false);
    void showColours(std::shared_ptr<const render::BlockColours> colours,
                     const std::optional<render::ColourScale>& scale);
    /// What is selected; else what is not masked, where something is; else what is under the brush; else all.
    void frameSelection();
    /// Turns the free plane across the direction of view.
    void faceFreePlane();
    /// What would become of the model, in its place and without being it, with dots where surfels would go. The model
    /// shows again after `showInstead({})`, and when it is another one.
    void showInstead(std::optional<Snapshot> after, std::vector<base::Vec3d> gone = {});
    /// The model as it is, coloured by how far it is from that surface: likewise.
    void showErrorOf(const Snapshot& after);
    /// Says what is working, over the picture; an empty text: nothing is.
    void setNotice(const Notice& notice);

  Q_SIGNALS:
    void modelPicked(QString name); ///< as PointerRouter
    void pictureAsked();            ///< of where the view is now
    void shownChanged();            ///< look().shown() is another model
    void hinted(QString what);      ///< by any of the parts, for the person

  private:
    void connectParts();
    void followModel();
    bool busy() const { return m_pointer.gesture() != PointerRouter::Gesture::None; }

    const Editor& m_editor;
    const Settings& m_settings;
    Viewport& m_viewport;
    CutPlanes m_cuts;
    EdgeLines m_edges;
    SymmetryCurves m_symmetry;
    ViewMotion m_motion;
    BrushSizing m_sizing;
    CloneSource m_source;
    StrokeInput m_strokes;
    Flight m_flight;
    PictureLook m_look;
    CursorTracker m_cursor;
    PointerRouter m_pointer;
    TouchInput m_touch;
    Picker m_picker;
    PlacementTool m_placement;
    ViewOverlay m_overlay;
    std::uint64_t m_models = 0;    ///< of the snapshot that the view was framed for
    process::Rigid m_stand;        ///< of the snapshot that the view was last seen in
    tree::SurfelTree m_insteadOf;  ///< what the model was when something else was shown in its place
    std::uint64_t m_viewInput = 0; ///< the last pointer event that moved the view
};

} // namespace ui
