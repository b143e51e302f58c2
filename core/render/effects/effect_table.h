// Effects on the finished picture, from depths and normals alone: one table, each row a switch. The rows themselves,
// with their numbers, stand in effect_rows.h; screen_effects.h has the formulas.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace render {

/// A set of them; 0: none.
using Effects = std::uint32_t;

struct EffectRow;
std::span<const EffectRow> effectTable();
/// Of a comma list of ids. Throws base::Error naming the known ones.
Effects effects(std::string_view list);

} // namespace render
