// A named colour: a button that shows it and asks for another.
#pragma once

#include <QColor>
#include <QToolButton>

namespace ui {

class ColourField : public QToolButton {
    Q_OBJECT
  public:
    explicit ColourField(const QString& label, QWidget* parent = nullptr);

    QColor colour() const { return m_colour; }
    void setColour(const QColor& colour); ///< does not emit
    /// As if the person had chosen it.
    void choose(const QColor& colour);

  Q_SIGNALS:
    void edited();

  private:
    void ask();
    QColor m_colour;
};

} // namespace ui
