// Which languages the window speaks, and how one is chosen: by a preference, else as the desktop has it. Interface's
// thread only.
#pragma once

#include <QStringList>
#include <span>
#include <string_view>

class QCoreApplication;

namespace ui {

struct LanguageRow {
    const char *id, *label, *tip; ///< labels of languages are in that language
};
/// The first is what it is where nobody chose.
std::span<const LanguageRow> languageTable();

/// "de" or "en" for the id of a row; for that of the desktop by the languages that it wants, the first that there is.
QString languageFor(std::string_view id, const QStringList& desktop);
/// From now on all texts that are asked for are in this language, Qt's own, too, where the system has them. Windows
/// that are there keep their words: call it before the first one.
void speak(QCoreApplication& application, const QString& language);

} // namespace ui
