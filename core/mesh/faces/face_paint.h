// The colours that faces have of their own, at any point of them: a picture's, where its face has one and the corners
// have places in it, else the face's.
#pragma once

#include "core/mesh/faces/polygons.h"

#include <array>
#include <optional>

namespace mesh {

class FacePaint {
  public:
    /// Of triangles that were cut from polygons. Both outlive it.
    FacePaint(const Polygons& polygons, const CutPolygons& triangles) : m_polygons(polygons), m_cut(triangles) {}

    /// At weights of the corners of triangle `t`, in its own order; nothing where its face has no colour.
    std::optional<surfel::Colour> at(std::size_t t, const std::array<float, 3>& weights) const;
    /// The same with weights for `corners`, which may run the other way round than the triangle.
    std::optional<surfel::Colour> at(std::size_t t, const Triangle& corners, const std::array<float, 3>& weights) const;
    /// Gives vertices the mean colour of what their faces have there; others keep theirs.
    void paint(std::span<surfel::Surfel> vertices) const;

  private:
    const Polygons& m_polygons;
    const CutPolygons& m_cut;
};

} // namespace mesh
