// Adaptive probabilities of the arithmetic coder that LASzip uses ([Said04]): of two and of up to some hundred
// symbols. Coding and decoding share them, so that both sides learn the same.
#pragma once

#include <cstdint>
#include <vector>

namespace io::laz {

class BitModel {
  public:
    static constexpr unsigned lengthShift = 13;

    std::uint32_t zero() const { return m_zero; } ///< share of zeros, in 2^-13
    void count(unsigned bit) {
        m_zeros += bit == 0 ? 1 : 0;
        if (--m_untilUpdate == 0)
            update();
    }

  private:
    void update();

    std::uint32_t m_zeros = 1, m_bits = 2, m_zero = 1u << (lengthShift - 1), m_cycle = 4, m_untilUpdate = 4;
};

class SymbolModel {
  public:
    static constexpr unsigned lengthShift = 15;

    /// REQUIRES: 2 to 2048 symbols.
    explicit SymbolModel(unsigned symbols);
    unsigned symbols() const { return static_cast<unsigned>(m_counts.size()); }
    /// Sum of the shares of all symbols before k, in 2^-15. REQUIRES: k < symbols().
    std::uint32_t before(unsigned k) const { return m_before[k]; }
    void count(unsigned symbol) {
        ++m_counts[symbol];
        if (--m_untilUpdate == 0)
            update();
    }

  private:
    void update();

    std::vector<std::uint32_t> m_counts, m_before;
    std::uint32_t m_total = 0, m_cycle = 0, m_untilUpdate = 0;
};

} // namespace io::laz
