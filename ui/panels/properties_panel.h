// Everything that a brush can be told, in groups that open and shut, bound to the settings both ways: loops over
// sculpt::strokeOptionTable() and the chosen tool's own parameters. What has no say with the chosen tool is not shown.
#pragma once

#include "ui/panels/option_editor.h"
#include "ui/settings/settings.h"

#include <QScrollArea>

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace ui {

class NumberSlider;
class PanelGroup;

class PropertiesPanel : public QScrollArea {
    Q_OBJECT
  public:
    /// `settings` outlives the panel.
    PropertiesPanel(Settings& settings, QWidget* parent = nullptr);

    /// Shows what the settings say: another tool, a radius changed in the viewport.
    void refresh();
    /// Sensible radii in model units: for a model of this size.
    void setModelSize(double diagonal);
    /// Where tools that copy copy from, as a person reads it; empty: not chosen yet.
    void showSource(const QString& place);

    QSize sizeHint() const override;

  Q_SIGNALS:
    void edited(); ///< the settings have changed here
    void unitWanted(ui::RadiusUnit unit);

  private:
    struct Shown {
        const sculpt::StrokeOption* option;
        OptionEditor editor;
    };
    QWidget* titleRow();
    PanelGroup* addGroup(QVBoxLayout& layout, const char* id, const char* label, bool open);
    void fill(PanelGroup& group, sculpt::OptionGroup which);
    void buildBrush(PanelGroup& group);
    QWidget* radiusRow();
    void showRadius();
    void showTool();
    void buildToolParameters();
    void resetTool();

    static constexpr int panelWidth = 256;

    Settings& m_settings;
    EditSettings m_edit;       ///< changes the chosen tool's options
    EditSettings m_editShared; ///< changes those of all tools
    double m_diagonal = 1;
    std::string m_shownTool; ///< whose parameters are built
    NumberSlider* m_radius;
    QToolButton* m_unit;
    QLabel *m_toolIcon, *m_toolName, *m_source;
    QToolButton* m_reset;
    QWidget* m_toolParameters;
    std::vector<Shown> m_options;
    std::vector<OptionEditor> m_parameters; ///< of the shown tool
    std::vector<std::pair<PanelGroup*, sculpt::OptionGroup>> m_groups;
};

} // namespace ui
