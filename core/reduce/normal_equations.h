// The sparse least squares of the fit: rows of derivatives, kept in pieces of neighbouring places, and their normal
// equations as Eigen's conjugate gradients want them (reduce/README 4.3). Internal to the fit.
//
// Nothing of the size of A^T A is ever made. Each piece knows its sites by small numbers and sums into a list of its
// own; a site then adds up what its pieces have, in their order: the same bits at any thread count. Products look at
// the caller's CancelScope.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <span>
#include <vector>

namespace reduce {

/// Of each site: offset along its normal, two tilts, two moves along the surface, the logarithm of its support; two of
/// its shape, where supports are ellipsoids.
constexpr int unknownsOfBalls = 6, unknownsOfEllipsoids = 8, mostUnknowns = unknownsOfEllipsoids;

/// Derivatives of a row by the unknowns of one site, in parts of the row's largest. Read eight at a time
/// (row_products.h), so the parts come first.
template <int unknowns>
struct FitEntry {
    std::array<std::int16_t, unknowns> part;
    std::uint32_t site; ///< in the piece's list
};
constexpr float fullPart = 32767;

/// Rows of consecutive places.
template <int unknowns>
struct FitPiece {
    std::size_t begin = 0;            ///< first place
    std::vector<std::uint32_t> sites; ///< ascending
    std::vector<std::uint32_t> ends;  ///< of each row, into `entries`
    std::vector<FitEntry<unknowns>> entries;
    std::vector<float> residual, unit; ///< of each row; a derivative is its part times the unit

    /// Stores the derivatives of a row, one array for each of its entries.
    void setRow(std::size_t row, std::span<const std::array<float, mostUnknowns>> d);
    std::size_t firstOf(std::size_t row) const { return row == 0 ? 0 : ends[row - 1]; }
    /// fn(row, entries)
    template <class Fn>
    void forRows(const Fn& fn) const {
        for (std::size_t row = 0; row < ends.size(); ++row)
            fn(row, std::span(entries).subspan(firstOf(row), ends[row] - firstOf(row)));
    }
};

template <int unknowns>
class NormalEquations {
  public:
    using Vector = Eigen::VectorXd;

    NormalEquations(const std::vector<FitPiece<unknowns>>& pieces, std::size_t sites);

    /// min |A x + r|^2 + |x + from|^2_ridge; `ridge` in parts of the diagonal and of `meanShare` of its mean over all
    /// sites, for each kind of unknown by itself.
    Vector solve(const Vector& from, double ridge, double meanShare, int steps);

    Eigen::Index size() const { return static_cast<Eigen::Index>(m_first.size() - 1) * unknowns; }
    /// S (A^T A + ridge) S x, S the root of the inverse diagonal.
    Vector scaledProduct(const Vector& x) const;

  private:
    struct Part {
        std::uint32_t piece, at;
    };
    /// Of each site what its pieces have: of(piece, site's number there) -> its numbers, one after the other.
    template <class Of>
    Vector gathered(const Of& of) const;
    template <class AddRow>
    Vector summed(const AddRow& add) const;

    const std::vector<FitPiece<unknowns>>& m_pieces;
    std::vector<std::uint32_t> m_first; ///< of each site, into m_parts
    std::vector<Part> m_parts;
    Vector m_ridge, m_scale;
};

extern template struct FitPiece<unknownsOfBalls>;
extern template struct FitPiece<unknownsOfEllipsoids>;
extern template class NormalEquations<unknownsOfBalls>;
extern template class NormalEquations<unknownsOfEllipsoids>;

} // namespace reduce
