// Selecting with the pointer: joins the bar of selection, the picker and the editor. Interface's thread only.
#pragma once

#include <nlohmann/json_fwd.hpp>
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
    int m_last = 0; ///< way chosen last: the one that the bar begins with when it is asked for
};

} // namespace ui
