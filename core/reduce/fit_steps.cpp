#include "core/reduce/fit_steps.h"

#include "core/base/parallel.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace reduce {

/// Most of a round, in supports.
static constexpr std::array<double, mostUnknowns> farthest{0.2, 0.25, 0.25, 0.12, 0.12, 0.12, 0.12, 0.12};

std::vector<FitSite> fitSites(const Sites& sites) {
    std::vector<FitSite> out(sites.size());
    base::parallelFor(out.size(), 4096, [&](std::size_t i) {
        FitSite& s = out[i];
        s.start = base::cast<double>(sites.position[i]);
        s.normal0 = normalized(base::cast<double>(sites.normal[i]));
        s.along[0] = perpendicular(s.normal0);
        s.along[1] = cross(s.normal0, s.along[0]);
        s.support = double(sites.support[i]);
        if (!sites.shape.empty())
            s.setShape(base::cast<double>(sites.shape[i]), s.support);
    });
    return out;
}

void store(const std::vector<FitSite>& moving, Sites& sites) {
    for (std::size_t i = 0; i < sites.size(); ++i) {
        sites.position[i] = base::cast<float>(moving[i].position());
        sites.support[i] = static_cast<float>(moving[i].reach());
        sites.normal[i] = base::cast<float>(normalized(moving[i].tilted()));
        if (!sites.shape.empty())
            sites.shape[i] = surfel::soundShape(base::cast<float>(moving[i].shape()), sites.normal[i]);
    }
}

template <int unknowns>
FitPiece<unknowns> pieceOf(std::span<const base::Vec3f> positions, const NumberedTree& tree, std::size_t begin,
                           std::size_t end) {
    FitPiece<unknowns> out;
    out.begin = begin;
    out.ends.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
        tree.forSupporting(positions[i], [&](std::uint32_t k, float) { out.entries.push_back({{}, k}); });
        out.ends.push_back(static_cast<std::uint32_t>(out.entries.size()));
    }
    out.entries.shrink_to_fit();
    for (const FitEntry<unknowns>& e : out.entries)
        out.sites.push_back(e.site);
    std::sort(out.sites.begin(), out.sites.end());
    out.sites.erase(std::unique(out.sites.begin(), out.sites.end()), out.sites.end());
    out.sites.shrink_to_fit();
    for (FitEntry<unknowns>& e : out.entries)
        e.site = static_cast<std::uint32_t>(std::lower_bound(out.sites.begin(), out.sites.end(), e.site) -
                                            out.sites.begin());
    out.residual.resize(out.ends.size());
    out.unit.resize(out.ends.size());
    return out;
}

template <int unknowns>
void move(std::vector<FitSite>& sites, const Eigen::VectorXd& by) {
    const double most = std::log(double(surfel::mostAspect));
    for (std::size_t i = 0; i < sites.size(); ++i) {
        for (std::size_t u = 0; u < unknowns; ++u) {
            const double step = farthest[u] * sites[i].support;
            sites[i].x[u] += std::clamp(by[static_cast<Eigen::Index>(i * unknowns + u)], -step, step);
        }
        if (const double k = sites[i].stretch(); k > most) {
            FitSite& s = sites[i];
            const double p = s.p() * most / k, q = s.q() * most / k;
            s.x[6] = (p - s.shape0[0]) * s.support, s.x[7] = (q - s.shape0[1]) * s.support;
        }
    }
}

template <int unknowns>
Eigen::VectorXd movedSoFar(const std::vector<FitSite>& sites) {
    Eigen::VectorXd out(static_cast<Eigen::Index>(sites.size() * unknowns));
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (std::size_t u = 0; u < unknowns; ++u)
            out[static_cast<Eigen::Index>(i * unknowns + u)] = sites[i].x[u];
    return out;
}

template FitPiece<unknownsOfBalls> pieceOf(std::span<const base::Vec3f>, const NumberedTree&, std::size_t, std::size_t);
template Eigen::VectorXd movedSoFar<unknownsOfBalls>(const std::vector<FitSite>&);
template void move<unknownsOfBalls>(std::vector<FitSite>&, const Eigen::VectorXd&);
template FitPiece<unknownsOfEllipsoids> pieceOf(std::span<const base::Vec3f>, const NumberedTree&, std::size_t,
                                                std::size_t);
template Eigen::VectorXd movedSoFar<unknownsOfEllipsoids>(const std::vector<FitSite>&);
template void move<unknownsOfEllipsoids>(std::vector<FitSite>&, const Eigen::VectorXd&);

} // namespace reduce
