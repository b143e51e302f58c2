#include "core/io/las/las_tiles.h"

#include "core/io/las/las_points.h"
#include "core/io/safe_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace io {

using base::Vec3d;

namespace {

std::array<std::int32_t, 3> numbersOf(const char* record) {
    std::array<std::int32_t, 3> out;
    std::memcpy(out.data(), record, sizeof out);
    return out;
}

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// How many points are in each field of a board over the file.
class Board {
  public:
    static constexpr int side = 1024;
    std::vector<std::uint32_t> counts = std::vector<std::uint32_t>(std::size_t(side) * side);

    std::uint64_t in(const std::array<int, 4>& range) const { // x from, to, y from, to
        std::uint64_t out = 0;
        for (int y = range[2]; y < range[3]; ++y)
            for (int x = range[0]; x < range[1]; ++x)
                out += counts[static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x)];
        return out;
    }
    /// Halves of about as many points, across the longer side, until none has more than `most`. fn(range) for each.
    template <class Fn>
    void divide(const std::array<int, 4>& range, std::uint64_t most, const Fn& fn) const {
        const std::uint64_t all = in(range);
        const int axis = range[1] - range[0] >= range[3] - range[2] ? 0 : 1;
        const auto from = static_cast<std::size_t>(2 * axis);
        if (all == 0)
            return;
        if (all <= most || range[from + 1] - range[from] < 2)
            return fn(range);
        std::array<int, 4> first = range, second = range;
        std::uint64_t before = 0;
        int cut = range[from];
        while (cut + 1 < range[from + 1] && 2 * before < all) {
            std::array<int, 4> slice = range;
            slice[from] = cut, slice[from + 1] = ++cut;
            before += in(slice);
        }
        first[from + 1] = second[from] = cut;
        divide(first, most, fn), divide(second, most, fn);
    }
};

} // namespace

template <class Box>
static bool within(const Box& box, const std::array<std::int32_t, 3>& at) {
    return at[0] >= box.low[0] && at[0] < box.high[0] && at[1] >= box.low[1] && at[1] < box.high[1];
}

LasTiles::LasTiles(LasBlocks records, std::uint64_t most, const base::Progress& progress)
    : m_records(std::move(records)), m_most(most), m_left(m_records.size()), m_stays(m_records.size(), true) {
    findBounds(progress);
    if (m_records.size() > 0)
        divide(m_bounds, progress, 0.5, 1);
}

void LasTiles::findBounds(const base::Progress& progress) {
    constexpr auto farthest = std::numeric_limits<std::int64_t>::max();
    m_bounds = {{farthest, farthest}, {-farthest, -farthest}};
    std::vector<Vec3d> sample;
    const std::vector<std::uint64_t> places = lasSamplePlaces(m_records.size());
    m_records.forEach(progress, 0, 0.5, [&](std::uint64_t number, const char* record) {
        const auto at = numbersOf(record);
        for (std::size_t k = 0; k < 2; ++k) {
            m_bounds.low[k] = std::min<std::int64_t>(m_bounds.low[k], at[k]);
            m_bounds.high[k] = std::max<std::int64_t>(m_bounds.high[k], at[k] + std::int64_t(1));
        }
        if (sample.size() < places.size() && places[sample.size()] == number) {
            Vec3d p;
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = at[k] * m_records.scale()[k] + m_records.offset()[k];
            sample.push_back(p);
        }
    });
    m_origin = lasOrigin(m_records.scale(), sample, m_records.size());
}

/// A board over far strays has the scan itself in few of its fields: these get a board of their own.
void LasTiles::divide(const Box& bounds, const base::Progress& progress, double from, double to) {
    const std::uint64_t own = std::max<std::uint64_t>(m_most / 3, 1); // the rest is for margins
    Board board;
    std::int64_t field[2];
    for (std::size_t k = 0; k < 2; ++k)
        field[k] = (bounds.high[k] - bounds.low[k] - 1) / Board::side + 1;
    m_records.forEach(progress, from, to, [&](std::uint64_t, const char* record) {
        const auto at = numbersOf(record);
        if (!within(bounds, at))
            return;
        const auto x = static_cast<std::size_t>((at[0] - bounds.low[0]) / field[0]);
        const auto y = static_cast<std::size_t>((at[1] - bounds.low[1]) / field[1]);
        ++board.counts[y * Board::side + x];
    });
    std::vector<Box> crowded;
    board.divide({0, Board::side, 0, Board::side}, own, [&](const std::array<int, 4>& range) {
        Box box{};
        for (std::size_t k = 0; k < 2; ++k) {
            box.low[k] = bounds.low[k] + range[2 * k] * field[k];
            box.high[k] = std::min(bounds.low[k] + range[2 * k + 1] * field[k], bounds.high[k]);
        }
        const bool smaller = std::max(field[0], field[1]) > 1; // than what it is a part of
        (board.in(range) > own && smaller ? crowded : m_tiles).push_back(box);
    });
    for (const Box& box : crowded)
        divide(box, progress, to, to);
}

void LasTiles::drop(std::uint64_t record) {
    m_left -= m_stays[record];
    m_stays[record] = false;
}

/// False where there is no more room.
bool LasTiles::add(LasTile& tile, std::uint64_t number, const char* record, bool own) const {
    if (tile.points.size() >= m_most)
        return false;
    const auto at = numbersOf(record);
    surfel::Surfel s;
    for (std::size_t k = 0; k < 3; ++k)
        s.position[k] = static_cast<float>(at[k] * m_records.scale()[k] + m_records.offset()[k] - m_origin[k]);
    if (!base::isFinite(s.position))
        return true;
    tile.points.items.push_back(s);
    tile.records.push_back(number);
    tile.own.push_back(own);
    return true;
}

std::optional<LasTile> LasTiles::load(const Box& own, double margin, const base::Progress& progress, double from,
                                      double to) const {
    LasTile out;
    Box box = own;
    const Vec3d &scale = m_records.scale(), &offset = m_records.offset();
    for (std::size_t k = 0; k < 2; ++k) {
        const double steps = std::min(std::ceil(margin / std::abs(scale[k])), 1e10);
        box.low[k] -= static_cast<std::int64_t>(steps), box.high[k] += static_cast<std::int64_t>(steps);
        const double a = static_cast<double>(box.low[k]) * scale[k] + offset[k] - m_origin[k];
        const double b = static_cast<double>(box.high[k] - 1) * scale[k] + offset[k] - m_origin[k];
        constexpr float endless = std::numeric_limits<float>::infinity();
        const bool all[2] = {box.low[k] <= m_bounds.low[k], box.high[k] >= m_bounds.high[k]};
        out.low[k] = all[scale[k] < 0] ? -endless : static_cast<float>(std::min(a, b));
        out.high[k] = all[scale[k] > 0] ? endless : static_cast<float>(std::max(a, b));
    }
    bool fits = true;
    m_records.forEach(progress, from, to, [&](std::uint64_t number, const char* record) {
        const auto at = numbersOf(record);
        if (fits && m_stays[number] && within(box, at))
            fits = add(out, number, record, within(own, at));
    });
    return fits ? std::optional(std::move(out)) : std::nullopt;
}

/// All of the tile, and of what is around it an even choice that memory holds.
LasTile LasTiles::among(const Box& own, const std::vector<std::uint64_t>& blind, const base::Progress& progress,
                        double from, double to) const {
    constexpr float endless = std::numeric_limits<float>::infinity();
    LasTile out;
    for (std::size_t k = 0; k < 2; ++k)
        out.low[k] = -endless, out.high[k] = endless;
    const std::uint64_t step = m_left / std::max<std::uint64_t>(m_most / 3, 1) + 1;
    m_records.forEach(progress, from, to, [&](std::uint64_t number, const char* record) {
        const bool inside = within(own, numbersOf(record));
        if (m_stays[number] && (inside || number % step == 0))
            add(out, number, record, inside && std::binary_search(blind.begin(), blind.end(), number));
    });
    return out;
}

std::uint64_t LasTiles::sweep(const Decide& decide, const base::Progress& progress) const {
    constexpr double leastGrowth = 0.1; // each time is a pass over the file
    constexpr double close = 1.5;       // a margin that fits and one that does not
    // Strays are few, and blind among many; else it is the memory that shows too little.
    constexpr std::uint64_t manyBlind = 100, leastSeen = 4096;
    const auto refuse = [this] {
        throw base::Error("a tile and what has to be seen around it are more than the memory holds",
                          m_records.path().string(), "give more --memory");
    };
    const auto all = static_cast<double>(m_tiles.size());
    std::uint64_t chosen = 0;
    for (std::size_t t = 0; t < m_tiles.size(); ++t) {
        const Box& box = m_tiles[t];
        const double from = static_cast<double>(t) / all, to = static_cast<double>(t + 1) / all;
        // A few points' distance on a surface of the tile's size to begin with.
        const double wide = static_cast<double>(box.high[0] - box.low[0]) * std::abs(m_records.scale().x);
        const double high = static_cast<double>(box.high[1] - box.low[1]) * std::abs(m_records.scale().y);
        double margin = 0.02 * std::max(wide, high), fitted = 0, tooWide = std::numeric_limits<double>::infinity();
        for (;;) {
            std::optional<LasTile> tile = load(box, margin, progress, from, to);
            if (!tile) {
                tooWide = margin;
                if (fitted == 0 && (margin *= 0.25) < std::abs(m_records.scale().x))
                    refuse();
            } else {
                fitted = margin;
                const double missing = decide(*tile, LasSight::OfAll).missing;
                if (missing <= 0)
                    break;
                margin += std::max(1.1 * missing, leastGrowth * margin);
            }
            tile.reset();                   // memory for one
            if (tooWide < close * fitted) { // who sees nothing in there is far from everything
                std::vector<std::uint64_t> blind =
                    decide(*load(box, fitted, progress, from, to), LasSight::OfEach).blind;
                std::sort(blind.begin(), blind.end());
                if ((chosen += blind.size()) > m_records.size() / manyBlind + manyBlind || m_most < leastSeen)
                    refuse();
                decide(among(box, blind, progress, from, to), LasSight::OfEach);
                break;
            }
            if (fitted > 0 && margin >= tooWide)
                margin = std::sqrt(fitted * tooWide);
        }
    }
    return chosen;
}

std::string LasTiles::writtenHead(const base::Progress& progress) const {
    std::string out = m_records.head();
    const bool modern = out[25] >= 4, wide = (static_cast<unsigned char>(out[104]) & 0x3f) >= 6;
    std::array<std::uint64_t, 15> returns{};
    std::array<std::int32_t, 3> low{}, high{};
    std::uint64_t count = 0;
    m_records.forEach(progress, 0, 0.5, [&](std::uint64_t number, const char* record) {
        if (!m_stays[number])
            return;
        const auto at = numbersOf(record);
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = count == 0 ? at[k] : std::min(low[k], at[k]);
            high[k] = count == 0 ? at[k] : std::max(high[k], at[k]);
        }
        ++count;
        const unsigned which = static_cast<unsigned char>(record[14]) & (wide ? 15u : 7u);
        if (which >= 1 && which <= (wide ? 15u : 5u))
            ++returns[which - 1];
    });
    const bool small = !wide && count <= 0xffffffffu;
    put(out, 107, static_cast<std::uint32_t>(small ? count : 0));
    for (std::size_t k = 0; k < 5; ++k)
        put(out, 111 + 4 * k, static_cast<std::uint32_t>(small ? returns[k] : 0));
    for (std::size_t k = 0; k < 3; ++k) { // largest, least
        const double a = low[k] * m_records.scale()[k] + m_records.offset()[k];
        const double b = high[k] * m_records.scale()[k] + m_records.offset()[k];
        put(out, 179 + 16 * k, std::max(a, b)), put(out, 187 + 16 * k, std::min(a, b));
    }
    const std::uint64_t gone = (m_records.size() - count) * m_records.stride();
    for (const std::size_t at : {std::size_t(227), std::size_t(235)}) // waveforms, and long records behind the points
        if (std::uint64_t place = 0; (modern || (at == 227 && out[25] == 3)) && out.size() >= at + 8) {
            std::memcpy(&place, out.data() + at, 8);
            if (place >= m_records.head().size() + m_records.size() * m_records.stride())
                put(out, at, place - gone);
        }
    if (modern && out.size() >= 375) {
        put(out, 247, count);
        for (std::size_t k = 0; k < returns.size(); ++k)
            put(out, 255 + 8 * k, returns[k]);
    }
    return out;
}

void LasTiles::write(const std::filesystem::path& path, const base::Progress& progress) const {
    constexpr std::size_t atOnce = std::size_t(1) << 20;
    SafeFile file(path);
    std::string bytes = writtenHead(progress);
    m_records.forEach(progress, 0.5, 1, [&](std::uint64_t number, const char* record) {
        if (m_stays[number])
            bytes.append(record, m_records.stride());
        if (bytes.size() >= atOnce)
            file.write(bytes), bytes.clear();
    });
    file.write(bytes);
    m_records.forTail([&](const std::string& part) { file.write(part); });
    file.commit();
}

} // namespace io
