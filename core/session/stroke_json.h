// Strokes as session lines and back: {"op":"stroke","tool":...,"samples":[[ox,oy,oz,dx,dy,dz,pressure,seconds],...]}.
// A sample whose stride is not 1 has it as a ninth number, one with a reach has that as a tenth.
//
// Options are encoded as option_json.h says, in rows of one table. Samples stand in file coordinates (origin included)
// as shortest decimals of doubles, so that settings and samples come back bit for bit; where the origin is large,
// positions are first put on places that do (`recordable`).
#pragma once

#include "core/sculpt/stroke/stroke.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// The place next to the sample's that survives the way to file coordinates and back. Itself where `origin` is zero.
sculpt::StrokeSample recordable(const sculpt::StrokeSample& sample, const base::Vec3d& origin);

/// REQUIRES: samples are recordable.
nlohmann::json strokeLine(const sculpt::StrokeSettings& settings, std::span<const sculpt::StrokeSample> samples,
                          const base::Vec3d& origin);

/// Settings of a complete `stroke` command.
sculpt::StrokeSettings strokeSettings(const nlohmann::json& complete);
/// Throws base::Error naming the sample that is no ray with pressure 0 to 1 and seconds >= 0.
std::vector<sculpt::StrokeSample> strokeSamples(const nlohmann::json& complete, const base::Vec3d& origin);

} // namespace session
