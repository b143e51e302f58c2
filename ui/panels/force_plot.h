// The force of the last seconds as a small curve, with its largest as a number.
#pragma once

#include <deque>
#include <QWidget>

namespace ui {

class ForcePlot : public QWidget {
    Q_OBJECT
  public:
    static constexpr std::size_t most = 240;

    explicit ForcePlot(QWidget* parent = nullptr);
    /// `worked`: the tool was working.
    void add(double newtons, bool worked);
    void clear();
    std::size_t count() const { return m_forces.size(); }
    QSize sizeHint() const override { return {150, 68}; }

  protected:
    void paintEvent(QPaintEvent*) override;

  private:
    struct Force {
        double newtons;
        bool worked;
    };
    std::deque<Force> m_forces;
};

} // namespace ui
