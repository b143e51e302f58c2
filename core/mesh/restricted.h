// The restricted Delaunay triangulation itself, in front of CGAL's surface mesher, which stays behind this header. See
// delaunay.h. One thread at a time.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

#include <functional>
#include <memory>
#include <span>

namespace mesh {

/// What facets must fulfil.
struct FacetDemand {
    double leastAngle = 0; ///< radians
    double distance = 0;   ///< of a facet from the surface
    double floor = 0;      ///< balls smaller than this are not refined any more, whatever their facets lack
    std::function<double(const base::Vec3d&)> size; ///< largest radius of the ball about a place
};

/// Where the mesh shall end: vertices along a rim, in order.
struct RimChain {
    std::vector<base::Vec3d> positions, normals;
    bool closed = false;
};

class RestrictedDelaunay {
  public:
    /// REQUIRES: `surface` outlives it.
    RestrictedDelaunay(const surface::Surface& surface, FacetDemand demand);
    ~RestrictedDelaunay();

    void addRim(const RimChain& rim);
    void add(std::span<const base::Vec3d> points);
    /// Until all facets fulfil the demand and form a manifold, as far as the floor allows. Throws base::Cancelled.
    void refine(const base::Progress& progress);
    /// Positions, triangles and kinds: Limit for vertices of rims. Facets have no side yet. Those that break the demand
    /// are left out.
    Mesh mesh() const;
    /// Facets that break the demand.
    std::size_t unrefined() const;

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace mesh
