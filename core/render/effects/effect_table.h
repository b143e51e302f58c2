// Effects on the finished picture, from depths and normals alone: one table, each row a switch (screen_effects.h has
// the formulas).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace render {

/// A set of them; 0: none.
using Effects = std::uint32_t;
enum Effect : Effects { EyeDome = 1, Occlusion = 2, Outline = 4, Creases = 8, Contours = 16 };

struct EffectRow {
    Effect effect;
    const char* id; ///< "eye-dome"
    const char* label;
    const char* tip;
};
std::span<const EffectRow> effectTable();
/// Of a comma list of ids. Throws base::Error naming the known ones.
Effects effects(std::string_view list);

} // namespace render
