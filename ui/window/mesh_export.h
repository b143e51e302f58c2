// Mesh export in the window: the bar, the mesher, the wireframe over the picture, and the file dialog. Interface's
// thread.
#pragma once

#include "core/render/overlay/wireframe.h"
#include "ui/panels/mesh_bar.h"
#include "ui/window/floating_bars.h"
#include "ui/work/mesher.h"

#include <QImage>
#include <QMainWindow>
#include <QTimer>

class QPainter;

namespace ui {

class Editor;

class MeshExport : public QObject {
    Q_OBJECT
  public:
    /// `canvas` is what shows the lines; all outlive it.
    MeshExport(QMainWindow& window, Editor& editor, QWidget& canvas, FloatingBars& bars);
    ~MeshExport() override;

    MeshBar& bar() { return *m_bar; }
    Mesher& mesher() { return m_mesher; }
    bool open() const { return m_bar->isVisibleTo(&m_window); }
    void setOpen(bool open);
    /// The preview as it is for this camera, in device pixels; asks for it where it is not drawn yet.
    void paint(QPainter& painter, const render::Camera& camera);
    void save(const std::filesystem::path& path);

  Q_SIGNALS:
    void told(QString message);

  private:
    struct Wanted {
        std::shared_ptr<const MadeMesh> made;
        render::Camera camera;
    };
    void follow();
    void measure();
    void make();
    void tellEstimate();
    void tellMade();
    void askPath();
    void draw(const Wanted& wanted, const base::Progress& progress);

    QMainWindow& m_window;
    Editor& m_editor;
    QWidget& m_canvas;
    MeshBar* m_bar;
    Mesher m_mesher;
    QTimer m_soon;     ///< runs from a change until the mesh is made anew
    double m_area = 0; ///< of the model when it was last looked at
    QImage m_lines;
    Wanted m_drawn, m_asked;                        ///< in m_lines; last asked for
    render::Wires m_wires;                          ///< the drawing thread's
    std::unique_ptr<LatestWorker<Wanted>> m_drawer; ///< last: it uses all of the above
};

} // namespace ui
