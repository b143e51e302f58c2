#include "core/process/estimation/orientation/nearest_signs.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <utility>
#include <vector>

namespace process {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double ridge = 0.01; ///< of the mean diagonal: pieces that say next to nothing stay small
constexpr Index tile = 96;     ///< columns: some hundredths of a second for all their rows

Index widthAt(Index first, Index count) {
    return std::min(tile, count - first);
}

/// fn(row, column) for the first of every tile on and below the diagonal, from `from` on, in parallel.
template <class Fn>
void forTiles(Index from, Index count, const Fn& fn) {
    std::vector<std::pair<Index, Index>> tiles;
    for (Index column = from; column < count; column += tile)
        for (Index row = column; row < count; row += tile)
            tiles.emplace_back(row, column);
    base::parallelFor(tiles.size(), 1, [&](std::size_t k) { fn(tiles[k].first, tiles[k].second); });
}

using Columns = Eigen::Map<const MatrixXd>;

MatrixXd gramOf(const Columns& a) {
    const Index count = a.cols();
    MatrixXd out(count, count);
    forTiles(0, count, [&](Index i, Index j) {
        const Index rows = widthAt(i, count), columns = widthAt(j, count);
        const MatrixXd product = a.middleCols(i, rows).transpose() * a.middleCols(j, columns);
        out.block(i, j, rows, columns) = product;
        out.block(j, i, columns, rows) = product.transpose();
    });
    return out;
}

/// Cholesky's factor in place, in the lower half: tile by tile from the left. REQUIRES: positive definite.
void factorise(MatrixXd& m) {
    const Index count = m.rows();
    for (Index k = 0; k < count; k += tile) {
        base::CancelScope::check();
        const Index width = widthAt(k, count), next = k + width;
        m.block(k, k, width, width) = m.block(k, k, width, width).llt().matrixL();
        if (next == count)
            break;
        const MatrixXd corner = m.block(k, k, width, width);
        auto below = m.block(next, k, count - next, width);
        corner.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
        const MatrixXd panel = below;
        forTiles(next, count, [&](Index i, Index j) {
            const Index rows = widthAt(i, count), columns = widthAt(j, count);
            m.block(i, j, rows, columns).noalias() -=
                panel.middleRows(i - next, rows) * panel.middleRows(j - next, columns).transpose();
        });
    }
}

} // namespace

std::vector<double> nearestSigns(std::span<const double> a, std::span<const double> b) {
    const auto rows = static_cast<Index>(b.size());
    const Columns columns(a.data(), rows, static_cast<Index>(a.size() / b.size()));
    const MatrixXd gram = gramOf(columns);
    const VectorXd right = columns.transpose() * Eigen::Map<const VectorXd>(b.data(), rows);
    MatrixXd regular = gram;
    regular.diagonal().array() += ridge * gram.diagonal().mean();
    factorise(regular);
    VectorXd signs = regular.triangularView<Eigen::Lower>().solve(right);
    regular.triangularView<Eigen::Lower>().transpose().solveInPlace(signs);
    signs = signs.unaryExpr([](double soft) { return soft < 0 ? -1.0 : 1.0; }).eval();
    VectorXd slope = gram * signs - right;
    for (Index turns = 0; turns < 4 * signs.size(); ++turns) { // each makes it smaller
        base::CancelScope::check();
        Index best = 0;
        const double change = (gram.diagonal() - signs.cwiseProduct(slope)).minCoeff(&best);
        if (change >= 0)
            break;
        slope -= 2 * signs[best] * gram.col(best);
        signs[best] = -signs[best];
    }
    return {signs.begin(), signs.end()};
}

} // namespace process
