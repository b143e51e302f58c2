// The cells around one place, and what the surface of each says there (cells/README 2).
//
//     CellSource source(surface);
//     source.moveTo(x);                             finds the surfels in support, and by them the cells
//     for (i < source.count()) source.at(i, need)   f, gradient and so on of cell i, each computed once
//
// Float64. Positions that come close to the one before find their surfels among those collected around it; the answers
// are those of a fresh source, bit for bit. One thread at a time.
#pragma once

#include "core/cells/cell_surface.h"
#include "core/surface/evaluation/source.h"

#include <algorithm>

namespace cells {

/// A cell that surfels in support have as partner, while none of its own is in support: where it is sampled more
/// finely.
struct AbsentCell {
    std::uint32_t cell = 0;
    double weight = 0, convex = 0, sharpness = 0; ///< sums of weights: all, with sign, times sharpness

    Meeting meeting() const { return convex > 0 ? Meeting::Convex : convex < 0 ? Meeting::Concave : Meeting::None; }
    /// Of one more surfel, to the partner that it has among them.
    static void add(const Label& label, double theta, std::vector<AbsentCell>& all);
};

class CellSource {
  public:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    static constexpr double settled = 1e-13;   ///< of the support: steps after which an iteration ends
    static constexpr double precision = 1e-13; ///< of the support: to which zeros are bracketed
    static constexpr double rounding = 4 * std::numeric_limits<double>::epsilon(); ///< of a coordinate

    explicit CellSource(const CellSurface& surface);

    const CellSurface& surface() const { return *m_surface; }
    void setScale(double) {} ///< as CellSourcef; of no use here
    void moveTo(const base::Vec3d& x);
    const base::Vec3d& position() const { return m_x; }

    /// Cells with surfels in support, by ascending label.
    std::size_t count() const { return m_cells.size(); }
    std::uint32_t cell(std::size_t i) const { return m_cells[i].cell; }
    /// The place of a cell among them, or `none`.
    std::size_t find(std::uint32_t cell) const;
    /// Has one cell only surfels in support?
    bool alone() const { return count() == 1; }
    /// Surfels of cell i alone that are in support.
    int samples(std::size_t i) const { return m_cells[i].samples; }

    /// How cell i meets cell j near here, as most of the surfels with the other one as partner have it. None where no
    /// surfel in support has: walls of a thin plate do not cut each other off. Surfels of j alone tell nothing where
    /// none of i is beside any crease: theirs may lie beyond a wall.
    Meeting meeting(std::size_t i, std::size_t j) const;

    /// Partners of surfels of cell i in support that have none in support themselves.
    std::vector<AbsentCell> absent(std::size_t i) const;

    /// How sharp the crease between cells i and j is, 0 to 1: the mean of the surfels beside it. Zero without a crease.
    double sharpness(std::size_t i, std::size_t j) { return meeting(i, j) == Meeting::None ? 0 : 1 - shareOf(i, j).v; }

    /// What cell i's surface is at the position: the sums over its own surfels and those of cells that are smooth to
    /// it. The status does not tell whether there is a boundary
    /// (local_boolean.h).
    const surface::Evaluationd& at(std::size_t i, surface::Need need);
    /// A plane of a cell.
    struct Tangent {
        base::Vec3d normal, centroid;
        double height = 0; ///< of the position above it
    };
    /// n, c and f of cell i, or where its surfels are too few for that, the mean of its surfels' planes by weight: what
    /// cuts others off at the tips of slender faces. Not numbers where it has no weight.
    Tangent tangent(std::size_t i);
    /// Sums over cell i's own surfels alone.
    struct Sums {
        double weight = 0, height = 0;
        base::Vec3d way, normal; ///< of theta q and theta n, q from the position to the surfel

        void add(double theta, const base::Vec3d& q, const base::Vec3d& n) {
            weight += theta;
            height -= theta * dot(n, q);
            way += q * theta;
            normal += n * theta;
        }
        Tangent plane(const base::Vec3d& x) const {
            return {base::normalized(normal), x + way / weight, height / weight};
        }
    };
    Sums sums(std::size_t i) const;
    /// Is one of cell i's own surfels so near that the surface which it tells of can be here?
    bool reaches(std::size_t i) const;
    /// Are sums of cell i those of j too: of one face, without a crease between them?
    bool smooth(std::size_t i, std::size_t j) const {
        return m_cells[i].face == m_cells[j].face && meeting(i, j) == Meeting::None;
    }

    /// fn(position, label, distanceSq) for the surfels in support.
    template <class Fn>
    void forSurfels(const Fn& fn) const {
        for (const Found& each : m_found)
            fn(each.of->position, each.of->label, each.distanceSq);
    }

  private:
    /// A surfel that has weight somewhere in the box that was collected for.
    struct Around {
        base::Vec3d position;
        double supportSq; ///< of the scaled support
        base::Vec3f normal;
        float support; ///< as the surfel has it
        base::Vec3f shape;
        Label label;
    };
    struct Found {
        const Around* of;
        std::uint32_t cell; ///< place among the cells
        double distanceSq;
    };
    struct Near {
        std::uint32_t cell = 0, face = 0;
        int samples = 0;
        bool beside = false; ///< some of its surfels in support are beside a crease
        bool known = false;
        surface::Need need = surface::Need::Value;
        surface::Evaluationd at;
    };
    /// What a cell j adds to the sums of a cell i: all, nothing, or a share that moves with x.
    struct Share {
        double v = 0;
        base::Vec3d slope;
    };

    void collect();
    void gather();
    void meet() const;
    double weightOf(const Found& found) const;
    Share shareOf(std::size_t i, std::size_t j);
    surface::Evaluationd sumOf(std::size_t i, surface::Need need);
    surface::Evaluationd layered(const std::vector<Share>& shares, surface::Need need);
    /// Clusters of the surfels that `take` tells: fn(found) as a normal to use in place of their own, if it has one.
    template <class Take>
    surface::ClusterSpan pack(const Take& take);
    surface::Evaluationd evaluate(surface::ClusterSpan clusters, surface::Need need) const;
    surface::SumOptions plainSums() const;
    double& vote(std::size_t i, std::size_t j) const { return m_votes[i * m_cells.size() + j]; }

    const CellSurface* m_surface;
    surface::Source m_source;
    int m_shape;                 ///< channel of shapes; 0: none
    std::size_t m_clusterFloats; ///< of those that are packed
    base::Vec3d m_x;
    base::Box3d m_box; ///< positions in it need no other surfels than these
    std::vector<Around> m_around;
    double m_slack = 0; ///< how far around a position to collect; 0 before anything is known
    std::vector<Found> m_found;
    std::vector<Near> m_cells;
    bool m_faded = false;                ///< are there creases near that are not quite sharp?
    mutable std::vector<double> m_votes; ///< convex > 0, concave < 0, by cell and partner; empty before anyone asked
    std::vector<float> m_packed;
    std::vector<const float*> m_clusters;
};

/// Has the evaluation numbers?
inline bool valid(const surface::Evaluationd& at) {
    return at.status == surface::Status::Ok || at.status == surface::Status::BeyondBoundary;
}

} // namespace cells
