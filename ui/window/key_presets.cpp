#include "ui/window/key_presets.h"

#include <QAction>
#include <set>

namespace ui {

constexpr std::pair<const char*, const char*> sculptGl[] = {
    {"Brush > Grab", "0"},       {"Brush > Draw", "1"},    {"Brush > Inflate", "2"}, {"Brush > Twist", "3"},
    {"Brush > Smooth", "4"},     {"Brush > Flatten", "5"}, {"Brush > Pinch", "6"},   {"Brush > Crease", "7"},
    {"Brush > Snake Hook", "8"}, {"Brush > Paint", "9"},
};

/// B, then two letters of the brush's name.
constexpr std::pair<const char*, const char*> zBrush[] = {
    {"Brush > Draw", "B, S, T"},           {"Brush > Clay", "B, C, L"},         {"Brush > Clay Strips", "B, C, B"},
    {"Brush > Crease", "B, D, S"},         {"Brush > Inflate", "B, I, N"},      {"Brush > Pinch", "B, P, I"},
    {"Brush > Grab", "B, M, V"},           {"Brush > Elastic Grab", "B, M, E"}, {"Brush > Snake Hook", "B, S, H"},
    {"Brush > Smooth", "B, S, M"},         {"Brush > Flatten", "B, F, L"},      {"Brush > Layer", "B, L, A"},
    {"Brush > Nudge", "B, N, U"},          {"Brush > Scrape", "B, T, D"},       {"Brush > Blob", "B, B, L"},
    {"Brush > Paint", "B, P, A"},          {"Brush > Mask", "B, M, P"},         {"View > Orthographic", "P"},
    {"Mask > mask-clear", "Ctrl+Shift+A"},
};

std::span<const KeyPreset> keyPresets() {
    static const KeyPreset rows[] = {
        {"pointclay", QT_TRANSLATE_NOOP("ui", "Pointclay, as in Blender"), {}},
        {"sculptgl", QT_TRANSLATE_NOOP("ui", "As in SculptGL"), sculptGl},
        {"zbrush", QT_TRANSLATE_NOOP("ui", "As in ZBrush"), zBrush},
    };
    return rows;
}

Keys keysOf(const KeyPreset& preset, const std::vector<PaletteEntry>& entries) {
    Keys out;
    QList<QKeySequence> given;
    for (const auto& [id, key] : preset.keys) {
        out[id] = key;
        given << QKeySequence(key);
    }
    for (const PaletteEntry& entry : entries) {
        if (!entry.action || out.contains(keyIdOf(entry)))
            continue;
        for (const QKeySequence& own : ownKeysOf(*entry.action))
            if (std::ranges::any_of(given, [&](const QKeySequence& each) { return disturb(each, own); }))
                out[keyIdOf(entry)] = "";
    }
    return out;
}

} // namespace ui
