// The points among which shapes are looked for (detect_shapes.h), and what of them is on one. Inside this folder.
#pragma once

#include "core/process/measuring/detect_shapes.h"
#include "core/process/measuring/primitive_start.h"
#include "core/process/neighbours/cloud_neighbours.h"

namespace process {

/// What shapes are judged by. Points stand around 0 in units of their extent, with room for each to be off.
class ShapeCloud {
  public:
    ShapeCloud(const surfel::SurfelList& list, const DetectWish& wish, const base::Progress& progress);

    std::size_t size() const { return m_points.size(); }
    const OrientedPoint& point(std::size_t i) const { return m_points[i]; }
    std::uint32_t placeOf(std::size_t listed) const { return m_places[listed]; }
    std::span<const std::uint32_t> near(std::size_t i, NeighbourTable::Row& row) const {
        row = m_table.row(i);
        return std::span<const std::uint32_t>(row).first(m_table.count());
    }

    /// How badly a point fits: 0 exactly, below 1 it is on the shape.
    double misfit(const Primitive& p, std::size_t i) const;
    /// Of `open` points on the shape, the piece of most that hang together; ascending.
    std::vector<std::uint32_t> pieceOn(const Primitive& p, std::span<const std::uint32_t> open) const;
    /// Whether the points face ways that differ by more than normals may: else nothing tells the shape from a plane.
    bool bends(const Primitive& p, std::span<const std::uint32_t> points) const;
    /// Least squares over some of the points.
    Primitive fitted(const Primitive& start, std::span<const std::uint32_t> points) const;
    /// In the list's own units, its place beside the middle of its points; with what these say of it.
    DetectedShape told(const Primitive& p, std::span<const std::uint32_t> points) const;

  private:
    std::vector<OrientedPoint> m_points;
    std::vector<double> m_room; ///< of each: distance from a shape that it is on
    std::vector<std::uint32_t> m_places;
    NeighbourTable m_table;
    base::Vec3d m_centre;
    double m_scale = 1, m_cosine = 0;
};

/// Unit normal of a shape at the place nearest to x; its sign means nothing. Zero where there is none.
base::Vec3d normalAt(const Primitive& p, const base::Vec3d& x);

} // namespace process
