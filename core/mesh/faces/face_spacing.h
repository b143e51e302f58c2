// How finely faces are sampled already, and how finely they need to be.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/faces/face_points.h"

namespace mesh {

/// Spacing of the vertices as samples: the side of a square as large as a vertex's share of the faces around it,
/// averaged with its neighbours'. At a border the share is that of a full turn. Zero for vertices without faces.
std::vector<float> vertexSpacings(const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// Whether the vertices may stand for the faces: they resolve the shape, are no coarser than some 20,000 of them, and
/// local spacing differs by less than 2.5 times between the 5th and the 95th percentile (mesh/README 8.2).
bool sampleWell(const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// Thickness that all but one percent of the area has at least, where it is below three spacings of 100,000 samples;
/// infinity where walls are thicker.
double thinnestWall(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                    const base::Progress& progress = {}, const InnerPlaces* inside = nullptr);

/// The same of each piece, measured between points spread over them; `spacings`: of these points, of each piece.
std::vector<double> thinnestWalls(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                                  std::span<const FacePoint> points, std::span<const double> spacings,
                                  const base::Progress& progress = {});

/// Is there a convex edge of less than 60 degrees? Towards it walls get thinner than any samples are apart.
bool hasBlades(const FaceTopology& topology);

/// Samples that the shape needs: as many as it has faces, so many that its thinnest walls are three spacings thick;
/// at least 100,000 and at most 5 million. `share`: of the faces' area, what is sampled.
std::size_t fittingCount(const FaceTopology& topology, double thinnestWall, double share = 1);

} // namespace mesh
