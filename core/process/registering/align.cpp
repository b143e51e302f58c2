#include "core/process/registering/align.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/surface/projection/project.h"

#include <Eigen/Dense>

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

constexpr double sameSide = 0.5; ///< cosine between a point's normal and its foot's
constexpr double narrowing = 4;  ///< reach of the next round, in robust deviations of this one
constexpr double leastReach = 3; ///< in spacings
/// Motion that counts as none, in spacings at the model's farthest point.
constexpr double stillness = 1e-4;
constexpr double fewestFeet = 20;

/// Some surfels of a model, evenly chosen, in its own coordinates.
struct Sample {
    std::vector<Vec3d> position, normal;
    bool oriented = false;
};

Sample sampleOf(const surface::Surface& surface, std::size_t count) {
    const surfel::SurfelList list = surface.tree().surfels();
    Sample out;
    out.oriented = list.layout->normals && list.layout->oriented;
    count = std::min(count, list.size());
    for (std::size_t k = 0; k < count; ++k) {
        const surfel::Surfel& s = list.items[k * list.size() / count];
        out.position.push_back(base::cast<double>(s.position));
        out.normal.push_back(base::cast<double>(s.normal));
    }
    return out;
}

/// A point of one model with its foot on another one, both in the coordinates of all.
struct Pair {
    std::uint32_t from, to, point;
    Vec3d x, n;      ///< the point, and the foot's unit normal
    double off;      ///< along n
    double distance; ///< to the foot
};

/// Feet as exact as weights and normals need them; what does not get there soon lies beyond or between.
surface::ProjectOptions footing() {
    surface::ProjectOptions out;
    out.tolerance = 1e-5;
    out.maxIterations = 10;
    return out;
}

class Round {
  public:
    Round(const std::vector<Placed>& models, const std::vector<Sample>& samples, double reach)
        : m_models(models), m_samples(samples), m_reach(reach) {}

    /// Feet of all points on all other models.
    std::vector<Pair> pairs() const {
        std::vector<Pair> out;
        for (std::uint32_t from = 0; from < m_models.size(); ++from)
            for (std::uint32_t to = 0; to < m_models.size(); ++to)
                if (from != to)
                    add(from, to, out);
        return out;
    }

  private:
    void add(std::uint32_t from, std::uint32_t to, std::vector<Pair>& out) const {
        const surface::Surface& on = m_models[to].surface;
        const Rigid there = m_models[to].pose.inverse() * m_models[from].pose;
        const base::Box3f box = on.tree().bounds().inflated(static_cast<float>(m_reach));
        const Sample& sample = m_samples[from];
        // where no surfel is near there is no foot to look for
        std::vector<std::uint8_t> near(sample.position.size());
        base::parallelFor(near.size(), 64, [&](std::size_t i) {
            std::vector<tree::Neighbour> found;
            if (const Vec3f p = base::cast<float>(there(sample.position[i])); box.contains(p))
                on.tree().nearest(p, 1, found, static_cast<float>(m_reach));
            near[i] = !found.empty();
        });
        std::vector<Vec3f> asked;
        std::vector<std::uint32_t> which;
        for (std::uint32_t i = 0; i < near.size(); ++i)
            if (near[i]) {
                asked.push_back(base::cast<float>(there(sample.position[i])));
                which.push_back(i);
            }
        std::vector<surface::Projection<float>> feet(asked.size());
        surface::project(on, asked, footing(), feet);
        const bool sided = sample.oriented && m_samples[to].oriented;
        for (std::size_t k = 0; k < feet.size(); ++k) {
            if (!feet[k].ok())
                continue;
            const Vec3d foot = base::cast<double>(feet[k].foot), p = base::cast<double>(asked[k]);
            const Vec3d n = base::normalized(base::cast<double>(feet[k].at.gradient));
            const double along = dot(n, there.turn(sample.normal[which[k]])), far = base::distance(foot, p);
            if (!(far <= m_reach) || (sided ? along : std::abs(along)) < sameSide)
                continue;
            const Rigid& pose = m_models[to].pose;
            out.push_back({from, to, which[k], pose(p), pose.turn(n), dot(n, p - foot), far});
        }
    }

    const std::vector<Placed>& m_models;
    const std::vector<Sample>& m_samples;
    double m_reach;
};

/// How much the models' pairs want each to turn (about `centre`) and to shift; nothing for the first.
std::vector<Rigid> motions(const std::vector<Pair>& pairs, std::size_t models, const Vec3d& centre, double scale,
                           double reach) {
    const auto size = static_cast<Eigen::Index>(6 * (models - 1));
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    for (const Pair& p : pairs) {
        const double weight = biweight(p.off, reach);
        if (!(weight > 0))
            continue;
        const Vec3d arm = cross((p.x - centre) / scale, p.n);
        Eigen::Matrix<double, 6, 1> d;
        d << arm.x, arm.y, arm.z, p.n.x, p.n.y, p.n.z;
        const auto add = [&](std::uint32_t row, double sign) {
            if (row == 0)
                return;
            const Eigen::Index r = 6 * (static_cast<Eigen::Index>(row) - 1);
            right.segment<6>(r) -= weight * sign * p.off * d;
            const auto beside = [&](std::uint32_t column, double other) {
                if (column > 0)
                    normal.block<6, 6>(r, 6 * (static_cast<Eigen::Index>(column) - 1)) +=
                        weight * sign * other * d * d.transpose();
            };
            beside(p.from, 1), beside(p.to, -1);
        };
        add(p.from, 1), add(p.to, -1);
    }
    // what slides freely, as a plane on a plane, stays
    const double ridge = 1e-9 * std::max(normal.diagonal().maxCoeff(), 1e-300);
    normal.diagonal().array() += ridge;
    const Eigen::VectorXd step = normal.ldlt().solve(right);
    std::vector<Rigid> out(models);
    for (std::size_t m = 1; m < models; ++m) {
        const auto at = [&](int k) { return step(6 * (static_cast<Eigen::Index>(m) - 1) + k); };
        const Rigid turn = motionOf(Vec3d{at(0), at(1), at(2)} / scale, {});
        out[m] = {turn.rotation, centre - turn.rotation * centre + Vec3d{at(3), at(4), at(5)}};
    }
    return out;
}

/// What is told of each model at the end.
void judge(std::vector<Placed>& models, const std::vector<Sample>& samples, const std::vector<Pair>& pairs,
           double reach) {
    for (std::uint32_t m = 0; m < models.size(); ++m) {
        std::vector<double> nearest(samples[m].position.size(), std::numeric_limits<double>::infinity());
        for (const Pair& p : pairs)
            if (p.from == m && std::abs(p.off) < std::abs(nearest[p.point]) && p.distance <= reach)
                nearest[p.point] = p.off;
        double squares = 0;
        std::size_t count = 0;
        for (const double off : nearest)
            if (std::isfinite(off))
                squares += off * off, ++count;
        models[m].overlap = static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(nearest.size(), 1));
        models[m].rms = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0;
    }
}

void requireFeet(const std::vector<Pair>& pairs, std::size_t models) {
    std::vector<double> feet(models);
    for (const Pair& p : pairs)
        ++feet[p.from], ++feet[p.to];
    for (std::size_t m = 1; m < models; ++m)
        if (feet[m] < fewestFeet)
            throw base::Error("moving model " + std::to_string(m) + " has nothing in common with the others",
                              "register", "bring it closer, or look for its place everywhere");
}

} // namespace

Alignment align(std::vector<Placed>& models, const AlignOptions& options, const base::Progress& progress) {
    Alignment out;
    if (models.size() < 2)
        return out;
    std::vector<Sample> samples;
    double spacing = 0;
    for (const Placed& m : models) {
        samples.push_back(sampleOf(m.surface, options.points));
        spacing = std::max(spacing, static_cast<double>(typicalSpacing(m.surface.tree())));
    }
    const base::Box3f box = models[0].surface.tree().bounds();
    const Vec3d centre = models[0].pose(base::cast<double>(box.centre()));
    const double scale = std::max(0.5 * static_cast<double>(box.diagonal()), 1e-30);
    double reach = options.reach > 0 ? options.reach : 0.4 * scale;
    std::vector<Pair> pairs;
    for (; out.rounds < options.mostRounds && !out.settled; ++out.rounds) {
        progress.step(static_cast<double>(out.rounds) / options.mostRounds, "Aligning");
        pairs = Round(models, samples, reach).pairs();
        requireFeet(pairs, models.size());
        std::vector<double> sizes;
        for (const Pair& p : pairs)
            sizes.push_back(std::abs(p.off));
        const double deviation = std::max(deviationOverMad * middleOf(sizes), 1e-3 * spacing);
        const std::vector<Rigid> steps = motions(pairs, models.size(), centre, scale, robustReach * deviation);
        double moved = 0;
        for (std::size_t m = 1; m < models.size(); ++m) {
            for (const Vec3d& x :
                 {centre + Vec3d{scale, 0, 0}, centre + Vec3d{0, scale, 0}, centre + Vec3d{0, 0, scale}})
                moved = std::max(moved, distance(steps[m](x), x));
            models[m].pose = steps[m] * models[m].pose;
        }
        const double narrower = std::max(narrowing * deviation, leastReach * spacing);
        out.settled = moved < stillness * spacing && !(narrower < 0.9 * reach);
        reach = std::min(reach, std::max(narrower, 0.7 * reach));
    }
    judge(models, samples, pairs, std::max(reach, leastReach * spacing));
    return out;
}

} // namespace process
