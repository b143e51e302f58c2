// One field of all records of a scan, as E57 packs it: reals as they are, whole numbers in as many bits as their range
// needs, the lowest first, without gaps (io/README 2.14). Bytes come in pieces, values go out as soon as they are
// whole.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace io::e57 {

enum class Kind { Single, Double, Integer, Scaled };

struct PackedField {
    std::string name; ///< "cartesianX"
    Kind kind = Kind::Double;
    std::int64_t least = std::numeric_limits<std::int64_t>::min(), most = std::numeric_limits<std::int64_t>::max();
    double scale = 1, offset = 0; ///< of Scaled

    unsigned bits() const;
};

class PackedStream {
  public:
    explicit PackedStream(const PackedField& field) : m_field(field), m_bits(field.bits()) {}

    const PackedField& field() const { return m_field; }
    void append(std::string_view bytes) { m_bytes += bytes; }
    /// How many values are there; without end for those that need no bits.
    std::uint64_t available() const {
        return m_bits == 0 ? std::numeric_limits<std::uint64_t>::max() : (m_bytes.size() * 8 - m_at) / m_bits;
    }
    /// The k-th of them. REQUIRES: k < available().
    double value(std::uint64_t k) const;
    /// Forgets the first ones.
    void drop(std::uint64_t count);

  private:
    std::uint64_t raw(std::uint64_t bit) const;

    PackedField m_field;
    unsigned m_bits;
    std::string m_bytes;
    std::uint64_t m_at = 0; ///< bit in them at which the first value starts
};

} // namespace io::e57
