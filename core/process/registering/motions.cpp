#include "core/process/registering/motions.h"

#include "core/process/cleaning/spread.h"

namespace process {

using base::Vec3d;

MotionEquations::MotionEquations(const std::vector<FootPair>& pairs, std::size_t models, const MotionFrame& frame,
                                 double reach)
    : m_frame(frame) {
    const auto size = static_cast<Eigen::Index>(6 * (models - 1));
    m_normal = Eigen::MatrixXd::Zero(size, size);
    m_right = Eigen::VectorXd::Zero(size);
    for (const FootPair& p : pairs) {
        const double weight = biweight(p.off, reach);
        if (!(weight > 0))
            continue;
        const Vec3d arm = cross((p.x - frame.centre) / frame.scale, p.n);
        Eigen::Matrix<double, 6, 1> d;
        d << arm.x, arm.y, arm.z, p.n.x, p.n.y, p.n.z;
        const auto add = [&](std::uint32_t row, double sign) {
            if (row == 0)
                return;
            const Eigen::Index r = 6 * (static_cast<Eigen::Index>(row) - 1);
            m_right.segment<6>(r) -= weight * sign * p.off * d;
            const auto beside = [&](std::uint32_t column, double other) {
                if (column > 0)
                    m_normal.block<6, 6>(r, 6 * (static_cast<Eigen::Index>(column) - 1)) +=
                        weight * sign * other * d * d.transpose();
            };
            beside(p.from, 1), beside(p.to, -1);
        };
        add(p.from, 1), add(p.to, -1);
    }
}

std::vector<Rigid> MotionEquations::motions(const Eigen::VectorXd& step) const {
    const Vec3d& centre = m_frame.centre;
    std::vector<Rigid> out{{}};
    for (Eigen::Index at = 0; at < step.size(); at += 6) {
        const Rigid turn = motionOf(Vec3d{step(at), step(at + 1), step(at + 2)} / m_frame.scale, {});
        out.push_back(
            {turn.rotation, centre - turn.rotation * centre + Vec3d{step(at + 3), step(at + 4), step(at + 5)}});
    }
    return out;
}

std::vector<Rigid> MotionEquations::best() const {
    // what slides freely, as a plane on a plane, stays
    const double ridge = 1e-9 * std::max(m_normal.diagonal().maxCoeff(), 1e-300);
    Eigen::MatrixXd held = m_normal;
    held.diagonal().array() += ridge;
    return motions(held.ldlt().solve(m_right));
}

std::vector<Rigid> MotionEquations::loosest(double size) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(m_normal); // ascending
    const Eigen::VectorXd way = eigen.eigenvectors().col(0);
    double most = 0;
    for (Eigen::Index at = 0; at < way.size(); at += 6)
        most = std::max(most, way.segment<3>(at).norm() + way.segment<3>(at + 3).norm());
    return motions(way * (size / most));
}

} // namespace process
