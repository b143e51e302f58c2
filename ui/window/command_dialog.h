// Asks for the parameters of any command of the session's table; the Model menu is a loop over that table. What the
// model has now stands in the fields, with units, and what the command would make of it below them.
#pragma once

#include "core/session/command.h"
#include "ui/work/snapshot.h"

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
    CommandDialog(const session::CommandRow& row, const Snapshot& model, QWidget* parent = nullptr);
    /// What the person asks for; what is left as it is now is left out. Throws base::Error where it does not fit the
    /// row.
    nlohmann::json command() const;
    /// "About 12,000 points (now 40,000)"; empty where nothing can be said.
    QString outcome() const;

  private:
    struct Field {
        const session::CommandParameter* parameter;
        QWidget* widget;
        QString shown; ///< at first
    };
    QWidget* make(const session::CommandParameter& parameter);
    void add(QFormLayout& form, const session::CommandParameter& parameter, QString& taken);
    /// What the model has of it now, as text; empty where that is not known.
    QString present(const session::CommandParameter& parameter) const;
    const Field* find(std::string_view id) const;
    bool edited(const Field& field) const;
    /// A number is given beside the spacing that stands there: that one was a proposal.
    void giveWay(const QWidget* edited);
    void follow();
    void checkAndAccept();

    const session::CommandRow& m_row;
    Snapshot m_model;
    std::vector<Field> m_fields;
    QLabel *m_outcome, *m_trouble;
};

} // namespace ui
