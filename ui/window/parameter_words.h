// What parameters of commands and the words to choose from are called in dialogs: words where the table's ids are short
// for files and command lines. What is not listed is its id with blanks and a capital letter, so that a new parameter
// has a name from the start.
#pragma once

#include <QString>
#include <string_view>

namespace ui {

/// Of a parameter of the command `op`.
QString parameterWords(std::string_view op, std::string_view id);
QString choiceWords(std::string_view id);
/// " (0 to 1)"; empty where there is no limit worth telling.
QString rangeWords(double min, double max);
/// With an ampersand before a letter that is not in `taken` yet, and now is.
QString withMnemonic(const QString& label, QString& taken);

} // namespace ui
