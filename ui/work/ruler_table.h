// What can be measured between places of the surface that a person picks: one table, over which the bar, the window and
// tests loop. The measures themselves are the core's, as `measure` tells them.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <span>
#include <string>
#include <vector>

namespace ui {

/// A place of the surface that was picked, in stored coordinates.
struct RuledPlace {
    base::Vec3d position, normal;
};

/// What was measured, and how to show it: stored coordinates.
struct Ruled {
    double value = 0;              ///< model units; degrees where `degrees`; NaN: there is none
    bool degrees = false;          ///< of an angle
    std::vector<base::Vec3d> line; ///< what was measured along; may be empty
    std::string text;              ///< what is told beside the value; may be empty
};

struct RulerRow {
    const char* id; ///< "distance"
    const char* label;
    const char* tip;
    std::size_t places; ///< to pick
    /// Throws base::Error where there is no answer, base::Cancelled. `origin` of stored coordinates.
    Ruled (*measure)(const surface::Surface& surface, std::span<const RuledPlace> places, const base::Vec3d& origin,
                     const base::Progress& progress);
};
std::span<const RulerRow> rulerTable();

/// "1.2346", "0.0012", "37.5°": five digits.
std::string textOf(const Ruled& ruled);

} // namespace ui
