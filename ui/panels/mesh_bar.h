// The bar of mesh export: how the mesh is to be made, what it will be or has become, and the way to a file. It edits a
// MeshChoice and says so; it makes no mesh itself.
#pragma once

#include <QToolBar>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class NumberSlider;

struct MeshChoice {
    static constexpr double minCell = 0.5, maxCell = 8;
    bool delaunay = false; ///< restricted Delaunay triangles; else marching cubes
    double cell = 1;       ///< side of a cube, or largest triangle's radius, in spacings
    bool closeFolds = false, dropSmall = false;
    bool preview = true; ///< lines over the picture
    bool operator==(const MeshChoice&) const = default;
    /// Do both give the same mesh?
    bool sameMesh(const MeshChoice& o) const {
        return delaunay == o.delaunay && cell == o.cell && closeFolds == o.closeFolds && dropSmall == o.dropSmall;
    }
};

class MeshBar : public QToolBar {
    Q_OBJECT
  public:
    explicit MeshBar(QWidget* parent = nullptr);

    const MeshChoice& choice() const { return m_choice; }
    /// What stands behind the controls: an estimate, or what the mesh has become.
    void tell(const QString& text, const QString& tip = {});
    QString text() const;

  Q_SIGNALS:
    void edited(const ui::MeshChoice& choice);
    void exportWanted();

  private:
    void change(const std::function<void(MeshChoice&)>& edit);
    QCheckBox* box(const char* name, const QString& label, const QString& tip, bool MeshChoice::*member);

    MeshChoice m_choice;
    QLabel* m_text;
};

} // namespace ui
