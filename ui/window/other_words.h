// Words by which other programs call what a menu offers: a person who looks for "boolean" or "screenshot" finds it in
// the palette. Interface's thread only.
#pragma once

#include <QString>
#include <span>

namespace ui {

struct OtherWords {
    const char *label, *words; ///< the English label without mnemonic and dots; words with blanks between them
};

std::span<const OtherWords> otherWordsTable();

/// English ones and those of the language chosen; empty where the table has none for the label.
QString otherWords(const QString& englishLabel);

} // namespace ui
