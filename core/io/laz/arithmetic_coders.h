// The arithmetic coder of LASzip ([Said04]) in both directions. A decoder and an encoder have the same
// methods, so that what is coded in which order stands in one place for both: the encoder takes values and returns
// them, the decoder passes over what it is given and returns what the bytes say.
//
// A decoder never reads behind its bytes: it goes on with zeros, and `overran()` tells that they cannot have been
// whole.
#pragma once

#include "core/io/laz/arithmetic_models.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace io::laz {

class Decoder {
  public:
    static constexpr bool encodes = false;

    Decoder() = default;
    explicit Decoder(std::string_view bytes);

    unsigned bit(BitModel& model, unsigned = 0);
    unsigned symbol(SymbolModel& model, unsigned = 0);
    /// So many bits of equal probability, at most 32.
    std::uint32_t bits(unsigned count, std::uint32_t = 0);
    /// Whether more was read than encoders leave out at the end.
    bool overran() const { return m_at > m_bytes.size() + 8; }

  private:
    void shift();
    std::uint32_t next() {
        const std::size_t at = m_at++;
        return at < m_bytes.size() ? static_cast<unsigned char>(m_bytes[at]) : 0u;
    }

    std::string_view m_bytes;
    std::size_t m_at = 0;
    std::uint32_t m_value = 0, m_length = 0xffffffffu;
};

class Encoder {
  public:
    static constexpr bool encodes = true;

    unsigned bit(BitModel& model, unsigned value);
    unsigned symbol(SymbolModel& model, unsigned value);
    std::uint32_t bits(unsigned count, std::uint32_t value);
    /// All bytes. Nothing may be coded any more.
    std::string finish();

  private:
    void carry();
    void shift();

    std::string m_bytes;
    std::uint32_t m_base = 0, m_length = 0xffffffffu;
};

} // namespace io::laz
