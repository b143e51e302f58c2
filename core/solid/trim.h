// A model cut along an outline that is drawn in a picture of it, straight through: what lies behind the outline goes,
// or is all that stays, and walls close it (solid/README 3.1).
#pragma once

#include "core/solid/cut.h"
#include "core/solid/outline_side.h"

namespace solid {

enum class Trim { Away, Keep }; ///< what the outline holds

/// `options` as for a cut: the walls are as dense as the model is beside them, and their edges stay sharp. Throws as
/// combine does, and base::Error where the outline holds nothing, or nothing else.
Combined trimmed(const surface::Surface& model, const OutlineSide& side, Trim trim, const CutOptions& options = {},
                 const base::Progress& progress = {});

/// The same outline without corners that lie within 1/4000 of its extent of the line through those beside them: hands
/// draw hundreds where some tens tell the same.
std::vector<base::Point2> plainOutline(const std::vector<base::Point2>& corners);

} // namespace solid
