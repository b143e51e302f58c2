#include "core/io/laz/layered_points.h"

#include "core/io/laz/point_coding.h"

namespace io::laz {

namespace {

constexpr std::size_t pointSize = 30;

/// Which pairs of number of returns and return number share probabilities: the table of LASzip is even but for its
/// edges, and so is told by rules.
unsigned returnContext14(unsigned returns, unsigned number) {
    static constexpr std::uint8_t table[16][16] = {
        {0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5}, {1, 0, 1, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3},
        {2, 1, 2, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3}, {3, 3, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
        {4, 3, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4}, {5, 3, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4},
        {3, 3, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4, 4}, {4, 3, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4, 4},
        {4, 3, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4, 4}, {5, 3, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4, 4},
        {5, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 4, 4, 4, 4, 4}, {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 4, 4, 4},
        {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4, 4}, {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 4},
        {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5}, {5, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5}};
    return table[returns][number];
}

unsigned numberOf(const char* record) {
    return byteAt(record + 14) & 15;
}
unsigned returnsOf(const char* record) {
    return byteAt(record + 14) >> 4;
}
unsigned channelOf(const char* record) {
    return byteAt(record + 15) >> 4 & 3;
}
/// Edge of flight line, scan direction and the four flags of the class, as the layer has them.
unsigned flagsOf(const char* record) {
    const unsigned bits = byteAt(record + 15);
    return (bits >> 7 & 1) << 5 | (bits >> 6 & 1) << 4 | (bits & 15);
}

/// First of its pulse, last of it, both or neither.
unsigned kindOf(unsigned number, unsigned returns) {
    return (number == 1 ? 1u : 0u) + (number >= returns ? 2u : 0u);
}

} // namespace

/// What one channel of the scanner remembers.
template <class Coder>
struct LayeredPoints<Coder>::Channel {
    Channel(const LayeredItems& items, const char* first) : last(first, first + pointSize), time(first + 22, true) {
        std::fill_n(heights, 8, get<std::int32_t>(first + 8));
        std::fill_n(intensities, 8, get<std::uint16_t>(first + 12));
        extra.resize(items.extraCount);
        further.assign(first + pointSize, first + std::max(items.extra + items.extraCount, pointSize));
    }

    std::string last; ///< its last point, 30 bytes
    bool newTime = false;
    std::int32_t heights[8];
    std::uint16_t intensities[8];
    StreamingMedian dx[12], dy[12];
    SymbolModels<8> changed{128};
    SymbolModel switches{3}, sameTimeNumber{13};
    SymbolModels<16> returns{16}, number{16};
    IntegerModel x{32, 2}, y{32, 22}, z{32, 20};
    SymbolModels<64> classes{256}, flags{64}, user{256};
    IntegerModel intensity{16, 4}, angle{16, 2}, source{16, 1};
    GpsTime time;

    std::string further; ///< its last bytes behind the point's 30
    Rgb rgb;
    Nir nir;
    WavePacket wave;
    std::vector<ExtraByte> extra;
};

template <class Coder>
LayeredPoints<Coder>::LayeredPoints(const LayeredItems& items, const char* first, std::vector<Coder*> coders)
    : m_items(items), m_coders(std::move(coders)) {
    m_current = m_previous = channelOf(first);
    channel(m_current, first);
}

template <class Coder>
LayeredPoints<Coder>::~LayeredPoints() = default;

template <class Coder>
typename LayeredPoints<Coder>::Channel& LayeredPoints<Coder>::channel(unsigned number, const char* first) {
    if (!m_channels[number])
        m_channels[number] = std::make_unique<Channel>(m_items, first);
    return *m_channels[number];
}

template <class Coder>
unsigned LayeredPoints<Coder>::changes(const Channel& last, const Channel& before, const char* record) const {
    if constexpr (!Coder::encodes)
        return 0;
    const char* const old = before.last.data();
    const unsigned step = (numberOf(record) - numberOf(old)) & 15;
    const auto differs = [&](std::size_t at, std::size_t size) {
        return std::memcmp(record + at, old + at, size) != 0 ? 1u : 0u;
    };
    return (&last != &before || channelOf(record) != m_current ? 1u : 0u) << 6 | differs(20, 2) << 5 |
           differs(22, 8) << 4 | differs(18, 2) << 3 | (returnsOf(record) != returnsOf(old) ? 1u : 0u) << 2 |
           (step == 0    ? 0u
            : step == 1  ? 1u
            : step == 15 ? 2u
                         : 3u);
}

/// The number of returns and which of them it is, into the last point's byte.
template <class Coder>
unsigned LayeredPoints<Coder>::codeReturns(Channel& c, unsigned changed, const char* record) {
    Coder& coder = *layer(Place);
    unsigned returns = returnsOf(c.last.data());
    const unsigned before = numberOf(c.last.data());
    if ((changed & 4) != 0)
        returns = coder.symbol(c.returns[returns], returnsOf(record));
    unsigned number = before;
    switch (changed & 3) {
    case 1:
        number = (before + 1) & 15;
        break;
    case 2:
        number = (before + 15) & 15;
        break;
    case 3:
        number = (changed & 16) != 0
                     ? coder.symbol(c.number[before], numberOf(record))
                     : (before + coder.symbol(c.sameTimeNumber, (numberOf(record) - before - 2) & 15) + 2) & 15;
        break;
    default:
        break;
    }
    c.last[14] = static_cast<char>(returns << 4 | number);
    return returns;
}

template <class Coder>
void LayeredPoints<Coder>::codePlace(Channel& c, unsigned returns, bool newTime, const char* record) {
    char* const last = c.last.data();
    const unsigned number = numberOf(last), single = returns == 1 ? 1 : 0;
    const unsigned context = returnContext14(returns, number) << 1 | (newTime ? 1 : 0);
    const unsigned level = std::min(returnLevel(returns, number), 7u);
    const auto difference = [&](std::size_t at) {
        return minus(get<std::int32_t>(record + at), get<std::int32_t>(last + at));
    };
    const std::int32_t dx = c.x.code(*layer(Place), c.dx[context].value(), difference(0), single);
    c.dx[context].add(dx);
    const std::int32_t dy =
        c.y.code(*layer(Place), c.dy[context].value(), difference(4), single + sizeContext(c.x.size(), 20));
    c.dy[context].add(dy);
    set(last, plus(get<std::int32_t>(last), dx));
    set(last + 4, plus(get<std::int32_t>(last + 4), dy));
    if (layer(Height)) {
        const unsigned bits = (c.x.size() + c.y.size()) / 2;
        c.heights[level] =
            c.z.code(*layer(Height), c.heights[level], get<std::int32_t>(record + 8), single + sizeContext(bits, 18));
        set(last + 8, c.heights[level]);
    }
}

template <class Coder>
void LayeredPoints<Coder>::codeFields(Channel& c, unsigned changed, unsigned kind, const char* record) {
    char* const last = c.last.data();
    const unsigned newTime = changed >> 4 & 1;
    if (Coder* coder = layer(Class)) {
        const unsigned context = (byteAt(last + 16) & 31) << 1 | (kind == 3 ? 1 : 0);
        last[16] = static_cast<char>(coder->symbol(c.classes[context], byteAt(record + 16)));
    }
    if (Coder* coder = layer(Flags)) {
        const unsigned flags = coder->symbol(c.flags[flagsOf(last)], flagsOf(record));
        last[15] = static_cast<char>((byteAt(last + 15) & 0x30) | (flags & 15) | (flags >> 4 & 1) << 6 |
                                     (flags >> 5 & 1) << 7);
    }
    if (Coder* coder = layer(Intensity)) {
        std::uint16_t& intensity = c.intensities[kind << 1 | newTime];
        intensity =
            static_cast<std::uint16_t>(c.intensity.code(*coder, intensity, get<std::uint16_t>(record + 12), kind));
        set(last + 12, intensity);
    }
    if (Coder* coder = layer(Angle); coder && (changed & 8) != 0)
        set(last + 18, static_cast<std::int16_t>(c.angle.code(*coder, get<std::int16_t>(last + 18),
                                                              get<std::int16_t>(record + 18), newTime)));
    if (Coder* coder = layer(User))
        last[17] = static_cast<char>(coder->symbol(c.user[byteAt(last + 17) / 4], byteAt(record + 17)));
    if (Coder* coder = layer(Source); coder && (changed & 32) != 0)
        set(last + 20, static_cast<std::uint16_t>(
                           c.source.code(*coder, get<std::uint16_t>(last + 20), get<std::uint16_t>(record + 20), 0)));
    if (Coder* coder = layer(Time); coder && newTime != 0) {
        if constexpr (Coder::encodes)
            std::memcpy(last + 22, record + 22, 8);
        c.time.code(*coder, last + 22);
    }
}

/// The last bytes of an item behind the first 30, from which the next are told.
template <class Coder>
char* LayeredPoints<Coder>::lastOfFurther(Channel& c, std::size_t item, bool switched) {
    Channel& from = switched && !m_items.mendsChannels ? *m_channels[m_previous] : c;
    return from.further.data() + item - pointSize;
}

template <class Coder>
void LayeredPoints<Coder>::codeFurther(Channel& c, bool switched, char* record) {
    std::size_t at = fixedLayers;
    const auto item = [&](std::size_t offset, std::size_t size, auto& model) {
        char* const last = lastOfFurther(c, offset, switched);
        if (Coder* coder = layer(at++)) {
            model.code(*coder, last, record + offset);
            std::memcpy(last, record + offset, size);
        } else {
            std::memcpy(record + offset, last, size);
        }
    };
    if (m_items.rgb > 0)
        item(m_items.rgb, Rgb::size, c.rgb);
    if (m_items.nir > 0)
        item(m_items.nir, Nir::size, c.nir);
    if (m_items.wave > 0)
        item(m_items.wave, WavePacket::size, c.wave);
    for (std::size_t k = 0; k < m_items.extraCount; ++k)
        item(m_items.extra + k, 1, c.extra[k]);
}

template <class Coder>
void LayeredPoints<Coder>::code(char* record) {
    m_previous = m_current;
    Channel* c = m_channels[m_current].get();
    const unsigned context = kindOf(numberOf(c->last.data()), returnsOf(c->last.data())) + (c->newTime ? 4 : 0);
    unsigned wanted = m_current;
    unsigned changed = 0;
    if constexpr (Coder::encodes) {
        wanted = channelOf(record);
        // Of a channel that is not there yet the last point is the last one of all.
        changed = changes(*c, m_channels[wanted] ? *m_channels[wanted] : *c, record);
    }
    changed = layer(Place)->symbol(c->changed[context], changed);
    bool switched = false;
    if ((changed & 64) != 0) {
        wanted = (m_current + layer(Place)->symbol(c->switches, (wanted - m_current - 1) & 3) + 1) & 3;
        if (m_channels[wanted]) {
            switched = true;
        } else {
            const std::string first = c->last + c->further;
            channel(wanted, first.data());
        }
        m_current = wanted;
        c = m_channels[wanted].get();
        c->last[15] = static_cast<char>((byteAt(c->last.data() + 15) & ~0x30u) | wanted << 4);
    }
    const bool newTime = (changed & 16) != 0;
    const unsigned returns = codeReturns(*c, changed, record);
    codePlace(*c, returns, newTime, record);
    codeFields(*c, changed, kindOf(numberOf(c->last.data()), returns), record);
    c->newTime = newTime;
    std::memcpy(record, c->last.data(), pointSize);
    codeFurther(*c, switched, record);
}

template class LayeredPoints<Decoder>;
template class LayeredPoints<Encoder>;

} // namespace io::laz
