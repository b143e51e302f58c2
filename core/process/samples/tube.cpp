#include "core/process/samples/tube.h"

#include "core/base/parallel.h"
#include "core/process/samples/even_rows.h"

#include <algorithm>
#include <memory>
#include <numbers>

namespace process {

namespace {

using base::Vec3d;

constexpr double turn = 2 * std::numbers::pi;
constexpr std::size_t steps = 4096;

/// Mirror image of v in the plane perpendicular to `axis`.
Vec3d mirrored(const Vec3d& v, const Vec3d& axis) {
    return v - axis * (2 * base::dot(v, axis) / base::lengthSq(axis));
}

/// Frame along the curve by double reflection (W. Wang et al., Computation of rotation minimizing frames, 2008), with
/// the angle that is missing when the curve closes spread evenly over it.
class TubeFrame {
  public:
    explicit TubeFrame(const Tube& tube) : m_tube(tube), m_first(steps + 1) {
        m_first[0] = base::perpendicular(unitTangent(0));
        for (std::size_t k = 0; k < steps; ++k) {
            const Vec3d across = tube.centre(parameter(k + 1)) - tube.centre(parameter(k));
            const Vec3d carried = mirrored(unitTangent(parameter(k)), across);
            m_first[k + 1] =
                base::normalized(mirrored(mirrored(m_first[k], across), unitTangent(parameter(k + 1)) - carried));
        }
        const Vec3d second = base::cross(unitTangent(0), m_first[0]);
        m_twist = std::atan2(base::dot(m_first[steps], second), base::dot(m_first[steps], m_first[0]));
    }

    RowPoint at(double t, double angle) const {
        const double k = t / turn * steps;
        const std::size_t i = std::min(steps - 1, static_cast<std::size_t>(k));
        const double part = k - static_cast<double>(i);
        const Vec3d along = unitTangent(t), between = m_first[i] * (1 - part) + m_first[i + 1] * part;
        const Vec3d u = base::normalized(between - along * base::dot(between, along)), v = base::cross(along, u);
        const double turned = angle - m_twist * t / turn;
        const Vec3d n = base::normalized(u * std::cos(turned) + v * std::sin(turned));
        return {m_tube.centre(t) + n * m_tube.radius, n};
    }

    static double parameter(std::size_t k) { return turn * static_cast<double>(k) / steps; }

  private:
    Vec3d unitTangent(double t) const { return base::normalized(m_tube.tangent(t)); }

    const Tube& m_tube;
    std::vector<Vec3d> m_first; ///< first normal of the frame at each step
    double m_twist = 0;
};

/// The row at one angle around the tube, measured by its polygon.
Row tubeRow(std::shared_ptr<const TubeFrame> frame, double angle) {
    std::vector<double> length(steps + 1);
    Vec3d before = frame->at(0, angle).position;
    for (std::size_t k = 1; k <= steps; ++k) {
        const Vec3d p = frame->at(TubeFrame::parameter(k), angle).position;
        length[k] = length[k - 1] + base::distance(before, p);
        before = p;
    }
    const double total = length.back();
    return {total, [frame = std::move(frame), angle, length = std::move(length)](double distance) {
                const auto after = std::upper_bound(length.begin() + 1, length.end() - 1, distance);
                const double part = (distance - after[-1]) / (after[0] - after[-1]);
                const double k = static_cast<double>(after - length.begin()) - 1 + part;
                return frame->at(std::clamp(turn * k / steps, 0.0, turn), angle);
            }};
}

double curveLength(const Tube& tube) {
    double sum = 0;
    for (std::size_t k = 0; k < steps; ++k)
        sum += base::distance(tube.centre(TubeFrame::parameter(k)), tube.centre(TubeFrame::parameter(k + 1)));
    return sum;
}

} // namespace

surfel::SurfelList sampleTube(const Tube& tube, std::size_t count) {
    const auto frame = std::make_shared<const TubeFrame>(tube);
    const auto make = [&](double apart) {
        std::vector<Row> rows(std::max<std::size_t>(3, std::llround(turn * tube.radius / apart)));
        base::parallelFor(rows.size(), 4, [&](std::size_t r) {
            rows[r] = tubeRow(frame, turn * static_cast<double>(r) / static_cast<double>(rows.size()));
        });
        return rows;
    };
    return sampleRows(make, curveLength(tube) * turn * tube.radius, count);
}

} // namespace process
