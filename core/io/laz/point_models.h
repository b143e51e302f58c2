// How LASzip codes the fields of one point after those of the one before it, item by item: formats 0 to 5, and what
// formats 6 to 10 share with them (io/README 2.13). Every `code` does both directions: an encoder reads the item, a
// decoder writes it. Items lie in the record as LAS has them.
#pragma once

#include "core/io/laz/integer_model.h"
#include "core/io/laz/record_bytes.h"
#include "core/io/laz/streaming_median.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace io::laz {

/// A model for each of N contexts, made when it is first needed.
template <std::size_t N>
class SymbolModels {
  public:
    explicit SymbolModels(unsigned symbols) : m_symbols(symbols) {}
    SymbolModel& operator[](std::size_t context) {
        if (!m_models[context])
            m_models[context] = std::make_unique<SymbolModel>(m_symbols);
        return *m_models[context];
    }

  private:
    unsigned m_symbols;
    std::array<std::unique_ptr<SymbolModel>, N> m_models;
};

/// The context of the sizes of coordinates that one correction's size is for the next: even numbers up to `most`.
inline unsigned sizeContext(unsigned size, unsigned most) {
    return size < most ? size & ~1u : most;
}

/// The 20 bytes of formats 0 to 5 (POINT10, version 2).
class Point10 {
  public:
    static constexpr std::size_t size = 20;

    explicit Point10(const char* first) {
        std::memcpy(m_last, first, size);
        set<std::uint16_t>(m_last + 12, 0);
    }
    template <class Coder>
    void code(Coder& coder, char* item);

  private:
    template <class Coder>
    unsigned changes(const char* item);
    template <class Coder>
    void codePlace(Coder& coder, const char* item, unsigned returns);

    char m_last[size];
    std::uint16_t m_intensity[16] = {};
    std::int32_t m_height[8] = {};
    StreamingMedian m_dx[16], m_dy[16];
    SymbolModel m_changed{64};
    SymbolModels<256> m_flags{256}, m_class{256}, m_user{256};
    SymbolModels<2> m_angle{256};
    IntegerModel m_intensities{16, 4}, m_source{16, 1}, m_x{32, 2}, m_y{32, 22}, m_z{32, 20};
};

/// GPS times, of both kinds of formats: as multiples of the last difference, in up to four sequences at once.
class GpsTime {
  public:
    static constexpr std::size_t size = 8;

    /// `isLayered`: the codes of formats 6 to 10, which know without them that a time has changed.
    GpsTime(const char* first, bool isLayered) : m_shift(isLayered ? 0 : 1) { m_times[0] = get<std::int64_t>(first); }
    template <class Coder>
    void code(Coder& coder, char* item);

  private:
    static constexpr int most = 500, least = -10;

    unsigned full() const { return most - least + 1 + m_shift; } ///< code of a whole time
    template <class Coder>
    void codeFull(Coder& coder, std::int64_t now);
    template <class Coder>
    bool codeFirst(Coder& coder, std::int64_t now);
    template <class Coder>
    bool codeFurther(Coder& coder, std::int64_t now);
    unsigned furtherCode(std::int64_t now) const;
    void judge(std::int32_t difference);
    void advance(std::int32_t difference) {
        m_times[m_at] = static_cast<std::int64_t>(static_cast<std::uint64_t>(m_times[m_at]) +
                                                  static_cast<std::uint64_t>(static_cast<std::int64_t>(difference)));
    }
    std::int64_t since(std::int64_t now) const {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(now) - static_cast<std::uint64_t>(m_times[m_at]));
    }

    unsigned m_shift, m_at = 0, m_newest = 0;
    std::int64_t m_times[4] = {};
    std::int32_t m_differences[4] = {};
    int m_extremes[4] = {};
    SymbolModel m_multiples{515 + m_shift}, m_firsts{5 + m_shift};
    IntegerModel m_numbers{32, 9};
};

/// Red, green and blue of 16 bits.
class Rgb {
  public:
    static constexpr std::size_t size = 6;

    template <class Coder>
    void code(Coder& coder, const char* last, char* item);

  private:
    SymbolModel m_used{128};
    SymbolModels<6> m_corrections{256};
};

/// Near infrared of 16 bits.
class Nir {
  public:
    static constexpr std::size_t size = 2;

    template <class Coder>
    void code(Coder& coder, const char* last, char* item);

  private:
    SymbolModel m_used{4};
    SymbolModels<2> m_corrections{256};
};

/// Where a point's waveform lies.
class WavePacket {
  public:
    static constexpr std::size_t size = 29;

    template <class Coder>
    void code(Coder& coder, const char* last, char* item);

  private:
    unsigned m_way = 0;
    std::int32_t m_difference = 0;
    SymbolModel m_index{256};
    SymbolModels<4> m_ways{4};
    IntegerModel m_offset{32, 1}, m_size{32, 1}, m_return{32, 1}, m_direction{32, 3};
};

/// One extra byte.
class ExtraByte {
  public:
    template <class Coder>
    void code(Coder& coder, const char* last, char* item) {
        const unsigned correction = coder.symbol(m_model, (byteAt(item) - byteAt(last)) & 255);
        *item = static_cast<char>(correction + byteAt(last));
    }

  private:
    SymbolModel m_model{256};
};

} // namespace io::laz
