// Selecting with the pointer: joins the bar of selection, the picker and the editor, and shows what is selected. While
// the bar is shown the picture is shaded by what is selected; then as it was before. Interface's thread only.
#pragma once

#include "core/render/shading/shading_table.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <QObject>

namespace ui {

class MainWindow;
class SelectBar;
struct Pick;

class SelectTools : public QObject {
    Q_OBJECT
  public:
    /// Ends with the bar; the window outlives it.
    SelectTools(MainWindow& window, SelectBar& bar);

  private:
    void choose(int way);
    void pick(int way, const Pick& pick);
    void step(const QString& action);
    void show(bool shown);
    void run(const nlohmann::json& command);

    MainWindow& m_window;
    SelectBar& m_bar;
    std::optional<render::Shading> m_before; ///< the shading, since it shows what is selected
};

} // namespace ui
