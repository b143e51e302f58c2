// Measuring with the pointer: joins the bar of measuring, the picker and the ruler, and shows the results over the
// picture until they are cleared or another model is there. Interface's thread only.
#pragma once

#include "ui/overlay/ruler_overlay.h"
#include "ui/work/ruler.h"

namespace ui {

class MainWindow;
class MeasureBar;
struct Pick;

class MeasureTools : public QObject {
    Q_OBJECT
  public:
    /// Ends with the bar; the window outlives it.
    MeasureTools(MainWindow& window, MeasureBar& bar);

    void paint(QPainter& painter, const render::Camera& seen) const;

  private:
    void choose(int row);
    void pick(const Pick& pick);
    void receive(const Ruled& ruled);
    void clear();
    void copy() const;
    void ask();

    MainWindow& m_window;
    MeasureBar& m_bar;
    Ruler m_ruler;
    const RulerRow* m_row = nullptr;  ///< what is measured
    std::vector<RuledPlace> m_places; ///< picked for the next
    std::vector<RulerMark> m_marks;
    QStringList m_lines; ///< the results as text
    std::uint64_t m_models = 0;
};

} // namespace ui
