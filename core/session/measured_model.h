// Measured numbers put into the model: attributes `deviation` and `thickness`, and colours by one of them. The same for
// the command `measure` and the subcommand.
#pragma once

#include "core/process/measuring/deviation.h"
#include "core/process/measuring/thickness.h"

#include <optional>
#include <string>
#include <utility>

namespace session {

struct MeasuredModel {
    std::optional<process::Deviations> deviation;
    std::optional<process::Thicknesses> thickness;
    std::string colours;                            ///< "deviation", "thickness"; empty: as they are
    std::optional<std::pair<double, double>> range; ///< that colours span; most of the numbers unless told
};

constexpr const char* measuredNames = "deviation thickness";

/// Throws base::Error where colours are asked for by what was not measured.
surface::Surface withMeasured(const surface::Surface& surface, const MeasuredModel& measured);

/// The sentences that tell of it.
std::string sentenceOf(const process::DeviationFigures& figures);
std::string sentenceOf(const process::ThicknessFigures& figures);

} // namespace session
