// The bar of mesh export: how to make the mesh, what it will be or has become, and a button to export it. It edits a
// MeshChoice and emits it; it makes no mesh itself.
#pragma once

#include "ui/work/mesh_choice.h"

#include <functional>
#include <QToolBar>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace ui {

class NumberSlider;

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
    void addMethod();
    void addCell();
    void change(const std::function<void(MeshChoice&)>& edit);
    QCheckBox* box(const char* name, const QString& label, const QString& tip, bool MeshChoice::*member);

    MeshChoice m_choice;
    QLabel* m_text;
};

} // namespace ui
