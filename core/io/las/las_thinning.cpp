#include "core/io/las/las_thinning.h"

#include "core/base/cells.h"
#include "core/base/error.h"
#include "core/base/hash.h"
#include "core/io/las/las_header.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <tuple>

namespace io {

using base::Cell, base::Vec3d;

namespace {

using Grid = std::array<std::int32_t, 3>; ///< a point's whole numbers

struct Turn {
    std::uint64_t chance, record;
    Grid at;
};

std::uint64_t chanceOf(const Grid& at) {
    std::uint64_t out = 0;
    for (const std::int32_t x : at)
        out = base::mix(out ^ static_cast<std::uint32_t>(x));
    return out;
}

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
}

/// The points that stay so far, in cells as wide as the spacing.
class Kept {
  public:
    /// Cells are no finer than the file's own grid.
    Kept(const Vec3d& scale, double spacing)
        : m_scale(scale), m_spacing(spacing),
          m_side(std::max({spacing, std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)})) {}

    bool isNear(const Grid& at) const {
        const Cell own = cellOf(at);
        bool found = isNearIn(own, at); // most often
        base::forCellsAround(own, [&](const Cell& cell) { found = found || isNearIn(cell, at); });
        return found;
    }
    void add(const Turn& turn) {
        std::uint32_t& first = m_first.at(cellOf(turn.at)); // counted from 1
        m_points.push_back({turn.at, first, turn.record});
        first = static_cast<std::uint32_t>(m_points.size());
    }
    std::size_t size() const { return m_points.size(); }
    /// Numbers of records, ascending.
    std::vector<std::uint64_t> records() const {
        std::vector<std::uint64_t> out;
        for (const Point& p : m_points)
            out.push_back(p.record);
        std::sort(out.begin(), out.end());
        return out;
    }

  private:
    struct Point {
        Grid at;
        std::uint32_t next;
        std::uint64_t record;
    };

    Cell cellOf(const Grid& at) const {
        const Vec3d p{at[0] * m_scale.x, at[1] * m_scale.y, at[2] * m_scale.z};
        return base::cellOf(p, {}, 1 / m_side);
    }
    bool isNearIn(const Cell& cell, const Grid& at) const {
        const std::uint32_t* first = m_first.find(cell);
        for (std::uint32_t k = first ? *first : 0; k != 0; k = m_points[k - 1].next) {
            const Grid& other = m_points[k - 1].at;
            double distanceSq = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double way = (static_cast<double>(at[axis]) - static_cast<double>(other[axis])) * m_scale[axis];
                distanceSq += way * way;
            }
            if (distanceSq < m_spacing * m_spacing)
                return true;
        }
        return false;
    }

    Vec3d m_scale;
    double m_spacing, m_side;
    base::CellMap<std::uint32_t> m_first;
    std::vector<Point> m_points;
};

class Thinning {
  public:
    Thinning(std::filesystem::path path, std::string head, const LasHeader& header, std::uint64_t points)
        : m_path(std::move(path)), m_head(std::move(head)), m_stride(header.stride), m_points(points),
          m_kept(header.scale, 1), m_scale(header.scale) {}

    ThinnedLas run(double spacing, std::uint64_t memory, const base::Progress& progress) {
        constexpr std::uint64_t perKept = 256; // here, and once it is opened
        m_kept = Kept(m_scale, spacing);
        const std::uint64_t most = memory / (perKept + m_stride);
        const std::uint64_t atOnce = std::max<std::uint64_t>(1024, memory / 2 / sizeof(Turn));
        m_passes = static_cast<int>((m_points + atOnce - 1) / atOnce);
        for (int pass = 0; pass < m_passes; ++pass) {
            std::vector<Turn> turns = turnsOf(pass, progress);
            std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
                return std::tie(a.chance, a.record) < std::tie(b.chance, b.record);
            });
            for (std::size_t k = 0; k < turns.size(); ++k) {
                if (k % block == 0)
                    progress.step(doneAfter(pass, 0.5), "Thinning");
                if (!m_kept.isNear(turns[k].at))
                    m_kept.add(turns[k]);
                if (m_kept.size() > most)
                    throw base::Error("more points stay than the memory holds: over " + std::to_string(most),
                                      m_path.string(), "thin to a larger spacing, or give more --memory");
            }
        }
        return {content(progress), m_points, m_kept.size(), m_passes};
    }

  private:
    static constexpr std::size_t block = 65536; // records read at once, at most

    double doneAfter(int pass, double part) const { return 0.9 * (pass + part) / m_passes; }

    /// fn(number, record) for all records.
    template <class Fn>
    void forRecords(const base::Progress& progress, double from, double to, const Fn& fn) const {
        std::ifstream in(m_path, std::ios::binary);
        in.seekg(static_cast<std::streamoff>(m_head.size()));
        const std::size_t atOnce = std::clamp<std::size_t>((std::size_t(1) << 24) / m_stride, 1, block);
        std::vector<char> bytes(std::min<std::uint64_t>(atOnce, m_points) * m_stride);
        for (std::uint64_t first = 0; first < m_points; first += atOnce) {
            progress.step(from + (to - from) * static_cast<double>(first) / static_cast<double>(m_points), "Reading");
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(atOnce, m_points - first));
            if (!in.read(bytes.data(), static_cast<std::streamsize>(count * m_stride)))
                throw base::Error("cannot be read to its end", m_path.string(), "check the disk, and copy it anew");
            for (std::size_t k = 0; k < count; ++k)
                fn(first + k, bytes.data() + k * m_stride);
        }
    }

    /// Those whose chance falls into a pass, but for those that are near one that stays already.
    std::vector<Turn> turnsOf(int pass, const base::Progress& progress) const {
        std::vector<Turn> out;
        const auto passes = static_cast<std::uint64_t>(m_passes);
        out.reserve(std::min(m_points, m_points / passes + m_points / (8 * passes) + 1024)); // growing takes more
        // By chance; of points in one place only the first may stay: a scan may have most of its points at zero.
        std::vector<std::optional<Grid>> seen(std::size_t(1) << 16);
        const auto share = static_cast<double>(m_passes) * 0x1p-64;
        forRecords(progress, doneAfter(pass, 0), doneAfter(pass, 0.5), [&](std::uint64_t number, const char* record) {
            Turn turn{0, number, {}};
            std::memcpy(turn.at.data(), record, sizeof turn.at);
            turn.chance = chanceOf(turn.at);
            const int own = std::min(m_passes - 1, static_cast<int>(static_cast<double>(turn.chance) * share));
            if (own != pass)
                return;
            std::optional<Grid>& last = seen[turn.chance % seen.size()];
            if (last == turn.at)
                return;
            last = turn.at;
            if (pass == 0 || !m_kept.isNear(turn.at))
                out.push_back(turn);
        });
        return out;
    }

    std::string content(const base::Progress& progress) const {
        const std::vector<std::uint64_t> records = m_kept.records();
        std::string out = m_head;
        out.reserve(m_head.size() + records.size() * m_stride);
        std::size_t next = 0;
        forRecords(progress, 0.9, 1, [&](std::uint64_t number, const char* record) {
            if (next < records.size() && records[next] == number)
                out.append(record, m_stride), ++next;
        });
        put(out, 107, static_cast<std::uint32_t>(records.size()));
        return out;
    }

    std::filesystem::path m_path;
    std::string m_head; ///< all before the records
    std::size_t m_stride;
    std::uint64_t m_points;
    Kept m_kept;
    Vec3d m_scale;
    int m_passes = 1;
};

/// The first bytes; fewer where the file ends.
std::string firstBytes(std::ifstream& in, std::size_t count) {
    std::string out(count, '\0');
    in.seekg(0);
    in.read(out.data(), static_cast<std::streamsize>(count));
    out.resize(static_cast<std::size_t>(in.gcount()));
    in.clear();
    return out;
}

} // namespace

std::optional<ThinnedLas> thinnedLas(const std::filesystem::path& path, double spacing, std::uint64_t memory,
                                     const base::Progress& progress) {
    constexpr std::size_t least = 227, newest = 375, mostHead = std::size_t(1) << 28;
    std::error_code unknown;
    const std::uint64_t size = std::filesystem::is_regular_file(path, unknown) ? std::filesystem::file_size(path) : 0;
    if (size < least) // a pipe has bytes once only: they are its reader's
        return {};
    std::ifstream in(path, std::ios::binary);
    std::string head = firstBytes(in, newest);
    if (head.size() < least || !head.starts_with("LASF"))
        return {};
    std::uint32_t pointsAt = 0, legacy = 0;
    std::uint64_t points = 0;
    std::memcpy(&pointsAt, head.data() + 96, 4);
    std::memcpy(&legacy, head.data() + 107, 4);
    if (head.size() >= newest && head[25] >= 4)
        std::memcpy(&points, head.data() + 247, 8);
    points = legacy > 0 ? legacy : points;
    if (pointsAt > size)
        return {};
    head = firstBytes(in, std::min<std::size_t>(pointsAt, mostHead));
    if (head.size() != pointsAt || points == 0 || head.size() < least)
        return {};
    // A file of one record has the same header and passes the same checks.
    std::uint16_t stride = 0;
    std::memcpy(&stride, head.data() + 105, 2);
    std::string one = head + std::string(stride, '\0');
    put(one, 107, std::uint32_t(1));
    const FileBytes small(path, std::move(one));
    LasHeader header;
    try {
        header = parseLasHeader(small);
    } catch (const base::Error&) {
        return {};
    }
    if (header.compressed || header.stride < 12 || points > (size - pointsAt) / header.stride)
        return {};
    return Thinning(path, std::move(head), header, points).run(spacing, memory, progress);
}

} // namespace io
