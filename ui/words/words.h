// What a person reads, in the language chosen for the window. The window's own literals go through tr(); texts of the
// core's tables, of its progress and of its steps are English there, and pass through here on their way to a widget.
// Command line, journals and files stay English, and numbers are written alike in every language.
//
// All of it lies in one catalogue, pointclay_de.ts, whatever class asks: a text has one translation, unless `table`
// says that it means something else there ("falloff": Smooth is a shape, elsewhere it is something to do). Any thread.
#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace ui {

QString spoken(const char* text, const char* table = "");
QString spoken(std::string_view text, const char* table = "");
/// A sentence of a command: its numbers and quoted names stay, the words around them are looked up. English where the
/// catalogue does not know it.
QString spokenMessage(std::string_view text);
/// Property of actions that are a table's row: its English label, since two rows may have one word in another language.
constexpr const char* inEnglish = "in-english";
/// Of what `spoken` and tr() have given: the English words, without mnemonics. Where nothing was translated, as it is.
QString englishOf(const QString& shown);

} // namespace ui
