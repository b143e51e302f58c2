// How the cells of a point-sampled complex hang together [Adamson07, 9]: what its points alone do not tell. The points
// tell by a number beside them, the attribute `complex_cell`, which of the cells they sample.
//
// Plain data, shared and never changed; part of a surface's definition.
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <vector>

namespace surface {

/// The attribute of a surfel that holds the number of its cell.
inline constexpr const char* cellOfComplex = "complex_cell";

struct ComplexCell {
    int dimension = 2;                   ///< 0 a point, 1 a curve, 2 a patch
    std::vector<std::uint32_t> boundary; ///< cells of one dimension less, by number: a curve's ends, a patch's curves

    bool operator==(const ComplexCell&) const = default;
};

/// Which way cells run where they meet another one [Adamson07, 9.3]: without it each as its own points say.
struct PrescribedTangent {
    std::uint32_t at = 0;             ///< a curve or point
    std::vector<std::uint32_t> cells; ///< those that it binds: patches, or curves that end there
    base::Vec3f position;             ///< on that curve or point
    base::Vec3f direction;            ///< unit: of patches the normal, of curves the tangent; either sign

    bool operator==(const PrescribedTangent&) const = default;
};

struct Connectivity {
    std::vector<ComplexCell> cells;
    std::vector<PrescribedTangent> tangents;

    bool operator==(const Connectivity&) const = default;
};

/// Throws base::Error naming the first rule of complexes that is broken (complexes/README 1).
void requireSound(const Connectivity& connectivity);

} // namespace surface
