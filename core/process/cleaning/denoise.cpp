#include "core/process/cleaning/denoise.h"

#include "core/base/ranked.h"
#include "core/process/cleaning/crease_sides.h"
#include "core/process/cleaning/local_quadric.h"
#include "core/process/cleaning/spread.h"
#include "core/process/estimation/part_progress.h"

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t fitted = 30, pooled = 100, framed = 40;
/// Neighbours that fits are made of, one after the other.
constexpr std::size_t scales[] = {12, 18, 27, 40, 60, 90, 135, 200};
/// Half width of a confidence interval, in standard deviations of the fit.
constexpr double confidence = 1.6;
/// No point moves by more noise than this.
constexpr double farthest = 4;

/// What is left of a position over a fit to itself and its neighbours, as one that was not asked would have left.
double residualOf(const Cloud& cloud, std::size_t i, const Neighbours& near) {
    const LocalFrame frame = planeFrame(cloud.positions(), i, near.index, {});
    QuadricSums sums(std::sqrt(static_cast<double>(near.distanceSq.back())));
    sums.add(0, 0, 0);
    for (const std::uint32_t j : near.index)
        sums.add(frame, cloud.positions()[j]);
    const QuadricFit fit = sums.fit();
    return std::abs(fit.distance()) / std::sqrt(std::max(1 - fit.variance, 1e-3));
}

/// Numbers that all confidence intervals of one thing share.
class Agreement {
  public:
    /// False where the interval has nothing in common with those before.
    bool narrow(double value, double halfWidth) {
        m_low = std::max(m_low, value - halfWidth), m_high = std::min(m_high, value + halfWidth);
        return m_low <= m_high;
    }

  private:
    double m_low = -std::numeric_limits<double>::infinity(), m_high = std::numeric_limits<double>::infinity();
};

struct Landing {
    Vec3d position, normal;
};

Landing landingOf(const Cloud& cloud, std::size_t i, const Neighbours& near, const CreaseSides& sides, bool oriented,
                  double noise) {
    const std::span<const Vec3f> positions = cloud.positions(), normals = sides.normals;
    const auto beside = [&](std::uint32_t j) {
        return (!oriented || dot(normals[i], normals[j]) > 0) && sides.together(i, j, oriented);
    };
    std::vector<std::uint32_t> ofFrame;
    for (std::size_t k = 0; k < near.size() && ofFrame.size() < framed; ++k)
        if (beside(near.index[k]))
            ofFrame.push_back(near.index[k]);
    const LocalFrame frame = planeFrame(positions, i, ofFrame, normals[i]);
    QuadricSums sums(std::sqrt(static_cast<double>(near.distanceSq.back())));
    sums.add(0, 0, 0);
    Agreement agreement;
    agreement.narrow(0, confidence * noise); // what was measured here
    QuadricFit best;
    std::size_t scale = 0, count = 0;
    for (std::size_t k = 0; k < near.size() && scale < std::size(scales); ++k) {
        if (!beside(near.index[k]))
            continue;
        sums.add(frame, positions[near.index[k]]);
        if (++count < scales[scale])
            continue;
        ++scale;
        const QuadricFit fit = sums.fit();
        if (fit.terms < 6 || !agreement.narrow(fit.c[0], confidence * noise * std::sqrt(fit.variance)))
            break;
        best = fit;
    }
    const double far = farthest * noise, height = std::clamp(best.c[0], -far, far);
    return {frame.origin + frame.n * height, best.terms > 0 ? best.normal(frame) : base::cast<double>(normals[i])};
}

} // namespace

NoiseLevel estimateNoise(const Cloud& cloud, const base::Progress& progress) {
    NoiseLevel out;
    out.at.resize(cloud.size());
    if (cloud.size() <= fitted)
        return out;
    std::vector<double> residual(cloud.size());
    cloud.forEach(fitted, part(progress, 0, 0.4), "Measuring noise",
                  [&](std::size_t i, const Neighbours& near) { residual[i] = residualOf(cloud, i, near); });
    cloud.forEach(pooled, part(progress, 0.4, 1), "Measuring noise", [&](std::size_t i, const Neighbours& near) {
        std::vector<double> sizes{residual[i]};
        for (const std::uint32_t j : near.index)
            sizes.push_back(residual[j]);
        out.at[i] = static_cast<float>(deviationOverMad * base::median(sizes));
    });
    out.middle = deviationOverMad * base::median(residual);
    return out;
}

Denoised denoised(const Cloud& cloud, std::span<const Vec3f> normals, bool oriented, std::span<const float> noise,
                  const base::Progress& progress) {
    Denoised out;
    out.positions.assign(cloud.positions().begin(), cloud.positions().end());
    out.normals.assign(normals.begin(), normals.end());
    const CreaseSides sides = creaseSides(cloud, normals, oriented, noise, part(progress, 0, 0.3));
    cloud.forEach(scales[std::size(scales) - 1], part(progress, 0.3, 1), "Taking noise out",
                  [&](std::size_t i, const Neighbours& near) {
                      if (!(noise[i] > 0))
                          return;
                      const Landing landing = landingOf(cloud, i, near, sides, oriented, static_cast<double>(noise[i]));
                      out.positions[i] = base::cast<float>(landing.position);
                      out.normals[i] = base::normalized(base::cast<float>(landing.normal), normals[i]);
                  });
    return out;
}

} // namespace process
