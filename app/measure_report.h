// What `pointclay measure` found, as text and as JSON (app/README 2.6).
#pragma once

#include "core/mesh/extent/extent.h"
#include "core/process/measuring/histogram.h"
#include "core/process/measuring/primitives.h"
#include "core/session/measured_model.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

/// In coordinates of the file, as they were told.
struct MeasuredDistance {
    base::Vec3d from, to;
};
struct MeasuredAngle {
    std::vector<base::Vec3d> places; ///< three: at the middle one; two: between the surface's normals there
    double rad = 0;
};

struct Measurements {
    base::Vec3d origin; ///< added to places, so that they are the file's
    std::optional<MeasuredDistance> distance;
    std::optional<process::Geodesic> geodesic;
    std::optional<MeasuredAngle> angle;
    std::vector<process::ThicknessAt> thicknessAt;
    std::optional<process::Histogram> histogram; ///< of deviations
    session::MeasuredModel model;
    bool area = false, volume = false;
    std::optional<mesh::Extent> extent;
    std::optional<process::PrimitiveFit> fit;
};

nlohmann::ordered_json measurementsJson(const Measurements& found);
std::string measurementsText(const Measurements& found);

} // namespace app
