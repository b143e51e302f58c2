// What `pointclay measure` found, as text and as JSON (app/README 2.6).
#pragma once

#include "core/mesh/extent/extent.h"
#include "core/process/measuring/deviation.h"
#include "core/process/measuring/primitives.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

struct Measurements {
    base::Vec3d origin; ///< added to places, so that they are the file's
    bool area = false, volume = false;
    std::optional<mesh::Extent> extent;
    std::optional<process::DeviationFigures> deviation;
    std::optional<process::PrimitiveFit> fit;
};

nlohmann::ordered_json measurementsJson(const Measurements& found);
std::string measurementsText(const Measurements& found);

} // namespace app
