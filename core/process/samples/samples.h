// Sample models made by code, so that the program ships nobody's data: one table that menus, command line, tests and
// pictures loop over. All surfaces have outward normals unless they simulate a raw scan or have no two sides. Same bits
// for the same parameters.
#pragma once

#include "core/surface/definition.h"
#include "core/surfel/surfel.h"

#include <string_view>

namespace process {

struct SampleRow {
    const char* id;    ///< "sphere", "torus", "knot", "clay", "scan", "coil", "moebius", "square", "gasket"...
    const char* label; ///< as a menu shows it
    const char* tip;
    surfel::SurfelList (*make)(std::size_t count, std::uint64_t seed);
    std::size_t count;                                       ///< surfels unless another number is asked for
    surface::Manifold manifold = surface::Manifold::Surface; ///< what they sample
    /// Of complexes, how the points that `make` gives for the same count hang together.
    surface::Connectivity (*connectivity)(std::size_t count) = nullptr;
};

/// What such a model is, as its row says.
surface::SurfaceDefinition definitionOf(const SampleRow& sample, std::size_t count);

std::span<const SampleRow> sampleTable();
/// Throws base::Error naming the known samples.
const SampleRow& sample(std::string_view id);

} // namespace process
