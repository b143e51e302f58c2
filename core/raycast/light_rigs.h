// Lamps around the model: one table of rigs that help, menus and tests loop over.
//
// A rig stands around the viewer: x to the right, y up in the model's world, z level towards the eye. Lamps are
// round and infinitely far; `power` is what a white matte surface that faces one reflects (linear light).
#pragma once

#include "core/base/vec.h"

#include <span>
#include <string_view>

namespace raycast {

/// In the order of the table.
enum class LightRig { Studio, ThreePoint, Sun, Overcast };

struct Lamp {
    base::Vec3f direction; ///< towards it, unit
    float radius = 0;      ///< angle, radians
    base::Vec3f power;

    /// Smaller lamps cast hard shadows; one ray is enough.
    bool soft() const { return radius > 0.03f; }
    bool operator==(const Lamp&) const = default;
};

struct LightRigRow {
    LightRig rig;
    const char* id; ///< "studio"
    const char* label;
    const char* tip;
    std::span<const Lamp> lamps; ///< directions relative to the viewer; not normalised
    base::Vec3f above, below;    ///< light of the room without lamps, from straight above and below
};

std::span<const LightRigRow> lightRigTable();
const LightRigRow& lightRigRow(LightRig rig);
/// Throws base::Error naming the known ones.
LightRig lightRig(std::string_view id);

/// Lamps where only directions are known: one white light's power shared by all of them, somewhat soft.
Lamp lampTowards(const base::Vec3f& direction, std::size_t count);

} // namespace raycast
