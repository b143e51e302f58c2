// Between which radii a slider runs, in the unit that is chosen: one rule for every slider of it.
#pragma once

#include "ui/panels/number_slider.h"
#include "ui/settings/settings.h"

#include <algorithm>
#include <cmath>

namespace ui {

/// `diagonal`: of the model, > 0.
inline NumberRange radiusRange(const Settings& settings, double diagonal) {
    if (settings.radiusUnit == RadiusUnit::Pixels)
        return {Settings::minRadiusPx, Settings::maxRadiusPx, true, 0, QObject::tr("px")};
    const int digits = static_cast<int>(std::ceil(-std::log10(diagonal))) + 3;
    return {diagonal * 1e-3, diagonal * 0.5, true, std::clamp(digits, 0, 9), {}};
}

inline double radiusOf(const Settings& settings) {
    return settings.radiusUnit == RadiusUnit::Pixels ? settings.radiusPx : settings.radiusModel;
}

} // namespace ui
