// What may be added to or removed from a mesh once its triangles are made, by either method (mesh/README 3.9, 3.10).
#pragma once

#include <cstddef>

namespace mesh {

struct Finishing {
    /// Close all loops of up to `longestFold` edges where the definition breaks down, whatever angles and distances
    /// result. Without it, marching cubes still closes short ones where the surface continues behind a step of f.
    bool closeFolds = false;
    std::size_t longestFold = 24;
    bool dropSmall = false; ///< remove pieces of fewer than `smallPiece` triangles
    std::size_t smallPiece = 200;
};

} // namespace mesh
