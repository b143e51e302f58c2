// The keys of actions: those of the menus' own, and what a person has chosen instead. Interface's thread only.
#pragma once

#include "ui/window/command_palette.h"

#include <map>
#include <string>

namespace ui {

/// Chosen keys by an action's id, as QKeySequence writes them; empty: none.
using Keys = std::map<std::string, std::string>;

/// Of an entry, stable while labels tell what they would do: its way, and its object name or label.
std::string keyIdOf(const PaletteEntry& entry);
/// Those that the menus gave it. Remembered at the first call, which comes before any key is changed.
QList<QKeySequence> ownKeysOf(QAction& action);
/// Gives all actions the keys that were chosen, the others their own.
void applyKeys(const std::vector<PaletteEntry>& entries, const Keys& chosen);
/// Labels of the other actions that have this key.
QStringList conflictsOf(const std::vector<PaletteEntry>& entries, const QAction& action, const QKeySequence& key);

} // namespace ui
