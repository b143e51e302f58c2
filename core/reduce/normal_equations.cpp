#include "core/reduce/normal_equations.h"

#include "core/base/parallel.h"
#include "core/reduce/row_products.h"

#include <algorithm>
#include <cmath>
#include <Eigen/IterativeLinearSolvers>
#include <numeric>

namespace reduce {

/// What Eigen's solvers take for a matrix.
template <int unknowns>
class ScaledMatrix;

} // namespace reduce

namespace Eigen::internal {
template <int unknowns>
struct traits<reduce::ScaledMatrix<unknowns>> : traits<SparseMatrix<double>> {};
} // namespace Eigen::internal

namespace reduce {

template <int unknowns>
class ScaledMatrix : public Eigen::EigenBase<ScaledMatrix<unknowns>> {
  public:
    using Scalar = double;
    using RealScalar = double;
    using StorageIndex = int;
    enum { ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic, IsRowMajor = false };

    explicit ScaledMatrix(const NormalEquations<unknowns>& equations) : m_equations(equations) {}
    Eigen::Index rows() const { return m_equations.size(); }
    Eigen::Index cols() const { return m_equations.size(); }
    const NormalEquations<unknowns>& equations() const { return m_equations; }

    template <class Right>
    Eigen::Product<ScaledMatrix, Right, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<Right>& x) const {
        return {*this, x.derived()};
    }

  private:
    const NormalEquations<unknowns>& m_equations;
};

} // namespace reduce

namespace Eigen::internal {
template <int unknowns, class Right>
struct generic_product_impl<reduce::ScaledMatrix<unknowns>, Right, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<reduce::ScaledMatrix<unknowns>, Right,
                                generic_product_impl<reduce::ScaledMatrix<unknowns>, Right>> {
    template <class Out>
    static void scaleAndAddTo(Out& out, const reduce::ScaledMatrix<unknowns>& left, const Right& x,
                              const double& factor) {
        out.noalias() += factor * left.equations().scaledProduct(x);
    }
};
} // namespace Eigen::internal

namespace reduce {

template <int unknowns>
void FitPiece<unknowns>::setRow(std::size_t row, std::span<const std::array<float, mostUnknowns>> d) {
    float most = 0;
    for (const auto& each : d)
        for (std::size_t u = 0; u < unknowns; ++u)
            most = std::max(most, std::abs(each[u]));
    unit[row] = most / fullPart;
    const float scale = most > 0 ? fullPart / most : 0;
    for (std::size_t k = 0; k < d.size(); ++k)
        for (std::size_t u = 0; u < unknowns; ++u)
            entries[firstOf(row) + k].part[u] =
                static_cast<std::int16_t>(d[k][u] * scale + std::copysign(0.5F, d[k][u]));
}

template <int unknowns>
NormalEquations<unknowns>::NormalEquations(const std::vector<FitPiece<unknowns>>& pieces, std::size_t sites)
    : m_pieces(pieces), m_first(sites + 1, 0) {
    for (const FitPiece<unknowns>& piece : pieces)
        for (const std::uint32_t site : piece.sites)
            ++m_first[site + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_parts.resize(m_first.back());
    std::vector<std::uint32_t> at(m_first.begin(), m_first.end() - 1);
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
        for (std::uint32_t k = 0; k < pieces[p].sites.size(); ++k)
            m_parts[at[pieces[p].sites[k]]++] = {p, k};
}

template <int unknowns>
template <class Of>
typename NormalEquations<unknowns>::Vector NormalEquations<unknowns>::gathered(const Of& of) const {
    Vector out = Vector::Zero(size());
    base::parallelFor(m_first.size() - 1, 4096, [&](std::size_t site) {
        for (std::uint32_t k = m_first[site]; k < m_first[site + 1]; ++k) {
            const auto* part = of(m_parts[k].piece, m_parts[k].at);
            for (std::size_t u = 0; u < unknowns; ++u)
                out[static_cast<Eigen::Index>(site * unknowns + u)] += double(part[u]);
        }
    });
    return out;
}

/// Sums of what the rows add to their sites: add(piece, sums of the piece's sites).
template <int unknowns>
template <class AddRow>
typename NormalEquations<unknowns>::Vector NormalEquations<unknowns>::summed(const AddRow& add) const {
    std::vector<std::vector<double>> sums(m_pieces.size());
    base::parallelFor(m_pieces.size(), 1, [&](std::size_t p) {
        sums[p].assign(m_pieces[p].sites.size() * unknowns, 0);
        add(m_pieces[p], sums[p]);
    });
    return gathered([&](std::uint32_t p, std::uint32_t at) { return &sums[p][std::size_t(at) * unknowns]; });
}

template <int unknowns>
typename NormalEquations<unknowns>::Vector NormalEquations<unknowns>::scaledProduct(const Vector& x) const {
    const Vector scaled = m_scale.cwiseProduct(x);
    std::vector<std::vector<float>> sums(m_pieces.size());
    base::parallelFor(m_pieces.size(), 1, [&](std::size_t p) {
        const FitPiece<unknowns>& piece = m_pieces[p];
        std::vector<float> local(piece.sites.size() * siteLanes);
        for (std::size_t k = 0; k < piece.sites.size(); ++k)
            for (std::size_t u = 0; u < unknowns; ++u)
                local[k * siteLanes + u] =
                    static_cast<float>(scaled[static_cast<Eigen::Index>(std::size_t(piece.sites[k]) * unknowns + u)]);
        sums[p].assign(local.size(), 0);
        addRowProducts(piece, local, sums[p]);
    });
    const Vector sum =
        gathered([&](std::uint32_t p, std::uint32_t at) { return &sums[p][std::size_t(at) * siteLanes]; });
    return m_scale.cwiseProduct(sum + m_ridge.cwiseProduct(scaled));
}

template <int unknowns>
typename NormalEquations<unknowns>::Vector NormalEquations<unknowns>::solve(const Vector& from, double ridge,
                                                                            double meanShare, int steps) {
    const Vector diagonal = summed([](const FitPiece<unknowns>& piece, std::vector<double>& sum) {
        piece.forRows([&](std::size_t row, std::span<const FitEntry<unknowns>> entries) {
            const double unit = double(piece.unit[row]) * double(piece.unit[row]);
            for (const FitEntry<unknowns>& e : entries)
                for (std::size_t u = 0; u < unknowns; ++u)
                    sum[e.site * unknowns + u] += unit * double(e.part[u]) * double(e.part[u]);
        });
    });
    const Vector slope = summed([](const FitPiece<unknowns>& piece, std::vector<double>& sum) {
        piece.forRows([&](std::size_t row, std::span<const FitEntry<unknowns>> entries) {
            const double residual = double(piece.residual[row]) * double(piece.unit[row]);
            for (const FitEntry<unknowns>& e : entries)
                for (std::size_t u = 0; u < unknowns; ++u)
                    sum[e.site * unknowns + u] += residual * double(e.part[u]);
        });
    });
    m_ridge.resize(size());
    for (int u = 0; u < unknowns; ++u) {
        const auto kind = Eigen::seqN(u, size() / unknowns, Eigen::fix<unknowns>);
        const double mean = std::max(diagonal(kind).mean(), 1e-30);
        m_ridge(kind) = ridge * (diagonal(kind).array() + meanShare * mean);
    }
    m_scale = (diagonal + m_ridge).cwiseSqrt().cwiseInverse();
    const ScaledMatrix<unknowns> matrix(*this);
    Eigen::ConjugateGradient<ScaledMatrix<unknowns>, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> solver;
    solver.setMaxIterations(steps);
    solver.setTolerance(1e-4);
    solver.compute(matrix);
    const Vector right = -m_scale.cwiseProduct(slope + m_ridge.cwiseProduct(from));
    return m_scale.cwiseProduct(solver.solve(right).eval());
}

template struct FitPiece<unknownsOfBalls>;
template struct FitPiece<unknownsOfEllipsoids>;
template class NormalEquations<unknownsOfBalls>;
template class NormalEquations<unknownsOfEllipsoids>;

} // namespace reduce
