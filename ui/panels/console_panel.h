// What the window does, line by line, as sessions write it; and a field that takes such a line: JSON, or shorter
// "resample spacing=0.01". Up and down bring back what was typed. It executes nothing: it says what was entered.
// Interface's thread only.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <QStringList>
#include <QWidget>
#include <string>

class QLineEdit;
class QPlainTextEdit;

namespace ui {

/// The command that a typed line means. Throws base::Error where it is neither JSON nor a name followed by NAME=VALUE.
nlohmann::json commandOf(const std::string& line);

class ConsolePanel : public QWidget {
    Q_OBJECT
  public:
    explicit ConsolePanel(QWidget* parent = nullptr);

    void showLine(const QString& line);
    /// Of what went wrong, or what a command says.
    void showMessage(const QString& message);
    QString text() const;
    QSize sizeHint() const override { return {400, 150}; } ///< some lines; the model is what matters

  Q_SIGNALS:
    void entered(const QString& line);

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    void enter();
    void recall(int step);

    QPlainTextEdit* m_lines;
    QLineEdit* m_typed;
    QStringList m_before; ///< typed, the oldest first
    int m_recalled = 0;   ///< index of the one shown; m_before.size(): none
};

} // namespace ui
