// Lines of buttons that fold into more rows where the picture is narrow: in a bar that is cut off, what has no room is
// not there. Interface's thread only.
#pragma once

#include <QWidget>
#include <vector>

class QVBoxLayout;

namespace ui {

class FoldingRows : public QWidget {
  public:
    explicit FoldingRows(QWidget* parent = nullptr);

    /// The widgets of the row's layout, from now on in a line of their own below the others.
    void addLine(QLayout& row);
    /// Below all lines.
    void addBelow(QWidget& widget);
    /// Into rows that a bar has room for over a picture of that many pixels.
    void foldOver(int picture);
    /// So many, but for the margins of the bar and beside it.
    static int roomOver(int picture) { return picture - 48; }

  private:
    void layOut();

    QVBoxLayout *m_column, *m_rows;
    std::vector<std::vector<QWidget*>> m_lines;
    std::vector<std::vector<QWidget*>> m_folded; ///< as they stand now
};

} // namespace ui
