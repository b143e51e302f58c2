// Where samples of faces go, and how far apart they are: evenly, or on each body of a scene as it needs (mesh/README
// 8.3).
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_points.h"
#include "core/mesh/faces/open_faces.h"

namespace mesh {

struct FaceSampling {
    std::vector<FacePoint> points;
    std::vector<double> spacings; ///< of each, or one for all
    bool apart = false;           ///< all walls are resolved

    std::string toldSpacing() const;
};

/// As many as the options say, or the shape needs. Throws base::Error where that is more than memory is meant to hold,
/// base::Cancelled.
FaceSampling sampleFaces(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                         const InnerPlaces& inside, const surface::SurfaceDefinition& definition,
                         const FaceOptions& options, const base::Progress& progress);

} // namespace mesh
