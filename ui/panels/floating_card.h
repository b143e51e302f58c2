// A card over the picture: what a person meets before there is anything to do, or beside it. It covers a part of the
// picture without changing its size, and what happens on it never reaches the picture. Deleted when it is closed.
// Interface's thread only.
#pragma once

#include <QFrame>

class QLabel;
class QVBoxLayout;

namespace ui {

class FloatingCard : public QFrame {
    Q_OBJECT
  public:
    enum class Place { Centre, TopLeft };

    FloatingCard(QWidget& canvas, Place place, const QString& title);

  protected:
    /// For what stands below the title.
    QVBoxLayout& column() { return *m_column; }
    void setTitle(const QString& title);
    bool event(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    /// A press on the picture beside the card.
    virtual void pressedBeside() {}

  private:
    void place();

    QWidget& m_canvas;
    Place m_place;
    QLabel* m_title;
    QVBoxLayout* m_column;
};

} // namespace ui
