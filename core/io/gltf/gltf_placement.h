// Where the nodes of a glTF file place their meshes, and its materials their pictures; what its colours are.
#pragma once

#include "core/io/file_model.h"
#include "core/io/gltf/gltf_json.h"
#include "core/io/scene/scene_points.h"

#include <array>

namespace io::gltf {

/// Of linear shares, as glTF has them.
surfel::Colour srgbOf(const std::array<double, 4>& linear);

/// Of a node: its matrix by columns, or its shift, turn and scale.
Placement placementOf(const json& node);

/// Where a corner's place in the picture is, after KHR_texture_transform.
struct PicturePlace {
    double offset[2] = {0, 0}, scale[2] = {1, 1}, turn = 0;

    mesh::Polygons::Place operator()(double u, double v) const;
};

} // namespace io::gltf
