// The keys of actions: those of the menus' own, and what a person has chosen instead. Interface's thread only.
#pragma once

#include "ui/window/command_palette.h"

#include <map>
#include <string>

namespace ui {

/// Chosen keys by an action's id, as QKeySequence writes them; empty: none.
using Keys = std::map<std::string, std::string>;

/// Of an entry, the same in every language: its way, and its object name or label.
std::string keyIdOf(const PaletteEntry& entry);
/// Those that the menus gave it. Remembered at the first call, which comes before any key is changed.
QList<QKeySequence> ownKeysOf(QAction& action);
/// Gives all actions the keys that were chosen, the others their own.
void applyKeys(const std::vector<PaletteEntry>& entries, const Keys& chosen);
/// One of them could not be typed any more, or only after a pause: they are the same, or one begins the other.
bool disturb(const QKeySequence& one, const QKeySequence& other);
/// Labels of the other actions whose key this one disturbs.
QStringList conflictsOf(const std::vector<PaletteEntry>& entries, const QAction& action, const QKeySequence& key);

} // namespace ui
