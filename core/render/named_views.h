// The views that have names: along the axes of a model that stands (base/up_axis.h). One table for keys, menus and the
// command line.
#pragma once

#include "core/render/camera.h"

#include <span>
#include <string_view>

namespace render {

struct NamedView {
    const char* id;        ///< "front"
    const char* label;     ///< "Front"
    const char* shortcut;  ///< "1"; with Ctrl what lies opposite
    base::Vec3d toEye, up; ///< with y upwards

    /// The same view of a model with another axis upwards.
    NamedView of(base::UpAxis axis) const {
        return {id, label, shortcut, fromStanding(axis, toEye), fromStanding(axis, up)};
    }
};
std::span<const NamedView> namedViews();
/// Null where there is none of that name.
const NamedView* namedView(std::string_view id);

} // namespace render
