#include "core/io/laz/arithmetic_models.h"

#include <algorithm>

namespace io::laz {

void BitModel::update() {
    m_bits += m_cycle;
    if (m_bits > 1u << lengthShift) {
        m_bits = (m_bits + 1) >> 1;
        m_zeros = (m_zeros + 1) >> 1;
        if (m_zeros == m_bits)
            ++m_bits;
    }
    const std::uint32_t scale = 0x80000000u / m_bits;
    m_zero = (m_zeros * scale) >> (31 - lengthShift);
    m_cycle = std::min((5 * m_cycle) >> 2, 64u);
    m_untilUpdate = m_cycle;
}

SymbolModel::SymbolModel(unsigned symbols) : m_counts(symbols, 1), m_before(symbols, 0), m_cycle(symbols) {
    update();
    m_cycle = m_untilUpdate = (symbols + 6) >> 1;
}

void SymbolModel::update() {
    m_total += m_cycle;
    if (m_total > 1u << lengthShift) {
        m_total = 0;
        for (std::uint32_t& count : m_counts) {
            count = (count + 1) >> 1;
            m_total += count;
        }
    }
    const std::uint32_t scale = 0x80000000u / m_total;
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < m_counts.size(); ++k) {
        m_before[k] = (scale * sum) >> (31 - lengthShift);
        sum += m_counts[k];
    }
    m_cycle = std::min((5 * m_cycle) >> 2, (symbols() + 6) << 3);
    m_untilUpdate = m_cycle;
}

} // namespace io::laz
