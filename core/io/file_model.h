// What a file holds, before anything is estimated: points relative to an origin, and all that came along with them.
#pragma once

#include "core/base/up_axis.h"
#include "core/mesh/faces/polygons.h"
#include "core/surface/definition.h"
#include "core/surfel/surfel.h"
#include "core/tree/tree_shape.h"

#include <optional>
#include <string>

namespace io {

/// An element of a PLY file that is not ours to understand: kept byte for byte and written back.
struct OpaqueElement {
    std::string declaration; ///< its header lines, "element NAME N" and its properties, each ended by \n
    std::string body;        ///< its records in little-endian binary
};

struct FileModel {
    surfel::SurfelList points;
    base::Vec3d origin; ///< add to a position to have the file's coordinates; zero unless they are large
    std::optional<surface::SurfaceDefinition> definition; ///< from `comment pointclay ...` lines
    std::optional<base::UpAxis> up;                       ///< where the file tells; else people must see it
    base::UpAxis usualUp = base::UpAxis::Y;               ///< of files of its format
    bool limitDecided = false;         ///< the definition has what Boundary::Auto was resolved to for these points
    bool hasSupports = false;          ///< every point brought a support radius > 0
    tree::TreeShape shape;             ///< of the tree that the points were saved from, as the file claims
    std::size_t faces = 0;             ///< in the file
    mesh::Polygons polygons;           ///< of them, those whose corners are points that are there
    std::size_t dropped = 0;           ///< points that were not finite
    std::string format;                ///< as `info` prints it: "ply binary_little_endian", "xyz", "obj", ...
    std::vector<std::string> comments; ///< of the file, without ours
    std::vector<OpaqueElement> elements;
    std::vector<std::string> messages; ///< one sentence each, for the person
};

} // namespace io
