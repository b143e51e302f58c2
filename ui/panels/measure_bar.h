// The bar of measuring: what the next clicks measure, and what was found last. It shows and asks; measuring is
// elsewhere (work/ruler.h). Interface's thread only.
#pragma once

#include <QToolBar>

class QLabel;

namespace ui {

class FoldingRows;

class MeasureBar : public QToolBar {
    Q_OBJECT
  public:
    /// A button for each row of rulerTable().
    explicit MeasureBar(QWidget* parent = nullptr);
    /// Of the picture that it floats over.
    void fitInto(int width);

    /// Of the row whose button is down; -1: none. Setting it does not emit.
    int row() const;
    void setRow(int row);
    /// Below the buttons: the last result, or what is to be clicked.
    void say(const QString& text);
    QString said() const;
    /// What the buttons do, for menus.
    const QList<QAction*>& rows() const { return m_rows; }
    const QList<QAction*>& results() const { return m_results; }

  Q_SIGNALS:
    void rowChosen(int row); ///< by the person; -1: none any more
    void copyWanted();       ///< all results, to the clipboard
    void clearWanted();

  private:
    QList<QAction*> m_rows, m_results;
    FoldingRows* m_lines;
    QLabel* m_said;
};

} // namespace ui
