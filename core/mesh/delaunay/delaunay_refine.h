// Refines a triangulation until it is a Delaunay one on the surface and fulfils a demand (mesh/README 4.4, 4.5).
// Internal to the room.
//
// After [Chew93]: the ball through a face's corners about a point of the surface holds no corner of its neighbours,
// else the side between them is flipped; the centre of a bad face's ball becomes a vertex; where it would come too near
// to the boundary, the side there is halved instead [Ruppert95]. What is near in space but not along the surface never
// meets: sheets that touch, folds, thin parts. A closed surface stays closed (kept_closed.h).
#pragma once

#include "core/mesh/delaunay/coarsen.h"

#include <queue>

namespace mesh {

/// What faces must fulfil.
struct FaceDemand {
    double leastAngle = 0; ///< radians
    double distance = 0;   ///< of a face from the surface
    double floor = 0;      ///< balls smaller than this are not refined any more, whatever their faces lack
    double foldFloor = 0;  ///< the same where no point of the surface is the centre of a ball
    SizeField size;        ///< largest radius of the ball about a point
};

class DelaunayRefinement {
  public:
    /// With `closed` faces that it holds ask for nothing and stay. REQUIRES: all outlive the refinement.
    DelaunayRefinement(SurfaceTriangulation& mesh, const FaceDemand& demand, KeptClosed* closed = nullptr);

    /// Throws base::Cancelled.
    void run(const base::Progress& progress);
    /// By face: those that break the demand, held ones too.
    std::vector<bool> failing();

  private:
    struct Facet {
        Ball ball;
        std::uint32_t version = 0; ///< counts its changes
        bool touched = false;      ///< changed, not judged since
    };
    struct Bad {
        double radius;
        std::uint32_t face, version;
        bool operator<(const Bad& o) const {
            return radius != o.radius ? radius < o.radius : face != o.face ? face > o.face : version > o.version;
        }
    };
    struct Location {
        Side side;            ///< the face, and the side that the point is nearest to
        bool outside = false; ///< beyond that side, which is on the boundary
        bool found = false;
        std::array<double, 3> weights{}; ///< of the corners
        double least() const { return weights[std::size_t(side.k)]; }
    };

    bool held(std::uint32_t face) const { return m_closed && m_closed->held(face); }
    bool isProtected(const Side& s) const;
    bool allows(std::span<const Triangle> made, std::span<const std::uint32_t> instead) const;
    bool fails(std::uint32_t face);
    bool isFar(const Triangle& t, const Ball& ball);
    void touch(std::uint32_t face, const Ball& ball);
    void touchOneRing(std::uint32_t vertex);
    void judgeTouched();
    void settle(const base::Progress& progress = {});
    bool improve(const Side& s, bool byBalls);
    Location locate(std::uint32_t face, const base::Vec3d& x) const;
    Side encroached(std::uint32_t face, const base::Vec3d& x) const;
    bool inBall(const Side& s, const base::Vec3d& x) const;
    bool refine(const Bad& bad);
    std::optional<SurfacePoint> pointOver(std::uint32_t face, const base::Vec3d& x);
    bool insertCentre(const Bad& bad);
    bool insertMiddle(std::uint32_t face);
    bool split(const Location& where, std::uint32_t vertex);
    bool splitFace(std::uint32_t face, std::uint32_t vertex);
    bool splitSide(const Side& s, std::uint32_t vertex);
    bool fit(std::span<const Triangle> faces, std::span<const Triangle> was, double good) const;
    std::optional<SurfacePoint> middleOf(const Side& s, VertexKind& kind);
    bool halve(const Side& s);
    Side longestSide(std::uint32_t face) const;

    SurfaceTriangulation& m_mesh;
    const FaceDemand& m_demand;
    KeptClosed* m_closed;
    std::vector<Facet> m_facets;
    std::vector<std::uint32_t> m_touched, m_open; ///< to be judged; whose sides are to be looked at
    std::priority_queue<Bad> m_bad;
};

} // namespace mesh
