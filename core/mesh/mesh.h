// A triangle mesh, as tessellations make it, the validator judges it and files hold it.
//
// Positions are float64 relative to the model's origin, so that a vertex can lie on the surface to rounding. Corners
// run counter-clockwise seen from where the surface's normals point; on a surface without two sides they agree from
// triangle to triangle as far as they can. Attributes are interpolated from the surfels where the model has them.
#pragma once

#include "core/base/vec.h"
#include "core/surfel/surfel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mesh {

/// Why a vertex of the boundary is one (RULES-4 B4): the surface ends there by its off-centre limit, or the definition
/// itself ends, at folds and thin parts.
enum class VertexKind : std::uint8_t { Inner, Limit, Fold };

using Triangle = std::array<std::uint32_t, 3>;

struct Mesh {
    std::vector<base::Vec3d> positions;
    std::vector<base::Vec3f> normals;                                    ///< unit gradients; empty: none
    std::vector<surfel::Colour> colours;                                 ///< empty: the model has none
    std::vector<float> masks;                                            ///< empty: the model has none
    surfel::AttributeLayoutPtr layout = surfel::AttributeLayout::none(); ///< of the further attributes
    std::vector<std::uint32_t> extra;                                    ///< layout->words() words per vertex
    std::vector<VertexKind> kinds;                                       ///< empty: unknown
    std::vector<Triangle> triangles;
};

} // namespace mesh
