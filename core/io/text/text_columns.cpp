#include "core/io/text/text_columns.h"

#include "core/base/parallel.h"
#include "core/io/file_name.h"

#include <algorithm>
#include <cmath>

namespace io {

static constexpr std::size_t grain = 1 << 14;

std::vector<ColumnFacts> columnFacts(const double* values, std::size_t n, std::size_t columns) {
    const std::size_t chunks = base::chunkCount(n, grain);
    std::vector<ColumnFacts> parts(chunks * columns);
    base::parallelChunks(n, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        ColumnFacts* const facts = parts.data() + chunk * columns;
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t c = 0; c < columns; ++c) {
                const double value = values[i * columns + c];
                if (!std::isfinite(value))
                    continue;
                facts[c].integers = facts[c].integers && value == std::nearbyint(value);
                facts[c].least = std::min(facts[c].least, value);
                facts[c].most = std::max(facts[c].most, value);
            }
    });
    std::vector<ColumnFacts> out(columns);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        for (std::size_t c = 0; c < columns; ++c) {
            const ColumnFacts& part = parts[chunk * columns + c];
            out[c].integers = out[c].integers && part.integers;
            out[c].least = std::min(out[c].least, part.least);
            out[c].most = std::max(out[c].most, part.most);
        }
    return out;
}

surfel::ScalarType typeOf(const ColumnFacts& facts) {
    using surfel::ScalarType;
    const double reach = std::max(-facts.least, facts.most);
    if (!facts.integers)
        return reach > 1e5 ? ScalarType::Float64 : ScalarType::Float32;
    if (reach <= 2147483647.0)
        return ScalarType::Int32;
    return facts.least >= 0 && facts.most <= 4294967295.0 ? ScalarType::UInt32 : ScalarType::Float64;
}

int mostLikeColours(std::span<const ColumnFacts> facts) {
    double most = 0;
    for (const ColumnFacts& each : facts) {
        if (!each.isByte())
            return 0;
        most = std::max(most, each.most);
    }
    return most > 1 ? static_cast<int>(most) : 0;
}

namespace {

/// Names columns from the left.
class Guess {
  public:
    /// From column `first` on.
    Guess(const double* values, std::size_t n, std::span<const ColumnFacts> facts, std::size_t first)
        : m_values(values), m_rows(n), m_facts(facts), m_first(first), m_names(facts.size()) {}

    std::vector<std::string> names() {
        name(m_first, {"x", "y", "z"});
        const std::size_t end = m_facts.size();
        if (columns() == 7 && areColours(m_first + 4) && !areNormals(m_first + 3))
            nameColours(m_first + 4);
        for (std::size_t c = m_first + 3; c < end; ++c) {
            if (!m_names[c].empty())
                continue;
            if (!m_hasNormals && isFree(c) && areNormals(c))
                m_hasNormals = name(c, {"nx", "ny", "nz"});
            else if (!m_hasColours && isFree(c) && areColours(c))
                nameColours(c);
            else
                nameSingle(c);
        }
        return std::move(m_names);
    }

  private:
    std::size_t columns() const { return m_facts.size() - m_first; }
    bool isFree(std::size_t c) const {
        return c + 3 <= m_names.size() && m_names[c + 1].empty() && m_names[c + 2].empty();
    }
    bool name(std::size_t c, std::initializer_list<const char*> names) {
        std::copy(names.begin(), names.end(), m_names.begin() + static_cast<std::ptrdiff_t>(c));
        return true;
    }
    void nameColours(std::size_t c) { m_hasColours = name(c, {"red", "green", "blue"}); }
    void nameSingle(std::size_t c) {
        const bool single = columns() == 4 || columns() == 7;
        m_names[c] = single ? "intensity" : "column_" + std::to_string(c + 1);
    }
    bool areColours(std::size_t c) const {
        const auto facts = m_facts.subspan(c, 3);
        return std::all_of(facts.begin(), facts.end(), [](const ColumnFacts& f) { return f.isByte(); }) ||
               std::all_of(facts.begin(), facts.end(), [](const ColumnFacts& f) { return f.isShare(); });
    }
    /// Of the rows that are not zero (unknown normals), at least half of all, 19 of 20 have length 1 to the two digits
    /// that some programs write.
    bool areNormals(std::size_t c) const {
        const std::size_t step = std::max<std::size_t>(1, m_rows / 4096);
        std::size_t seen = 0, known = 0, unit = 0;
        for (std::size_t i = 0; i < m_rows; i += step, ++seen) {
            const double* v = m_values + i * m_facts.size() + c;
            const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            known += length != 0 ? 1 : 0;
            unit += std::abs(length - 1) < 0.01 ? 1 : 0;
        }
        return known * 2 >= seen && unit * 20 >= known * 19;
    }

    const double* m_values;
    std::size_t m_rows;
    std::span<const ColumnFacts> m_facts;
    std::size_t m_first;
    std::vector<std::string> m_names;
    bool m_hasNormals = false, m_hasColours = false;
};

} // namespace

std::vector<std::string> guessNames(const double* values, std::size_t n, std::span<const ColumnFacts> facts) {
    const std::size_t first = firstCounts(values, n, facts) ? 1 : 0;
    std::vector<std::string> out = Guess(values, n, facts, first).names();
    if (first > 0)
        out[0] = "number";
    return out;
}

bool firstCounts(const double* values, std::size_t n, std::span<const ColumnFacts> facts) {
    constexpr std::size_t least = 4, many = 16;
    if (facts.size() < 4 || n < least || !facts[0].integers)
        return false;
    // Numbers of most files fall within their first rows, and no others are looked at.
    const std::size_t chunks = base::chunkCount(n - 1, grain);
    std::vector<unsigned char> rises(chunks, 1), counts(chunks, 1);
    const auto look = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end && rises[chunk]; ++i) {
            const double step = values[(i + 1) * facts.size()] - values[i * facts.size()];
            rises[chunk] = step > 0 ? 1 : 0; // and not, where one is nan
            counts[chunk] &= step == 1 ? 1 : 0;
        }
    };
    look(0, std::min(n - 1, many), 0);
    if (!rises[0])
        return false;
    base::parallelChunks(n - 1, grain, look);
    const auto all = [](const std::vector<unsigned char>& each) {
        return std::find(each.begin(), each.end(), 0) == each.end();
    };
    return all(rises) && (n >= many || all(counts));
}

/// "X [m]" and "x(m)" are "x".
static std::string plainName(const std::string& name) {
    const std::string whole = lowerCase(name);
    const std::size_t first = whole.find_first_not_of(" \t");
    if (first == std::string::npos)
        return {};
    const std::string bare = whole.substr(first, whole.find_first_of("([", first) - first);
    return bare.substr(0, bare.find_last_not_of(" \t_") + 1);
}

std::optional<std::array<std::size_t, 3>> coordinatesAmong(std::span<const std::string> names) {
    // The most usual first, which counts where a file has several.
    static constexpr std::string_view known[3][15] = {
        {"x", "x_m", "xcoord", "x_coord", "pos_x", "position_x", "point_x", "easting", "east", "e", "rechtswert",
         "points:0"},
        {"y", "y_m", "ycoord", "y_coord", "pos_y", "position_y", "point_y", "northing", "north", "n", "hochwert",
         "points:1"},
        {"z", "z_m", "zcoord", "z_coord", "pos_z", "position_z", "point_z", "elevation", "height", "h", "altitude",
         "up", "points:2", "h\xc3\xb6he", "h\xf6he"},
    };
    std::array<std::size_t, 3> out{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto has = [&](std::string_view wanted) {
            const auto at = std::find_if(names.begin(), names.end(),
                                         [&](const std::string& name) { return plainName(name) == wanted; });
            out[axis] = static_cast<std::size_t>(at - names.begin());
            return at != names.end();
        };
        if (std::none_of(std::begin(known[axis]), std::end(known[axis]), has))
            return std::nullopt;
    }
    return out;
}

} // namespace io
