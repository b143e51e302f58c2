// The tour: what a person has to know, done by their own hand on the real window. Each step says what to do and goes on
// once it was done; it may be passed over. One table; tests loop over it. Interface's thread only.
#pragma once

#include "core/tree/surfel_tree.h"
#include "ui/panels/floating_card.h"

#include <span>

class QLabel;
class QToolButton;

namespace ui {

class MainWindow;

/// How things were when a step began.
struct TourStart {
    tree::SurfelTree model;
    base::Vec3d eye;
    double radius = 0;
};

struct TourStep {
    const char* title;
    const char* text;
    /// Null where there is nothing to do but read.
    bool (*done)(MainWindow& window, const TourStart& start);
};
std::span<const TourStep> tourTable();

class Tour : public FloatingCard {
    Q_OBJECT
  public:
    explicit Tour(MainWindow& window);

    int step() const { return m_step; }
    void go(int step);

  private:
    void look();

    MainWindow& m_window;
    QLabel* m_text;
    QLabel* m_count;
    QToolButton *m_back, *m_next;
    TourStart m_start;
    int m_step = 0;
    int m_doneFor = 0; ///< looks since the step was done
};

} // namespace ui
