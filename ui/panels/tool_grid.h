// The tool buttons in as few columns as the height allows: two where there is room, more in a low window, so that none
// is ever cut off; where the most are not enough buttons are a little lower. Interface's thread only.
#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QToolButton;

namespace ui {

class ToolGrid : public QWidget {
    Q_OBJECT
  public:
    explicit ToolGrid(QWidget* parent = nullptr);
    void add(QAction& action);
    int columns() const { return m_columns; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    static constexpr int fewest = 2, most = 5, gap = 1;
    static constexpr int spare = 4; ///< of a button's height, around its icon
    QSize cell() const;             ///< as the style has it where the grid is now
    int rowsOf(int columns) const;
    int heightOf(int columns) const;
    void arrange();

    std::vector<QToolButton*> m_buttons;
    int m_columns = fewest;
};

} // namespace ui
