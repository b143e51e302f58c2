// What the surface of a cast picture is made of: one table that help, menus and tests loop over. Colours are linear
// light.
#pragma once

#include "core/base/vec.h"

#include <span>
#include <string_view>

namespace raycast {

/// In the order of the table.
enum class Material { Matcap, Clay, Glass, Metal };

struct MaterialRow {
    Material material;
    const char* id; ///< "clay"
    const char* label;
    const char* tip;
    base::Vec3f colour;     ///< clay: part of the light that is scattered; metal: part reflected straight on
    float gloss = 0;        ///< of clay: strength of the highlight
    float index = 1;        ///< of refraction (glass)
    base::Vec3f absorption; ///< of glass: k in exp(-k l) for l in diagonals of the model's bounds (Beer's law)
    float shadow = 1;       ///< part of the light that it takes from what stands behind
    /// Light goes on from it in one or two directions, which are followed; else it scatters in all of them.
    bool specular() const { return material == Material::Glass || material == Material::Metal; }
};

std::span<const MaterialRow> materialTable();
const MaterialRow& materialRow(Material material);
/// Throws base::Error naming the known ones.
Material material(std::string_view id);

} // namespace raycast
