// A section of a panel, under a heading that opens and closes it.
#pragma once

#include <QWidget>

class QGridLayout;
class QToolButton;

namespace ui {

class PanelGroup : public QWidget {
    Q_OBJECT
  public:
    PanelGroup(const QString& title, bool open, QWidget* parent = nullptr);

    bool isOpen() const;
    void setOpen(bool open); ///< emits toggled where that is new
    /// A row of its own, from edge to edge.
    void add(QWidget* row);
    /// Two of these share a row where they follow each other.
    void addHalf(QWidget* cell);

  Q_SIGNALS:
    void toggled(bool open);

  private:
    QToolButton* m_heading;
    QWidget* m_body;
    QGridLayout* m_rows;
    int m_row = 0;
    bool m_halfFree = false; ///< the row before has room for one more half
};

} // namespace ui
