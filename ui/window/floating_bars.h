// Bars that float over the lower edge of the viewport, each as wide as it needs to be, one above the other: the picture
// keeps its size when one comes or goes, and the model its place. What a bar does not take itself ends there: no click
// beside a button reaches the brush below it. Interface's thread only.
#pragma once

#include <functional>
#include <QObject>
#include <vector>

class QWidget;

namespace ui {

class FloatingBars : public QObject {
    Q_OBJECT
  public:
    /// The canvas outlives it.
    explicit FloatingBars(QWidget& canvas, QObject* parent = nullptr);
    /// From now on `bar` is a child of the canvas; the first stands lowest. Shown where it is visible. `fit` is told
    /// the canvas's width before the bar is asked for its own.
    void add(QWidget& bar, std::function<void(int width)> fit = {});

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void place();

    struct Bar {
        QWidget* widget;
        std::function<void(int)> fit;
    };
    QWidget& m_canvas;
    std::vector<Bar> m_bars;
    bool m_placing = false;
};

} // namespace ui
