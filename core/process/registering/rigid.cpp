#include "core/process/registering/rigid.h"

#include <Eigen/Dense>

namespace process {

using base::Vec3d;

static base::Mat3d matrixOf(const Eigen::Matrix3d& m) {
    base::Mat3d out;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out[r][c] = m(r, c);
    return out;
}

Rigid motionOf(const Vec3d& w, const Vec3d& shift) {
    const double angle = length(w);
    const Vec3d axis = base::normalized(w, {0, 0, 1});
    return {matrixOf(Eigen::AngleAxisd(angle, Eigen::Vector3d(axis.x, axis.y, axis.z)).toRotationMatrix()), shift};
}

bool bestMotion(const Vec3d* from, const Vec3d* to, std::size_t count, Rigid& out) {
    constexpr double line = 1e-6;
    if (count < 3)
        return false;
    Vec3d a, b;
    for (std::size_t i = 0; i < count; ++i)
        a += from[i] / static_cast<double>(count), b += to[i] / static_cast<double>(count);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d p = from[i] - a, q = to[i] - b;
        sum += Eigen::Vector3d(q.x, q.y, q.z) * Eigen::Vector3d(p.x, p.y, p.z).transpose();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    if (!(svd.singularValues()(1) > line * svd.singularValues()(0)))
        return false;
    Eigen::Matrix3d flip = Eigen::Matrix3d::Identity();
    flip(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    out.rotation = matrixOf(svd.matrixU() * flip * svd.matrixV().transpose());
    out.translation = b - out.rotation * a;
    return true;
}

} // namespace process
