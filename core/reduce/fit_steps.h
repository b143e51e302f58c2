// What the fits of surfaces and of rims have in common: sites as they move, and rows in pieces. Internal to the fit.
#pragma once

#include "core/reduce/fit_row.h"
#include "core/reduce/sites.h"

namespace reduce {

std::vector<FitSite> fitSites(const Sites& sites);

/// Where they moved to, into the sites that they were made of.
void store(const std::vector<FitSite>& moving, Sites& sites);

/// Rows, without derivatives yet, of the positions from `begin` to `end`: which sites each has weight from.
template <int unknowns>
FitPiece<unknowns> pieceOf(std::span<const base::Vec3f> positions, const NumberedTree& tree, std::size_t begin,
                           std::size_t end);

/// fn(number of the place, terms) -> FitRow for the rows of a piece, whose derivatives and residuals are kept.
template <int unknowns, class Fn>
void linearise(const std::vector<FitSite>& sites, FitPiece<unknowns>& piece, const Fn& fn) {
    std::vector<FitTerm> terms;
    std::vector<std::array<float, mostUnknowns>> derivatives;
    for (std::size_t row = 0; row < piece.ends.size(); ++row) {
        const std::size_t first = piece.firstOf(row), n = piece.ends[row] - first;
        terms.clear();
        derivatives.resize(n);
        for (std::size_t k = 0; k < n; ++k)
            terms.push_back({&sites[piece.sites[piece.entries[first + k].site]], &derivatives[k], {}, {}});
        const FitRow done = fn(piece.begin + row, std::span<FitTerm>(terms));
        piece.residual[row] = static_cast<float>(done.residual);
        piece.setRow(row, derivatives);
    }
}

/// The unknowns of all sites so far.
template <int unknowns>
Eigen::VectorXd movedSoFar(const std::vector<FitSite>& sites);

/// Adds a step, of each unknown as far as a round may go.
template <int unknowns>
void move(std::vector<FitSite>& sites, const Eigen::VectorXd& by);

} // namespace reduce
