// What was found of creases when a mesh was cut before (mesh/README 10.4): it is cut again and again with few vertices
// elsewhere, and where nothing has moved a search would find the same, to the bit. Internal to the room.
#pragma once

#include "core/mesh/seams/crease_vertices.h"

#include <unordered_map>
#include <vector>

namespace mesh {

/// What a vertex beside other cells could move to.
struct CreaseSnap {
    std::optional<CreasePlace> corner, seam;
};

/// The ends of an edge, and the place of a seam between them, if there is one.
struct CreaseSplit {
    struct End {
        CellsAt cells;
        base::Vec3d position;

        bool operator==(const End&) const = default;
    };
    End from, to;
    std::optional<CreasePlace> place;
};

/// REQUIRES: used for cuts of one and the same mesh.
struct CreaseMemory {
    std::vector<CreaseVertex> faces; ///< vertices when snaps were looked for; empty before
    std::vector<CreaseSnap> snaps;
    std::unordered_map<std::uint64_t, CreaseSplit> splits; ///< by names of edges
};

} // namespace mesh
