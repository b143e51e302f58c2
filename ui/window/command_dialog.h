// Asks for the parameters of any command of the session's table; the Model menu is a loop over that table.
#pragma once

#include "core/session/command.h"

#include <map>
#include <nlohmann/json.hpp>
#include <QDialog>

class QFormLayout;
class QLabel;

namespace ui {

/// True for the commands that a menu offers through this dialog: those that change the model and have no place of
/// their own in the window (undo, redo, strokes; new and open replace the model).
bool hasDialog(const session::CommandRow& row);

class CommandDialog : public QDialog {
    Q_OBJECT
  public:
    CommandDialog(const session::CommandRow& row, QWidget* parent = nullptr);
    /// What the person asks for; parameters left empty are left out. Throws base::Error where it does not fit the row.
    nlohmann::json command() const;

  private:
    void addParameter(QFormLayout& form, const session::CommandParameter& parameter);
    void checkAndAccept();

    const session::CommandRow& m_row;
    std::map<std::string, QWidget*> m_fields;
    QLabel* m_trouble;
};

} // namespace ui
