#include "core/io/las/las_thinning.h"

#include "core/base/cells.h"
#include "core/base/hash.h"
#include "core/io/las/las_blocks.h"

#include <algorithm>
#include <array>
#include <cstring>
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
    explicit Thinning(LasBlocks records) : m_records(std::move(records)), m_kept(m_records.scale(), 1) {}

    ThinnedLas run(double spacing, std::uint64_t memory, const base::Progress& progress) {
        constexpr std::uint64_t perKept = 256; // here, and once it is opened
        m_kept = Kept(m_records.scale(), spacing);
        const std::uint64_t most = memory / (perKept + m_records.stride());
        const std::uint64_t atOnce = std::max<std::uint64_t>(1024, memory / 2 / sizeof(Turn));
        m_passes = static_cast<int>((m_records.size() + atOnce - 1) / atOnce);
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
                                      m_records.path().string(), "thin to a larger spacing, or give more --memory");
            }
        }
        return {content(progress), m_records.size(), m_kept.size(), m_passes};
    }

  private:
    static constexpr std::size_t block = 65536; // turns between two reports

    double doneAfter(int pass, double part) const { return 0.9 * (pass + part) / m_passes; }

    /// Those whose chance falls into a pass, but for those that are near one that stays already.
    std::vector<Turn> turnsOf(int pass, const base::Progress& progress) const {
        std::vector<Turn> out;
        const std::uint64_t passes = static_cast<std::uint64_t>(m_passes), points = m_records.size();
        out.reserve(std::min(points, points / passes + points / (8 * passes) + 1024)); // growing takes more
        // By chance; of points in one place only the first may stay: a scan may have most of its points at zero.
        std::vector<std::optional<Grid>> seen(std::size_t(1) << 16);
        const auto share = static_cast<double>(m_passes) * 0x1p-64;
        m_records.forEach(
            progress, doneAfter(pass, 0), doneAfter(pass, 0.5), [&](std::uint64_t number, const char* record) {
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
        std::string out = m_records.head();
        out.reserve(out.size() + records.size() * m_records.stride());
        std::size_t next = 0;
        m_records.forEach(progress, 0.9, 1, [&](std::uint64_t number, const char* record) {
            if (next < records.size() && records[next] == number)
                out.append(record, m_records.stride()), ++next;
        });
        put(out, 107, static_cast<std::uint32_t>(records.size()));
        return out;
    }

    LasBlocks m_records;
    Kept m_kept;
    int m_passes = 1;
};

} // namespace

std::optional<ThinnedLas> thinnedLas(const std::filesystem::path& path, double spacing, std::uint64_t memory,
                                     const base::Progress& progress) {
    std::optional<LasBlocks> records = LasBlocks::open(path);
    if (!records)
        return {};
    return Thinning(std::move(*records)).run(spacing, memory, progress);
}

} // namespace io
