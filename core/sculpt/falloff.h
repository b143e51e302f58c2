// How a dab fades from its centre (r = 0, weight 1) to its rim (r = 1, weight 0). One table of curves.
#pragma once

#include "core/sculpt/brush_curve.h"

#include <span>
#include <string_view>

namespace sculpt {

enum class Falloff { Smooth, Sphere, Root, Sharp, Linear, Constant, Custom };

/// Of Custom, the curves are those without control points: linear.
struct FalloffRow {
    Falloff value;
    const char* id; ///< as sessions name it: "smooth"
    const char* label;
    float (*weight)(float r); ///< for r in [0, 1]
    float (*slope)(float r);  ///< its derivative, exact for r in [0, 1 - 1e-6] (Sphere and Root are vertical at 1)
};

std::span<const FalloffRow> falloffTable();
const FalloffRow& row(Falloff falloff);
/// Throws base::Error naming the known curves.
Falloff falloff(std::string_view id);

/// Weight at distance r radii; 0 for r >= 1.
float weight(Falloff falloff, float r);

/// Weights and slopes of many distances r >= 0 at once, the hot loop's form: beyond the rim both are 0. Inside
/// `plateau` (a part of the radius, below 1) the weight stays that of the centre, and the curve runs from there to the
/// rim. `curve`: what Falloff::Custom is; null: its row's.
void weights(Falloff falloff, float plateau, std::span<const float> r, std::span<float> weight, std::span<float> slope,
             const BrushCurve* curve = nullptr);

} // namespace sculpt
