#include "core/io/e57/packed_stream.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace io::e57 {

unsigned PackedField::bits() const {
    switch (kind) {
    case Kind::Single:
        return 32;
    case Kind::Double:
        return 64;
    case Kind::Integer:
    case Kind::Scaled:
        break;
    }
    const auto range = static_cast<std::uint64_t>(most) - static_cast<std::uint64_t>(least);
    return static_cast<unsigned>(std::bit_width(range));
}

std::uint64_t PackedStream::raw(std::uint64_t bit) const {
    const auto byte = static_cast<std::size_t>(bit >> 3);
    const auto shift = static_cast<unsigned>(bit & 7);
    std::uint64_t out = 0;
    std::memcpy(&out, m_bytes.data() + byte, std::min<std::size_t>(8, m_bytes.size() - byte));
    out >>= shift;
    if (shift + m_bits > 64)
        out |= static_cast<std::uint64_t>(static_cast<unsigned char>(m_bytes[byte + 8])) << (64 - shift);
    return m_bits == 64 ? out : out & ((std::uint64_t(1) << m_bits) - 1);
}

double PackedStream::value(std::uint64_t k) const {
    const std::uint64_t packed = m_bits == 0 ? 0 : raw(m_at + k * m_bits);
    switch (m_field.kind) {
    case Kind::Single:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(packed)));
    case Kind::Double:
        return std::bit_cast<double>(packed);
    case Kind::Integer:
    case Kind::Scaled:
        break;
    }
    const auto whole =
        static_cast<double>(static_cast<std::int64_t>(static_cast<std::uint64_t>(m_field.least) + packed));
    return m_field.kind == Kind::Scaled ? whole * m_field.scale + m_field.offset : whole;
}

void PackedStream::drop(std::uint64_t count) {
    if (m_bits == 0)
        return;
    m_at += count * m_bits;
    m_bytes.erase(0, static_cast<std::size_t>(m_at >> 3));
    m_at &= 7;
}

} // namespace io::e57
