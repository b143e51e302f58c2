// How LASzip codes whole numbers: as corrections of predictions, by the number of bits that the correction needs, then
// these bits, the upper eight of them with probabilities of their own.
#pragma once

#include "core/io/laz/arithmetic_coders.h"

#include <limits>
#include <memory>

namespace io::laz {

class IntegerModel {
  public:
    /// Numbers of so many bits (16 or 32), with probabilities for each of `contexts`.
    IntegerModel(unsigned bits, unsigned contexts) : m_bits(bits), m_sizes(contexts), m_corrections(bits + 1) {}

    /// `real` is what an encoder codes; returns it, or what the decoder reads. REQUIRES: context < contexts.
    template <class Coder>
    std::int32_t code(Coder& coder, std::int32_t predicted, std::int32_t real, unsigned context);
    /// Bits of the last correction.
    unsigned size() const { return m_size; }

  private:
    static constexpr unsigned modelled = 8;

    SymbolModel& model(std::unique_ptr<SymbolModel>& of, unsigned symbols) {
        if (!of)
            of = std::make_unique<SymbolModel>(symbols);
        return *of;
    }
    template <class Coder>
    std::int64_t correction(Coder& coder, std::int64_t real, unsigned context);

    unsigned m_bits, m_size = 0;
    BitModel m_one;
    std::vector<std::unique_ptr<SymbolModel>> m_sizes, m_corrections;
};

/// A correction c of size k > 0 lies in -(2^k - 1) ... -2^(k-1) or 2^(k-1) + 1 ... 2^k; of size 0 it is 0 or 1.
template <class Coder>
std::int64_t IntegerModel::correction(Coder& coder, std::int64_t real, unsigned context) {
    if constexpr (Coder::encodes) {
        const std::int64_t magnitude = real <= 0 ? -real : real - 1;
        m_size = 0;
        while (magnitude >> m_size != 0)
            ++m_size;
    }
    m_size = coder.symbol(model(m_sizes[context], m_bits + 1), m_size);
    if (m_size == 0)
        return coder.bit(m_one, static_cast<unsigned>(real));
    if (m_size == 32)
        return std::numeric_limits<std::int32_t>::min();
    const std::int64_t reach = (std::int64_t(1) << m_size) - 1;
    const auto packed = static_cast<std::uint32_t>(real < 0 ? real + reach : real - 1);
    const unsigned plain = m_size > modelled ? m_size - modelled : 0;
    std::uint32_t out =
        coder.symbol(model(m_corrections[m_size], 1u << (m_size - plain)), Coder::encodes ? packed >> plain : 0);
    if (plain > 0)
        out = out << plain | coder.bits(plain, packed & ((1u << plain) - 1));
    const auto wide = static_cast<std::int64_t>(out);
    return wide >= std::int64_t(1) << (m_size - 1) ? wide + 1 : wide - reach;
}

template <class Coder>
std::int32_t IntegerModel::code(Coder& coder, std::int32_t predicted, std::int32_t real, unsigned context) {
    // All of it modulo 2^bits, as differences of numbers that fill the bits must be.
    const std::int64_t range = std::int64_t(1) << m_bits, half = range >> 1;
    std::int64_t wanted = 0;
    if constexpr (Coder::encodes) {
        wanted = static_cast<std::int64_t>(real) - predicted;
        if (wanted < -half)
            wanted += range;
        else if (wanted > half - 1)
            wanted -= range;
    }
    std::int64_t out = predicted + correction(coder, wanted, context);
    if (m_bits == 32)
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(out)));
    if (out < 0)
        out += range;
    else if (out >= range)
        out -= range;
    return static_cast<std::int32_t>(out);
}

} // namespace io::laz
