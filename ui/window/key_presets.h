// Keys as other sculpting programs have them, for hands that know these: a table. What a preset does not name keeps its
// own key, unless the preset has given that to something else.
#pragma once

#include "ui/window/keys.h"

#include <span>
#include <utility>

namespace ui {

struct KeyPreset {
    const char *id, *label;
    std::span<const std::pair<const char*, const char*>> keys; ///< of actions, by keyIdOf
};

/// The first one is Pointclay's own: Blender's, as far as there is the same.
std::span<const KeyPreset> keyPresets();
/// What a person who chooses the preset has chosen. The entries are those of all menus.
Keys keysOf(const KeyPreset& preset, const std::vector<PaletteEntry>& entries);

} // namespace ui
