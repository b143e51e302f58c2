// How a dab fades from its centre (r = 0, weight 1) to its rim (r = 1, weight 0). One table of curves.
#pragma once

#include <span>
#include <string_view>

namespace sculpt {

enum class Falloff { Smooth, Sphere, Root, Sharp, Linear, Constant };

struct FalloffRow {
    Falloff falloff;
    const char* id; ///< as sessions name it: "smooth"
    const char* label;
    float (*weight)(float r); ///< for r in [0, 1]
    float (*slope)(float r);  ///< its derivative
};

std::span<const FalloffRow> falloffTable();
const FalloffRow& row(Falloff falloff);
/// Throws base::Error naming the known curves.
Falloff falloff(std::string_view id);

/// Weight at distance r radii; 0 for r >= 1.
float weight(Falloff falloff, float r);

} // namespace sculpt
