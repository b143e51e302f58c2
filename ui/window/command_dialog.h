// Asks for the parameters of any command of the session's table; the Model menu is a loop over that table. What the
// model has now stands in the fields, with units, and what the command would make of it below them. Files are looked
// for, and places are picked in the picture: whoever opens the dialog (command_desk.h) answers `placeWanted`.
#pragma once

#include "core/base/plane.h"
#include "core/session/command.h"
#include "ui/work/snapshot.h"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <QDialog>

class QCheckBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace ui {

class ColumnTable;

/// True for the commands that a menu offers through this dialog: those that change the model and have no place of
/// their own in the window (undo, redo, strokes; new and open replace the model).
bool hasDialog(const session::CommandRow& row);

class CommandDialog : public QDialog {
    Q_OBJECT
  public:
    /// `plane`: what a field for a plane proposes, in the file's coordinates; else one through the model's middle.
    CommandDialog(const session::CommandRow& row, const Snapshot& model, QWidget* parent = nullptr,
                  const std::optional<base::Plane>& plane = {});
    /// What the person asks for; what is left as it is now is left out. Throws base::Error where it does not fit the
    /// row.
    nlohmann::json command() const;
    /// "About 12,000 points (now 40,000)"; empty where nothing can be said.
    QString outcome() const;
    const session::CommandRow& row() const { return m_row; }
    /// The model is another by now.
    void setModel(const Snapshot& model);

    /// The first field that must have a place and has none; empty: there is none.
    QString placeLacking() const;
    /// Of the file's coordinates, for the field that asked; fields for several get one more.
    void takePlace(const QString& field, const base::Vec3d& place, const base::Vec3d& normal);
    bool takesSeveral(const QString& field) const;
    /// Whether it has a field of that name; what stands there from now on.
    bool has(std::string_view field) const { return find(field) != nullptr; }
    void enter(std::string_view field, const QString& text);
    /// The button of the field whose place is being picked is down; empty: none is.
    void setPicking(const QString& field);

    bool previews() const;
    void setPreviews(bool on);
    /// Whether previews show how far the model is from what would come of it; of commands that keep the surface.
    bool showsError() const;
    void sayPreviewed(const QString& text);

  Q_SIGNALS:
    void changed();                  ///< the command may be another
    void placeWanted(QString field); ///< empty: no longer
    void previewsSwitched(bool on);
    void errorSwitched();

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;

  private:
    struct Field {
        const session::CommandParameter* parameter;
        QWidget* widget;
        QString shown; ///< at first
    };
    QWidget* make(const session::CommandParameter& parameter);
    QWidget* lineWith(const session::CommandParameter& parameter, QLineEdit& line);
    void addAnswers(QVBoxLayout& layout);
    void lookForFile(QLineEdit& line);
    /// What fits the model's size, where something must be given.
    QString proposed(const session::CommandParameter& parameter) const;
    void add(QFormLayout& form, const session::CommandParameter& parameter, QString& taken);
    /// What the model has of it now, as text; empty where that is not known.
    QString present(const session::CommandParameter& parameter) const;
    const Field* find(std::string_view id) const;
    bool edited(const Field& field) const;
    /// Something else is given than the spacing, or the ratio of `reduce`, that stands there: that was a proposal.
    void giveWay(const QWidget* edited);
    /// Where a file's columns can be told: the beginning of the file, under lists to choose from.
    void addColumnTable(QFormLayout& form);
    void followColumns();
    void follow();
    void checkAndAccept();

    const session::CommandRow& m_row;
    Snapshot m_model;
    std::optional<base::Plane> m_plane;
    std::vector<Field> m_fields;
    std::map<QString, QToolButton*> m_picks; ///< by field
    ColumnTable* m_columns = nullptr;
    QLabel *m_help = nullptr, *m_outcome = nullptr, *m_said = nullptr, *m_trouble = nullptr;
    QCheckBox *m_preview = nullptr, *m_error = nullptr;
};

} // namespace ui
