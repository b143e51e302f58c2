// From the faces of a file to surfels: a mesh opens as the surface that its faces are, not as a cloud of their corners.
//
//     sampled     points spread over the faces, exactly on them, with normals, colours and attributes of their corners
//     vertices    the file's own, where they sample the faces well or on request; normals of the faces
//
// What keeps sides of a sharp edge apart later is kept now: where there are several patches, each surfel carries the
// number of its own as the attribute `patch`.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_paint.h"
#include "core/surface/definition.h"

#include <numbers>
#include <optional>
#include <string>

namespace mesh {

enum class FaceUse { Auto, Sample, Vertices };

struct FaceOptions {
    FaceUse use = FaceUse::Auto;
    double spacing = 0;                         ///< of samples, in model units; 0: from `count`
    std::size_t count = 0;                      ///< of samples; 0: what the shape needs
    double sharpRad = std::numbers::pi * 2 / 9; ///< edges of a larger dihedral angle stay sharp (40 degrees)
    /// Do samples get labels of cells that meet in the sharp edges (face_creases.h)? By default where that serves them.
    std::optional<bool> creases = std::nullopt;

    /// Whoever said so wants samples and not the file's vertices.
    bool asksForSamples() const { return use == FaceUse::Sample || spacing > 0 || count > 0; }
    bool asksForCreases() const { return creases == true; }
};

struct OpenedFaces {
    surfel::SurfelList points; ///< samples with their supports, vertices with those that they came with
    bool sampled = false;
    bool closed = false; ///< the faces have no boundary
    bool rims = false;   ///< they have one, and the points tell where (face_rims.h)
    bool blades = false; ///< there are edges of less than 60 degrees, towards which no samples resolve walls
    bool apart = false;  ///< the samples resolve all walls: sheets need not be told apart (Definition::oneSheet)
    std::vector<std::string> messages;
};

/// Vertices with the triangles between them, and what the faces are painted with, of these very triangles; without
/// triangles that have an area the vertices come back as they are. Supports of samples are those of the definition on
/// an even sampling of the faces. Throws base::Error where more samples are asked for than memory is meant to hold, or
/// samples of faces without area, base::Cancelled.
OpenedFaces openFaces(surfel::SurfelList vertices, std::span<const Triangle> triangles,
                      const surface::SurfaceDefinition& definition, const FaceOptions& options,
                      const base::Progress& progress = {}, const FacePaint* paint = nullptr);

} // namespace mesh
