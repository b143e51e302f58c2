// The bar of clip planes: for each of the window's cuts a button, a slider for its position and a button to
// show the other side; and a switch for section curves. Moving a slider switches its plane on. It edits a Cuts and
// emits it; it knows no view.
#pragma once

#include "ui/view/cuts.h"

#include <QToolBar>

class QAction;
class QSlider;
class QToolButton;

namespace ui {

class CutBar : public QToolBar {
    Q_OBJECT
  public:
    explicit CutBar(QWidget* parent = nullptr);

    /// What is shown and edited from now on: the sliders reach over `bounds`. Emits nothing.
    void display(const Cuts& cuts, const base::Box3f& bounds);
    const Cuts& cuts() const { return m_cuts; }

    /// Of the picture that it floats over: in a narrow one sliders are short, and sides are offered of cuts alone.
    void fitInto(int width);

  Q_SIGNALS:
    void edited(const Cuts& cuts);
    void freeWanted(); ///< the free plane was switched on: it wants to face the view

  private:
    static constexpr int sliderSteps = 2000;
    struct Row {
        QToolButton *on, *flip;
        QSlider* place;
        QAction* flipShown;
    };
    void build(std::size_t number, const QString& label, const QString& tip);
    void change(const std::function<void()>& edit);
    void refresh();

    Cuts m_cuts;
    base::Box3f m_bounds;
    std::array<Row, 4> m_rows;
    QToolButton* m_section;
    bool m_narrow = false;
    bool m_quiet = false; ///< while the widgets are set
};

} // namespace ui
