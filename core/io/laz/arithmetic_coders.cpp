#include "core/io/laz/arithmetic_coders.h"

#include <algorithm>

namespace io::laz {

static constexpr std::uint32_t leastLength = 1u << 24;

Decoder::Decoder(std::string_view bytes) : m_bytes(bytes) {
    for (int k = 0; k < 4; ++k)
        m_value = m_value << 8 | next();
}

void Decoder::shift() {
    while (m_length < leastLength) {
        m_value = m_value << 8 | next();
        m_length <<= 8;
    }
}

unsigned Decoder::bit(BitModel& model, unsigned) {
    const std::uint32_t zero = model.zero() * (m_length >> BitModel::lengthShift);
    const unsigned out = m_value >= zero ? 1 : 0;
    if (out == 0) {
        m_length = zero;
    } else {
        m_value -= zero;
        m_length -= zero;
    }
    shift();
    model.count(out);
    return out;
}

unsigned Decoder::symbol(SymbolModel& model, unsigned) {
    std::uint32_t end = m_length, begin = 0;
    m_length >>= SymbolModel::lengthShift;
    unsigned low = 0, high = model.symbols();
    for (unsigned k = high >> 1; k != low; k = (low + high) >> 1) {
        const std::uint32_t bound = m_length * model.before(k);
        if (bound > m_value)
            high = k, end = bound;
        else
            low = k, begin = bound;
    }
    m_value -= begin;
    m_length = end - begin;
    shift();
    model.count(low);
    return low;
}

std::uint32_t Decoder::bits(unsigned count, std::uint32_t) {
    std::uint32_t low = 0;
    unsigned done = 0;
    if (count > 19) { // the lower half first
        low = bits(16);
        done = 16;
    }
    count -= done;
    m_length >>= count;
    const std::uint32_t out = std::min(m_value / m_length, (1u << count) - 1);
    m_value -= m_length * out;
    shift();
    return out << done | low;
}

void Encoder::carry() {
    std::size_t at = m_bytes.size();
    while (at > 0 && m_bytes[at - 1] == '\xff')
        m_bytes[--at] = '\0';
    if (at > 0)
        ++m_bytes[at - 1];
}

void Encoder::shift() {
    while (m_length < leastLength) {
        m_bytes += static_cast<char>(m_base >> 24);
        m_base <<= 8;
        m_length <<= 8;
    }
}

unsigned Encoder::bit(BitModel& model, unsigned value) {
    const std::uint32_t zero = model.zero() * (m_length >> BitModel::lengthShift), before = m_base;
    if (value == 0) {
        m_length = zero;
    } else {
        m_base += zero;
        m_length -= zero;
        if (before > m_base)
            carry();
    }
    shift();
    model.count(value);
    return value;
}

unsigned Encoder::symbol(SymbolModel& model, unsigned value) {
    const std::uint32_t before = m_base, unit = m_length >> SymbolModel::lengthShift;
    const std::uint32_t begin = model.before(value) * unit;
    m_base += begin;
    m_length = (value + 1 == model.symbols() ? m_length : model.before(value + 1) * unit) - begin;
    if (before > m_base)
        carry();
    shift();
    model.count(value);
    return value;
}

std::uint32_t Encoder::bits(unsigned count, std::uint32_t value) {
    std::uint32_t rest = value;
    if (count > 19) {
        bits(16, value & 0xffffu);
        rest >>= 16;
        count -= 16;
    }
    const std::uint32_t before = m_base;
    m_length >>= count;
    m_base += rest * m_length;
    if (before > m_base)
        carry();
    shift();
    return value;
}

std::string Encoder::finish() {
    const std::uint32_t before = m_base;
    const bool wide = m_length > 2 * leastLength;
    m_base += wide ? leastLength : leastLength >> 1;
    m_length = wide ? leastLength >> 1 : leastLength >> 9;
    if (before > m_base)
        carry();
    shift();
    m_bytes.append(wide ? 3 : 2, '\0'); // decoders read so far ahead
    return std::move(m_bytes);
}

} // namespace io::laz
