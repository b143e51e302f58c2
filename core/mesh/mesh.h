// A triangle mesh: what the meshers make, the validator judges and files store.
//
// Positions are float64 relative to the model's origin, so that a vertex can lie on the surface to rounding. Corners
// run counter-clockwise as seen from the side the surface normals point to; on a one-sided surface neighbours agree
// wherever they can. Attributes are interpolated from the surfels where the model has them.
#pragma once

#include "core/base/vec.h"
#include "core/surfel/surfel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace mesh {

/// Why a vertex lies on the boundary (mesh/README 3.4): the surface reaches its off-centre limit there, or its
/// definition breaks down, as at folds and thin parts. Bridge: inside the mesh, where closed surfaces have gaps (3.14).
enum class VertexKind : std::uint8_t { Inner, Limit, Fold, Bridge };

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle that names a vertex twice has no sides.
constexpr bool isProper(const Triangle& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

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
