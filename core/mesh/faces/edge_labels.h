// What becomes of a file's sharp edges when its faces are sampled: labels that keep them sharp, or a sentence why not.
#pragma once

#include "core/mesh/faces/crease_chains.h"
#include "core/mesh/faces/face_points.h"
#include "core/mesh/faces/open_faces.h"

namespace mesh {

/// Is this a part with edges, however finely it is cut into triangles? Its vertices have no labels, its samples do.
bool hasSureCreases(const FaceTopology& topology);

/// Sharp edges that would be rounded as noise if the faces were sampled as densely as their vertices lie.
std::vector<SharpEdge> noisyEdges(const FaceTopology& topology);

/// The edges that are no noise, unless somebody decided; normals are smooth over those that are `rounded`, and no
/// blades are there.
CreaseChains keptEdges(const FaceTopology& topology, const FaceOptions& options, const std::vector<FacePoint>& points,
                       std::span<const double> spacings);

/// Labels the samples beside sharp edges; returns what became of the edges that do not stay sharp, as a sentence, else
/// nothing. `kept`: as above; `samples` are those of `points`, `spacings` that of each, or one for all.
std::string labelEdges(const FaceTopology& topology, const FaceOptions& options, const CreaseChains& kept,
                       const std::vector<FacePoint>& points, std::span<const double> spacings,
                       surfel::SurfelList& samples);

} // namespace mesh
