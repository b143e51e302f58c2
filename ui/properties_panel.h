// The brush's properties, bound to the settings both ways, and the chosen tool's own parameters from its table row.
#pragma once

#include "ui/settings.h"

#include <QScrollArea>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace ui {

class NumberSlider;

class PropertiesPanel : public QScrollArea {
    Q_OBJECT
  public:
    /// `settings` outlives the panel.
    PropertiesPanel(Settings& settings, QWidget* parent = nullptr);

    /// Shows what the settings say: another tool, a radius changed in the viewport.
    void refresh();
    /// Sensible radii in model units: for a model of this size.
    void setModelSize(double diagonal);

  signals:
    void edited(); ///< the settings have changed here

  private:
    void buildBrush(QVBoxLayout& layout);
    void buildSymmetry(QVBoxLayout& layout);
    void buildSwitches(QVBoxLayout& layout);
    void showRadius();
    void showTool();
    void edit(double strength);
    void editParameter(const std::string& id, double value);

    Settings& m_settings;
    double m_diagonal = 1;
    std::string m_shownTool; ///< whose parameters are built
    NumberSlider *m_radius, *m_strength, *m_spacing;
    QComboBox *m_unit, *m_falloff;
    QToolButton* m_axes[3];
    QCheckBox *m_invert, *m_resample;
    QLabel* m_toolHeading;
    QVBoxLayout* m_toolParameters;
    std::map<std::string, NumberSlider*> m_parameters; ///< of the shown tool, by id
};

} // namespace ui
