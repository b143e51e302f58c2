// A triangulation with its vertices on a surface: what Delaunay refinement works on. Internal to the room.
#pragma once

#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/finish/own_sheet.h"
#include "core/surface/evaluation/source.h"

#include <optional>

namespace mesh {

/// The ball through a face's corners whose centre lies on the surface, near the face and on its own sheet. Where none
/// is found, as at folds, the smallest ball through the corners.
struct Ball {
    base::Vec3d centre;
    double radius = 0;
    bool onSurface = false;

    bool holds(const base::Vec3d& x) const {
        constexpr double rounding = 1e-7; // more than f's in float
        return distanceSq(x, centre) < radius * radius * (1 - rounding);
    }
};

/// How f is asked. OwnSheet: each face for the sheet that its corners face along. AsItIs: for what is there; faces know
/// which way is out, as those of closed surfaces do, and f has no steps.
enum class Asking : std::uint8_t { OwnSheet, AsItIs };

class SurfaceTriangulation : public Triangulation {
  public:
    /// REQUIRES: positions, normals and kinds of a manifold mesh; `surface` outlives the triangulation.
    SurfaceTriangulation(const surface::Surface& surface, const Mesh& mesh, Asking asking = Asking::OwnSheet);

    std::vector<base::Vec3d> positions;
    std::vector<base::Vec3f> normals; ///< unit gradients; of either sign where the surface has no sides
    std::vector<VertexKind> kinds;

    /// A vertex that is not in use yet.
    std::uint32_t addVertex(const SurfacePoint& at, VertexKind kind);
    std::array<base::Vec3d, 3> cornersOf(const Triangle& t) const {
        return {positions[t[0]], positions[t[1]], positions[t[2]]};
    }
    /// Unit, of the side from which the corners run counter-clockwise; zero without area.
    base::Vec3d faceNormal(const Triangle& t) const;
    /// The mean of the corners' normals, unit, with the first one's sign.
    base::Vec3d surfaceNormal(const Triangle& t) const;
    /// Cosine between a face and the surface's normals at its corners; negative where it runs the other way.
    double facing(const Triangle& t) const { return dot(faceNormal(t), surfaceNormal(t)); }

    Ball ball(const Triangle& t);
    /// Which way the surface may face where one looks for it.
    struct Facing {
        base::Vec3d normal;
        double least = 0.5; ///< cosine to it
    };
    /// As a face's corners do, and no further away than they from their mean.
    Facing facingOf(const Triangle& t) const;
    /// The root of f on a line, at most `reach` from x; asked as it is, one where the surface faces along the line.
    struct Root {
        double t = 0;
        base::Vec3f normal;
    };
    std::optional<Root> root(const base::Vec3d& x, const base::Vec3d& along, double reach, const Facing& facing);
    /// f over its slope at x, on the sheet with that normal; infinite where the definition gives none.
    double height(const base::Vec3d& x, const base::Vec3d& normal);

    const surface::Surface& surface() const { return m_source.surface(); }
    /// Of the faces that are not left out; vertices keep their numbers.
    Mesh mesh(const std::vector<bool>& leftOut) const;

  private:
    struct Sheet {
        double value = 0;
        base::Vec3d gradient; ///< zero where the definition gives none
        double unit = 0;
    };
    Sheet evaluate(const base::Vec3d& x, const base::Vec3d& normal);

    surface::Source m_source;
    Asking m_asking;
};

} // namespace mesh
