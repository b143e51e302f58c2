// Sample complexes made by code [Adamson07, 9]: points on patches, curves and corners, and how they hang together.
#pragma once

#include "core/surface/connectivity.h"
#include "core/surfel/surfel.h"

namespace process {

struct ComplexSample {
    surfel::SurfelList points; ///< with the attribute complex_cell, and normals on patches
    surface::Connectivity connectivity;
};

/// About `count` points each. All fit into the ball of radius 1.5 about the origin.
ComplexSample makeSquareComplex(std::size_t count); ///< one patch, four edges
ComplexSample makeGasketComplex(std::size_t count); ///< Sierpinski's: 27 triangles that meet in corners only
ComplexSample makeOctantComplex(std::size_t count); ///< an eighth of a ball: one round face and three flat ones
/// Eight triangles around an apex; along the edges between them they share the cone's planes, so that only the apex and
/// the rim are sharp.
ComplexSample makeConeComplex(std::size_t count);
ComplexSample makeIcosahedronComplex(std::size_t count); ///< flat faces, straight edges
ComplexSample makeBulgedComplex(std::size_t count);      ///< round faces between the same straight edges
/// Arcs and faces of the ball; along the arcs they share its planes, so that nothing is sharp.
ComplexSample makeRoundedComplex(std::size_t count);

} // namespace process
