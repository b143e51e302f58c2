#include "core/reduce/fit.h"

#include "core/base/parallel.h"
#include "core/reduce/fit_row.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace reduce {

namespace {

constexpr int rounds = 3, steps = 40;
constexpr std::size_t rowsOfPiece = 2048;
/// Towards where the sites began, in parts of the diagonal and of its mean (reduce/README 4.3).
constexpr double ridge = 0.1, meanShare = 0.05;
/// Most of a round, in supports.
constexpr std::array<double, mostUnknowns> farthest{0.2, 0.25, 0.25, 0.12, 0.12, 0.12, 0.12, 0.12};

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

/// Which sites each place of the piece has weight from.
template <int unknowns>
FitPiece<unknowns> pieceOf(const Places& places, const NumberedTree& tree, std::size_t begin, std::size_t end) {
    FitPiece<unknowns> out;
    out.begin = begin;
    out.ends.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
        tree.forSupporting(places.position[i], [&](std::uint32_t k, float) { out.entries.push_back({k, {}}); });
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
void linearise(const Places& places, const std::vector<FitSite>& sites, FitPiece<unknowns>& piece) {
    std::vector<FitTerm> terms;
    std::vector<std::array<float, mostUnknowns>> derivatives;
    for (std::size_t row = 0; row < piece.ends.size(); ++row) {
        const std::size_t first = piece.firstOf(row), n = piece.ends[row] - first;
        terms.clear();
        derivatives.resize(n);
        for (std::size_t k = 0; k < n; ++k)
            terms.push_back({&sites[piece.sites[piece.entries[first + k].site]], &derivatives[k], {}, {}});
        const std::size_t place = piece.begin + row;
        const FitRow done = fitRow(base::cast<double>(places.position[place]), base::cast<double>(places.normal[place]),
                                   places.oriented, terms);
        piece.residual[row] = static_cast<float>(done.residual);
        piece.setRow(row, derivatives);
    }
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

template <int unknowns>
void fitAll(const Places& places, Sites& sites, const base::Progress& progress) {
    std::vector<FitSite> moving = fitSites(sites);
    std::vector<FitPiece<unknowns>> pieces(base::chunkCount(places.size(), rowsOfPiece));
    for (int round = 0; round < rounds; ++round) {
        progress.step(double(round) / rounds, "Fitting");
        const NumberedTree tree(sites.position, sites.normal, sites.support, sites.shape);
        base::parallelChunks(places.size(), rowsOfPiece, [&](std::size_t begin, std::size_t end, std::size_t k) {
            pieces[k] = pieceOf<unknowns>(places, tree, begin, end);
            linearise(places, moving, pieces[k]);
        });
        NormalEquations<unknowns> equations(pieces, sites.size());
        move<unknowns>(moving, equations.solve(movedSoFar<unknowns>(moving), ridge, meanShare, steps));
        for (std::size_t i = 0; i < sites.size(); ++i) {
            sites.position[i] = base::cast<float>(moving[i].position());
            sites.support[i] = static_cast<float>(moving[i].reach());
            sites.normal[i] = base::cast<float>(normalized(moving[i].tilted()));
            if (!sites.shape.empty())
                sites.shape[i] = surfel::soundShape(base::cast<float>(moving[i].shape()), sites.normal[i]);
        }
    }
}

} // namespace

void fit(const Places& places, Sites& sites, const base::Progress& progress) {
    if (sites.shape.empty())
        fitAll<unknownsOfBalls>(places, sites, progress);
    else
        fitAll<unknownsOfEllipsoids>(places, sites, progress);
}

} // namespace reduce
