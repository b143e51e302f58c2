// How pairs of points and feet want their models to move: (13) of process/README 13.1, linearised. Inside this folder.
#pragma once

#include "core/process/registering/feet.h"

#include <Eigen/Dense>

namespace process {

/// Lengths are measured from `centre` in units of `scale`, so that turns and shifts weigh alike.
struct MotionFrame {
    base::Vec3d centre;
    double scale;
};

/// The first of `models` stays. Pairs farther off than `reach` have no weight.
class MotionEquations {
  public:
    MotionEquations(const std::vector<FootPair>& pairs, std::size_t models, const MotionFrame& frame, double reach);

    /// One motion for each model, under which the weighted distances become least.
    std::vector<Rigid> best() const;
    /// The motions that change these distances least, so large that no point within `scale` of the centre moves
    /// farther than about `size`; with a sign of either kind.
    std::vector<Rigid> loosest(double size) const;

  private:
    std::vector<Rigid> motions(const Eigen::VectorXd& step) const;

    MotionFrame m_frame;
    Eigen::MatrixXd m_normal;
    Eigen::VectorXd m_right;
};

} // namespace process
