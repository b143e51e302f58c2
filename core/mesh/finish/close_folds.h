// Closes boundary loops where the definition of the surface breaks down, as at folds (mesh/README 3.9).
#pragma once

#include "core/mesh/finish/finishing.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct FoldClosing {
    double cell = 0;        ///< side of the cubes that the mesh was made with; 0: they vary, as the loops' edges do
    bool everyLoop = false; ///< even where no surface spans the loop
    std::size_t longest = Finishing{}.longestFold; ///< most edges of a loop to close
    std::size_t shortHole = 8;                     ///< most edges where the surface spans it
};

/// Closes loops that have a VertexKind::Fold vertex with a triangle fan about their middle: short ones if the middle
/// lies on the sheet around them, since the surface continues there and only f has a step; with `everyLoop` all up to
/// `longest`, wherever their middle lies. The loops' vertices become Inner. Returns the new vertices in the middle.
/// REQUIRES: normals and kinds; a manifold mesh.
std::vector<std::uint32_t> closeFolds(Mesh& mesh, const surface::Surface& surface, const FoldClosing& options);

} // namespace mesh
