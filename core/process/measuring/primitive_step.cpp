#include "core/process/measuring/primitive_step.h"

#include "core/base/parallel.h"
#include "core/process/cleaning/spread.h"

#include <Eigen/Dense>

namespace process {

using base::Vec3d;

namespace {

/// What a step changes: the place along u, v and the axis, the axis towards u and v, and two sizes.
constexpr int most = 7;
using Vector = Eigen::Matrix<double, most, 1>;
using Matrix = Eigen::Matrix<double, most, most>;

struct Frame {
    Vec3d u, v;
    explicit Frame(const Vec3d& axis) : u(base::perpendicular(axis)), v(cross(axis, u)) {}
};

/// Those of the seven that the shape has.
std::array<bool, most> freedoms(Shape shape) {
    switch (shape) {
    case Shape::Plane:
        return {false, false, true, true, true, false, false};
    case Shape::Sphere:
        return {true, true, true, false, false, true, false};
    case Shape::Cylinder:
        return {true, true, false, true, true, true, false};
    case Shape::Cone:
        return {true, true, true, true, true, true, false};
    default:
        return {true, true, true, true, true, true, true};
    }
}

/// The signed distance with its derivatives by the seven. A surface of revolution is F(across, along) of the distances
/// from the axis and along it: its place and its axis move these two and nothing else.
double residual(const Primitive& p, const Frame& frame, const Vec3d& x, Vector& d) {
    const Vec3d q = x - p.place;
    d.setZero();
    if (p.shape == Shape::Sphere) {
        const double r = length(q);
        const Vec3d e = base::normalized(q, frame.u);
        d << -dot(e, frame.u), -dot(e, frame.v), -dot(e, p.axis), 0, 0, -1, 0;
        return r - p.radius;
    }
    const double along = dot(q, p.axis);
    const Vec3d w = q - p.axis * along;
    const double across = length(w);
    const Vec3d e = base::normalized(w, frame.u);
    double value = along, byAcross = 0, byAlong = 1;
    if (p.shape == Shape::Cylinder) {
        value = across - p.radius, byAcross = 1, byAlong = 0;
        d(5) = -1;
    } else if (p.shape == Shape::Cone) {
        const double cosine = std::cos(p.angle), sine = std::sin(p.angle);
        value = across * cosine - along * sine, byAcross = cosine, byAlong = -sine;
        d(5) = -across * sine - along * cosine;
    } else if (p.shape == Shape::Torus) {
        const double off = across - p.radius, far = std::hypot(off, along), safe = std::max(far, 1e-300);
        value = far - p.tube, byAcross = off / safe, byAlong = along / safe;
        d(5) = -byAcross, d(6) = -1;
    }
    if (p.shape == Shape::Plane) {
        d(3) = dot(q, frame.u), d(4) = dot(q, frame.v);
    } else {
        const double tilt = byAlong * across - byAcross * along;
        d(3) = tilt * dot(e, frame.u), d(4) = tilt * dot(e, frame.v);
    }
    const Vec3d push = -(e * byAcross + p.axis * byAlong);
    d(0) = dot(push, frame.u), d(1) = dot(push, frame.v), d(2) = dot(push, p.axis);
    return value;
}

struct Sums {
    Matrix normal = Matrix::Zero();
    Vector right = Vector::Zero();
    double cost = 0;
};

/// Half the squared residual near zero, a constant from the reach on: what the biweight is the derivative of.
double loss(double r, double reach) {
    if (!(reach < std::numeric_limits<double>::infinity()))
        return 0.5 * r * r;
    const double t = std::min(1.0, r * r / (reach * reach)), u = 1 - t;
    return reach * reach / 6 * (1 - u * u * u);
}

double weightOf(double r, double reach) {
    return reach < std::numeric_limits<double>::infinity() ? biweight(r, reach) : 1;
}

constexpr std::size_t grain = 4096;

Sums sumsOf(const Primitive& p, std::span<const Vec3d> points, double reach) {
    const Frame frame(p.axis);
    std::vector<Sums> parts(base::chunkCount(points.size(), grain));
    base::parallelChunks(points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Sums& out = parts[chunk];
        Vector d;
        for (std::size_t i = begin; i < end; ++i) {
            const double r = residual(p, frame, points[i], d), w = weightOf(r, reach);
            out.cost += loss(r, reach);
            if (w > 0) {
                out.normal.noalias() += w * d * d.transpose();
                out.right -= w * r * d;
            }
        }
    });
    Sums out;
    for (const Sums& each : parts)
        out.normal += each.normal, out.right += each.right, out.cost += each.cost;
    return out;
}

double costOf(const Primitive& p, std::span<const Vec3d> points, double reach) {
    std::vector<double> parts(base::chunkCount(points.size(), grain));
    base::parallelChunks(points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i)
            parts[chunk] += loss(p.distance(points[i]), reach);
    });
    double out = 0;
    for (const double each : parts)
        out += each;
    return out;
}

Primitive stepped(Primitive p, const Vector& d) {
    const Frame frame(p.axis);
    p.place += frame.u * d(0) + frame.v * d(1) + p.axis * d(2);
    p.axis = base::normalized(p.axis + frame.u * d(3) + frame.v * d(4), p.axis);
    if (p.shape == Shape::Cone)
        p.angle += d(5);
    else
        p.radius += d(5);
    p.tube += d(6);
    return p;
}

bool isSound(const Primitive& p) {
    constexpr double steepest = 1.5697; // a tenth of a degree short of a plane
    const double all = p.radius + p.tube + p.angle + length(p.place);
    return std::isfinite(all) && p.radius >= 0 && p.tube >= 0 &&
           (p.shape != Shape::Cone || (p.angle > 1e-4 && p.angle < steepest));
}

} // namespace

Primitive descend(const Primitive& start, std::span<const Vec3d> points, double reach, int iterations) {
    constexpr double done = 1e-14;
    const std::array<bool, most> free = freedoms(start.shape);
    Primitive now = start;
    double cost = costOf(now, points, reach), damping = 1e-4;
    for (int k = 0; k < iterations && damping < 1e12; ++k) {
        Sums sums = sumsOf(now, points, reach);
        for (int i = 0; i < most; ++i)
            if (!free[static_cast<std::size_t>(i)]) {
                sums.normal.row(i).setZero();
                sums.normal.col(i).setZero();
                sums.normal(i, i) = 1;
                sums.right(i) = 0;
            }
        Matrix damped = sums.normal;
        for (int i = 0; i < most; ++i)
            damped(i, i) += damping * std::max(sums.normal(i, i), 1e-12);
        const Vector step = damped.ldlt().solve(sums.right);
        const Primitive next = stepped(now, step);
        const double nextCost =
            step.allFinite() && isSound(next) ? costOf(next, points, reach) : std::numeric_limits<double>::infinity();
        if (nextCost > cost) {
            damping *= 10;
            continue;
        }
        const bool still = step.squaredNorm() < done * done;
        now = next, cost = nextCost, damping = std::max(damping * 0.1, 1e-15);
        if (still)
            break;
    }
    return now;
}

} // namespace process
