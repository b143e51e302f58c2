// What is changed from stroke to stroke, above the viewport: radius, strength, direction, symmetry, method; and
// pop-overs of the menus of shading and of what stands around. It edits the settings and says so; it knows no view.
#pragma once

#include "ui/settings/settings.h"

#include <QToolBar>

class QMenu;
class QToolButton;

namespace ui {

class NumberSlider;

class HeaderBar : public QToolBar {
    Q_OBJECT
  public:
    /// The settings outlive it.
    explicit HeaderBar(Settings& settings, QWidget* parent = nullptr);
    /// A button that opens a menu of the menu bar.
    void addPopOver(QMenu& menu, const QString& label);
    /// For a model of another size.
    void setModelSize(double diagonal);
    /// The settings may be others.
    void refresh();

  Q_SIGNALS:
    void edited(); ///< the settings have changed here

  protected:
    /// In a narrow window sliders give their room, so that every button is there.
    void resizeEvent(QResizeEvent* event) override;

  private:
    void addSliders();
    void addSymmetry();
    void addMethods();
    QToolButton* button(const QString& label, const char* name, const QString& tip);

    Settings& m_settings;
    double m_diagonal = 1;
    NumberSlider *m_radius, *m_strength;
    QToolButton *m_invert, *m_symmetry, *m_method;
    QMenu *m_planes, *m_methods;
};

} // namespace ui
