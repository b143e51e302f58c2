#include "core/complexes/cell_frame.h"

#include "core/base/mat3.h"
#include "core/complexes/foot_on_cell.h"
#include "core/surface/evaluation/weights.h"

#include <algorithm>

namespace complexes {

using base::Vec3d;
using surface::Cause, surface::Status;

namespace {

struct Weighted {
    Vec3d position;
    double weight;
};

/// Of the cell's own points what counts at x.
struct OwnSums {
    std::vector<Weighted> points;
    Vec3d positions, normals; ///< weighted sums
    double weight = 0, unit = 0;
};

OwnSums sumOwn(const Complex& complex, const Cell& cell, const Vec3d& x) {
    OwnSums out;
    const surface::Weight kind = complex.weight();
    cell.own.tree().forClustersInSupport(base::cast<float>(x), [&](const surfel::SurfelBlock& block, int cluster) {
        const int begin = cluster * surfel::clusterSize, end = std::min(begin + surfel::clusterSize, block.size());
        for (int slot = begin; slot < end; ++slot) {
            const Vec3d p = base::cast<double>(block.position(slot));
            const double support = static_cast<double>(block.support(slot));
            const double theta = surface::weightAt(kind, base::distanceSq(p, x), support);
            if (!(theta > 0))
                continue;
            out.points.push_back({p, theta});
            out.positions += (p - x) * theta;
            out.normals += base::cast<double>(block.normal(slot)) * theta;
            out.weight += theta;
            out.unit += theta * static_cast<double>(surface::unitOf(kind, block.support(slot)));
        }
    });
    return out;
}

/// phi(d / reach) / (d / reach)^2.
double pull(const Attached& each) {
    const double r = each.distance / each.reach;
    return r < 1 ? surface::wendlandC2(r) / (r * r) : 0;
}

std::optional<Attached> attachedTo(const Complex& complex, std::uint32_t b, const Vec3d& x) {
    Attached out;
    out.cell = b;
    if (complex[b].dimension == 0) {
        out.foot = complex.place(b);
        out.reach = complex.reach(b);
    } else {
        const CellFoot foot = footOn(complex, b, x, {});
        if (!foot.ok())
            return std::nullopt;
        out.foot = foot.position;
        out.reach = reachOfUnit * foot.unit;
        out.tangent = foot.on == b ? foot.axis : Vec3d{};
    }
    out.distance = base::distance(x, out.foot);
    return out.distance * reachOfUnit < out.reach ? std::optional(out) : std::nullopt;
}

/// What is prescribed at boundary cell `at`, seen from y: the unoriented mean of the directions near by, as their
/// weighted sum of squares. Zero where nothing is.
base::Mat3d prescribedAt(const Complex& complex, const Cell& cell, std::uint32_t at, const Vec3d& y) {
    base::Mat3d out;
    double second = std::numeric_limits<double>::infinity(), first = second;
    const auto each = [&](const auto& fn) {
        for (const std::uint32_t k : cell.tangents)
            if (const surface::PrescribedTangent& tangent = complex.tangents()[k]; tangent.at == at)
                fn(base::distance(base::cast<double>(tangent.position), y), base::cast<double>(tangent.direction));
    };
    each([&](double d, const Vec3d&) {
        second = std::min(second, std::max(first, d));
        first = std::min(first, d);
    });
    const double reach = std::isfinite(second) ? 2 * second : 2 * first + 1; // two of them, wherever y is
    double weight = 0;
    each([&](double d, const Vec3d& direction) {
        const double theta = d < reach ? surface::wendlandC2(d / reach) : 0;
        out += base::outer(direction, direction) * theta;
        weight += theta;
    });
    if (weight > 0)
        out *= 1 / weight;
    return out;
}

/// The moments of the frame about its centre.
class Moments {
  public:
    Moments(const Complex& complex, const Cell& cell, const Vec3d& x, CellFrame& frame)
        : m_complex(complex), m_cell(cell), m_x(x), m_frame(frame) {}

    base::Mat3d of(const OwnSums& own) const {
        const double most = 1e7 * (own.weight > 0 ? own.weight : 1);
        base::Mat3d out;
        for (const Weighted& each : own.points)
            out += base::outer(each.position - m_frame.centre, each.position - m_frame.centre) * each.weight;
        for (const Attached& each : m_frame.attached) {
            // more would leave no digits to the directions across the tangent
            const double omega = std::min(pull(each), most), inside = omega * each.reach * each.reach;
            if (!(omega > 0))
                continue;
            out += base::outer(each.foot - m_frame.centre, each.foot - m_frame.centre) * omega;
            out += base::outer(each.tangent, each.tangent) * inside;
            if (!m_cell.tangents.empty())
                out += prescribed(each.cell, each.foot) * inside;
        }
        for (const std::uint32_t end : m_cell.tangents.empty() ? std::vector<std::uint32_t>() : m_cell.sharedEnds) {
            const Vec3d place = m_complex.place(end);
            const Attached at{end, place, {}, base::distance(m_x, place), m_complex.reach(end)};
            if (at.distance > 1e-12 * at.reach && at.distance < at.reach)
                out += prescribed(end, at.foot) * (std::min(pull(at), most) * at.reach * at.reach);
        }
        return out;
    }

  private:
    /// Of patches the plane across the prescribed normal, of curves the prescribed tangent.
    base::Mat3d prescribed(std::uint32_t at, const Vec3d& y) const {
        const base::Mat3d mean = prescribedAt(m_complex, m_cell, at, y);
        if (base::trace(mean) <= 0)
            return {};
        const base::SymmetricEigen<double> eigen = base::symmetricEigen(mean);
        const base::Mat3d line = base::outer(eigen.vector[2], eigen.vector[2]);
        return m_cell.dimension == 1 ? line : base::Mat3d::identity() - line;
    }

    const Complex& m_complex;
    const Cell& m_cell;
    Vec3d m_x;
    CellFrame& m_frame;
};

} // namespace

CellFrame frameOf(const Complex& complex, std::uint32_t number, const Vec3d& x, const Vec3d& side) {
    const Cell& cell = complex[number];
    CellFrame out;
    for (const std::uint32_t b : cell.boundary)
        if (const std::optional<Attached> near = attachedTo(complex, b, x))
            out.attached.push_back(*near);
    std::sort(out.attached.begin(), out.attached.end(),
              [](const Attached& a, const Attached& b) { return a.distance < b.distance; });

    const OwnSums own = sumOwn(complex, cell, x);
    out.samples = static_cast<int>(own.points.size());
    out.ownCentre = own.weight > 0 ? x + own.positions / own.weight : cell.centre;
    out.agreement = own.weight > 0 ? length(own.normals) / own.weight : 0;
    if (own.points.empty() && (out.attached.empty() || !(out.attached.front().distance < out.attached.front().reach)))
        return out;

    Vec3d sum = own.positions;
    double weight = own.weight, unit = own.unit;
    out.reached = !out.attached.empty() && out.attached.front().distance < 1e-9 * out.attached.front().reach;
    for (Attached& each : out.attached) {
        each.distance = std::max(each.distance, 1e-9 * each.reach);
        const double omega = pull(each);
        sum += (each.foot - x) * omega;
        weight += omega;
        if (own.weight <= 0)
            unit += omega * each.reach / reachOfUnit;
    }
    out.centre = x + sum / weight;
    out.unit = own.weight > 0 ? own.unit / own.weight : unit / weight;

    const base::SymmetricEigen<double> eigen = base::symmetricEigen(Moments(complex, cell, x, out).of(own));
    constexpr double leastGap = 1e-3; // between the eigenvalues inside and outside of the tangent space
    const double inside = cell.dimension == 1 ? eigen.value[2] : eigen.value[1];
    const double outside = cell.dimension == 1 ? eigen.value[1] : eigen.value[0];
    const double rounding = 1e-16 * out.unit * out.unit * own.weight; // of points in one place
    out.status = Status::Degenerate;
    out.cause = !(eigen.value[2] > rounding) ? Cause::Coincident
                : !(inside > rounding)       ? Cause::Collinear
                                             : Cause::ClosedGap;
    if (!(inside > rounding) || !(inside - outside > leastGap * inside))
        return out;
    out.status = Status::Ok;
    out.cause = Cause::None;
    out.axis = eigen.vector[cell.dimension == 1 ? 2 : 0];
    const Vec3d along = cell.oriented && own.weight > 0 ? own.normals : side;
    if (dot(out.axis, along) < 0)
        out.axis = -out.axis;
    return out;
}

} // namespace complexes
