// The bodies of point_models.h, which are templates over the coder's direction; included where one of them is used.
#pragma once

#include "core/io/laz/point_models.h"

namespace io::laz {

/// Which pairs of number of returns and return number share probabilities, by LASzip's table.
inline unsigned returnContext(unsigned returns, unsigned number) {
    static constexpr std::uint8_t table[8][8] = {{15, 14, 13, 12, 11, 10, 9, 8},  {14, 0, 1, 3, 6, 10, 10, 9},
                                                 {13, 1, 2, 4, 7, 11, 11, 10},    {12, 3, 4, 5, 8, 12, 12, 11},
                                                 {11, 6, 7, 8, 9, 13, 13, 12},    {10, 10, 11, 12, 13, 14, 14, 13},
                                                 {9, 10, 11, 12, 13, 14, 15, 14}, {8, 9, 10, 11, 12, 13, 14, 15}};
    return table[returns][number];
}

inline unsigned returnLevel(unsigned returns, unsigned number) {
    return returns > number ? returns - number : number - returns;
}

// --- formats 0 to 5 ---

template <class Coder>
unsigned Point10::changes(const char* item) {
    if constexpr (!Coder::encodes)
        return 0;
    const unsigned flags = byteAt(item + 14), context = returnContext(flags >> 3 & 7, flags & 7);
    const auto differs = [&](std::size_t at) { return item[at] != m_last[at] ? 1u : 0u; };
    return differs(14) << 5 | (get<std::uint16_t>(item + 12) != m_intensity[context] ? 1u : 0u) << 4 |
           differs(15) << 3 | differs(16) << 2 | differs(17) << 1 | (differs(18) | differs(19));
}

template <class Coder>
void Point10::codePlace(Coder& coder, const char* item, unsigned flags) {
    const unsigned returns = flags >> 3 & 7, context = returnContext(returns, flags & 7);
    const unsigned level = returnLevel(returns, flags & 7), single = returns == 1 ? 1 : 0;
    const auto difference = [&](std::size_t at) {
        return minus(get<std::int32_t>(item + at), get<std::int32_t>(m_last + at));
    };
    const std::int32_t dx = m_x.code(coder, m_dx[context].value(), difference(0), single);
    m_dx[context].add(dx);
    const std::int32_t dy = m_y.code(coder, m_dy[context].value(), difference(4), single + sizeContext(m_x.size(), 20));
    m_dy[context].add(dy);
    const unsigned bits = (m_x.size() + m_y.size()) / 2;
    m_height[level] = m_z.code(coder, m_height[level], get<std::int32_t>(item + 8), single + sizeContext(bits, 18));
    set(m_last, plus(get<std::int32_t>(m_last), dx));
    set(m_last + 4, plus(get<std::int32_t>(m_last + 4), dy));
    set(m_last + 8, m_height[level]);
}

template <class Coder>
void Point10::code(Coder& coder, char* item) {
    const unsigned changed = coder.symbol(m_changed, changes<Coder>(item));
    if ((changed & 32) != 0)
        m_last[14] = static_cast<char>(coder.symbol(m_flags[byteAt(m_last + 14)], byteAt(item + 14)));
    const unsigned flags = byteAt(m_last + 14), context = returnContext(flags >> 3 & 7, flags & 7);
    if ((changed & 16) != 0)
        m_intensity[context] = static_cast<std::uint16_t>(
            m_intensities.code(coder, m_intensity[context], get<std::uint16_t>(item + 12), std::min(context, 3u)));
    set(m_last + 12, m_intensity[context]);
    if ((changed & 8) != 0)
        m_last[15] = static_cast<char>(coder.symbol(m_class[byteAt(m_last + 15)], byteAt(item + 15)));
    if ((changed & 4) != 0)
        m_last[16] =
            static_cast<char>(coder.symbol(m_angle[flags >> 6 & 1], (byteAt(item + 16) - byteAt(m_last + 16)) & 255) +
                              byteAt(m_last + 16));
    if ((changed & 2) != 0)
        m_last[17] = static_cast<char>(coder.symbol(m_user[byteAt(m_last + 17)], byteAt(item + 17)));
    if ((changed & 1) != 0)
        set(m_last + 18, static_cast<std::uint16_t>(
                             m_source.code(coder, get<std::uint16_t>(m_last + 18), get<std::uint16_t>(item + 18), 0)));
    codePlace(coder, item, flags);
    std::memcpy(item, m_last, size);
}

// --- GPS times ---

/// Differences that are no usual multiple become the usual one when they come four times.
inline void GpsTime::judge(std::int32_t difference) {
    if (++m_extremes[m_at] > 3) {
        m_differences[m_at] = difference;
        m_extremes[m_at] = 0;
    }
}

template <class Coder>
void GpsTime::codeFull(Coder& coder, std::int64_t now) {
    m_newest = (m_newest + 1) & 3;
    const auto high = static_cast<std::uint32_t>(
        m_numbers.code(coder, static_cast<std::int32_t>(m_times[m_at] >> 32), static_cast<std::int32_t>(now >> 32), 8));
    const std::uint32_t low = coder.bits(32, static_cast<std::uint32_t>(now));
    m_at = m_newest;
    m_times[m_at] = static_cast<std::int64_t>(static_cast<std::uint64_t>(high) << 32 | low);
    m_differences[m_at] = 0;
    m_extremes[m_at] = 0;
}

/// After a time that has no difference yet. False where the code only changes to another sequence.
template <class Coder>
bool GpsTime::codeFirst(Coder& coder, std::int64_t now) {
    unsigned way = 0;
    if constexpr (Coder::encodes)
        way = m_shift == 1 && since(now) == 0                       ? 0
              : since(now) == static_cast<std::int32_t>(since(now)) ? m_shift
                                                                    : m_shift + 1;
    way = coder.symbol(m_firsts, way);
    if (way == 0 && m_shift == 1)
        return true;
    if (way == m_shift) {
        m_differences[m_at] = m_numbers.code(coder, 0, static_cast<std::int32_t>(since(now)), 0);
        advance(m_differences[m_at]);
        m_extremes[m_at] = 0;
        return true;
    }
    if (way == m_shift + 1) {
        codeFull(coder, now);
        return true;
    }
    m_at = (m_at + way - m_shift - 1) & 3;
    return false;
}

/// For encoders: the multiple of the last difference that comes nearest.
inline unsigned GpsTime::furtherCode(std::int64_t now) const {
    const std::int64_t difference = since(now);
    if (m_shift == 1 && difference == 0)
        return most - least + 1;
    if (difference != static_cast<std::int32_t>(difference))
        return full();
    const double ratio = static_cast<double>(difference) / m_differences[m_at];
    const int multiple = static_cast<int>(std::clamp(ratio < 0 ? ratio - 0.5 : ratio + 0.5, least + 0.0, most + 0.0));
    return static_cast<unsigned>(multiple >= 0 ? multiple : most - multiple);
}

template <class Coder>
bool GpsTime::codeFurther(Coder& coder, std::int64_t now) {
    unsigned way = 0;
    if constexpr (Coder::encodes)
        way = furtherCode(now);
    way = coder.symbol(m_multiples, way);
    if (m_shift == 1 && way == full() - 1)
        return true;
    if (way == full()) {
        codeFull(coder, now);
        return true;
    }
    if (way > full()) {
        m_at = (m_at + way - full()) & 3;
        return false;
    }
    const int multiple = way <= most ? static_cast<int>(way) : most - static_cast<int>(way);
    const unsigned context = multiple == 0       ? 7
                             : multiple == 1     ? 1
                             : multiple == most  ? 4
                             : multiple == least ? 6
                             : multiple < 0      ? 5
                             : multiple < 10     ? 2
                                                 : 3;
    const std::int32_t difference =
        m_numbers.code(coder, times(multiple, m_differences[m_at]), static_cast<std::int32_t>(since(now)), context);
    advance(difference);
    if (multiple == 1)
        m_extremes[m_at] = 0;
    else if (multiple == 0 || multiple == most || multiple == least)
        judge(difference);
    return true;
}

template <class Coder>
void GpsTime::code(Coder& coder, char* item) {
    const auto now = get<std::int64_t>(item);
    // Sound files change the sequence once at most.
    for (int tries = 0; tries < 8; ++tries)
        if (m_differences[m_at] == 0 ? codeFirst(coder, now) : codeFurther(coder, now))
            break;
    set(item, m_times[m_at]);
}

// --- colours ---

inline unsigned lowOf(unsigned v) {
    return v & 255;
}
inline unsigned highOf(unsigned v) {
    return v >> 8;
}

template <class Coder>
void Rgb::code(Coder& coder, const char* last, char* item) {
    unsigned before[3], now[3];
    for (std::size_t k = 0; k < 3; ++k)
        before[k] = get<std::uint16_t>(last + 2 * k), now[k] = get<std::uint16_t>(item + 2 * k);
    unsigned used = 0;
    if constexpr (Coder::encodes) {
        for (unsigned k = 0; k < 3; ++k)
            used |= (lowOf(before[k]) != lowOf(now[k]) ? 1u : 0u) << (2 * k) |
                    (highOf(before[k]) != highOf(now[k]) ? 1u : 0u) << (2 * k + 1);
        used |= (now[0] != now[1] || now[0] != now[2] ? 1u : 0u) << 6;
    }
    used = coder.symbol(m_used, used);
    const auto part = [&](unsigned bit, int predicted, unsigned real) {
        const auto from = static_cast<unsigned>(std::clamp(predicted, 0, 255));
        return (coder.symbol(m_corrections[bit], (real - from) & 255) + from) & 255;
    };
    const auto has = [&](unsigned bit) { return (used >> bit & 1) != 0; };
    const auto of = [](unsigned v) { return static_cast<int>(v); };
    unsigned out[3] = {};
    unsigned low = lowOf(before[0]), high = highOf(before[0]);
    if (has(0))
        low = part(0, of(low), lowOf(now[0]));
    if (has(1))
        high = part(1, of(high), highOf(now[0]));
    out[0] = high << 8 | low;
    if (!has(6)) {
        out[1] = out[2] = out[0];
    } else {
        int difference = of(lowOf(out[0])) - of(lowOf(before[0]));
        unsigned green = lowOf(before[1]), blue = lowOf(before[2]);
        if (has(2))
            green = part(2, difference + of(green), lowOf(now[1]));
        if (has(4)) {
            difference = (difference + of(green) - of(lowOf(before[1]))) / 2;
            blue = part(4, difference + of(blue), lowOf(now[2]));
        }
        out[1] = green, out[2] = blue;
        difference = of(highOf(out[0])) - of(highOf(before[0]));
        green = highOf(before[1]), blue = highOf(before[2]);
        if (has(3))
            green = part(3, difference + of(green), highOf(now[1]));
        if (has(5)) {
            difference = (difference + of(green) - of(highOf(before[1]))) / 2;
            blue = part(5, difference + of(blue), highOf(now[2]));
        }
        out[1] |= green << 8, out[2] |= blue << 8;
    }
    for (std::size_t k = 0; k < 3; ++k)
        set(item + 2 * k, static_cast<std::uint16_t>(out[k]));
}

template <class Coder>
void Nir::code(Coder& coder, const char* last, char* item) {
    unsigned used = 0;
    if constexpr (Coder::encodes)
        used = (item[0] != last[0] ? 1u : 0u) | (item[1] != last[1] ? 2u : 0u);
    used = coder.symbol(m_used, used);
    for (unsigned k = 0; k < 2; ++k) {
        const unsigned before = byteAt(last + k), real = byteAt(item + k);
        item[k] = last[k];
        if ((used >> k & 1) != 0)
            item[k] = static_cast<char>(coder.symbol(m_corrections[k], (real - before) & 255) + before);
    }
}

// --- waveforms ---

template <class Coder>
void WavePacket::code(Coder& coder, const char* last, char* item) {
    *item = static_cast<char>(coder.symbol(m_index, byteAt(item)));
    const auto before = get<std::uint64_t>(last + 1), real = get<std::uint64_t>(item + 1);
    const auto length = get<std::uint32_t>(last + 9);
    const auto difference = static_cast<std::int64_t>(real - before);
    unsigned way = 0;
    if constexpr (Coder::encodes)
        way = difference == 0                                       ? 0
              : difference == length                                ? 1
              : difference == static_cast<std::int32_t>(difference) ? 2
                                                                    : 3;
    m_way = coder.symbol(m_ways[m_way], way);
    std::uint64_t offset = before;
    if (m_way == 1) {
        offset = before + length;
    } else if (m_way == 2) {
        m_difference = m_offset.code(coder, m_difference, static_cast<std::int32_t>(difference), 0);
        offset = before + static_cast<std::uint64_t>(static_cast<std::int64_t>(m_difference));
    } else if (m_way == 3) {
        offset = coder.bits(32, static_cast<std::uint32_t>(real));
        offset |= static_cast<std::uint64_t>(coder.bits(32, static_cast<std::uint32_t>(real >> 32))) << 32;
    }
    set(item + 1, offset);
    const auto number = [&](IntegerModel& model, std::size_t at, unsigned context) {
        set(item + at, model.code(coder, get<std::int32_t>(last + at), get<std::int32_t>(item + at), context));
    };
    number(m_size, 9, 0);
    number(m_return, 13, 0);
    for (unsigned k = 0; k < 3; ++k)
        number(m_direction, 17 + 4 * k, k);
}

} // namespace io::laz
