#include "app/number_table.h"

#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/number_text.h"
#include "core/io/text_rows.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

namespace app {

using base::Vec3d;

namespace {

constexpr io::RowRules rules{true, true, false};
constexpr std::string_view textExtensions = " xyz txt csv pts asc pwn dat tsv ";

std::string extensionOf(const std::filesystem::path& path) {
    std::string out = path.extension().string();
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out.empty() ? out : out.substr(1);
}

/// Extensions of the table's formats that are no plain columns of numbers.
bool isModel(const std::string& extension) {
    if (extension.empty() || textExtensions.find(" " + extension + " ") != std::string_view::npos)
        return false;
    for (const io::FormatRow& row : io::formatTable()) {
        std::istringstream in(row.extensions);
        for (std::string known; in >> known;)
            if (known == extension)
                return row.read != nullptr;
    }
    return false;
}

std::vector<Vec3d> positionsOf(const io::FileModel& model) {
    std::vector<Vec3d> out;
    out.reserve(model.points.size());
    for (const surfel::Surfel& s : model.points.items)
        out.push_back(base::cast<double>(s.position) + model.origin);
    return out;
}

/// Column by column of one line; errors know where it stands.
class Row {
  public:
    Row(const io::FileBytes& file, const io::TextRows& rows, std::string_view line)
        : m_file(file), m_line(line), m_fields(rows.fields(line)) {}

    double number(std::size_t column, const char* form) const {
        const auto value = column < m_fields.size() ? io::numberOf(m_fields[column]) : std::nullopt;
        if (!value)
            fail(column < m_fields.size() ? "'" + std::string(m_fields[column]) + "' is not a number"
                                          : "the line has too few numbers",
                 form);
        return *value;
    }
    [[noreturn]] void fail(const std::string& what, const char* form) const {
        m_file.failAt(static_cast<std::size_t>(m_line.data() - m_file.bytes().data()), what, form);
    }
    const std::vector<std::string_view>& fields() const { return m_fields; }

  private:
    const io::FileBytes& m_file;
    std::string_view m_line;
    std::vector<std::string_view> m_fields;
};

constexpr const char* pointForm = "each line holds x y z";
constexpr const char* placeForm = "each line holds the numbers that the header t,x,y,z names";
constexpr const char* rayForm = "each line holds the numbers that the header ox,oy,oz,dx,dy,dz names";

bool isHeader(const Row& row) {
    return std::none_of(row.fields().begin(), row.fields().end(),
                        [](std::string_view field) { return io::numberOf(field).has_value(); });
}

/// Numbers of a row, in the order of the names that a header was asked for.
template <std::size_t N>
class NamedColumns {
  public:
    using Names = std::array<std::string_view, N>;

    /// `begin`: what the error tells to begin with where a name is missing.
    NamedColumns(const Row& header, const Names& names, const char* begin) {
        for (std::size_t k = 0; k < N; ++k) {
            const auto& fields = header.fields();
            const auto found = std::find(fields.begin(), fields.end(), names[k]);
            if (found == fields.end())
                header.fail("the column " + std::string(names[k]) + " is missing", begin);
            m_columns[k] = static_cast<std::size_t>(found - fields.begin());
        }
    }
    std::array<double, N> numbers(const Row& row, const char* form) const {
        std::array<double, N> out{};
        for (std::size_t k = 0; k < N; ++k)
            out[k] = row.number(m_columns[k], form);
        return out;
    }

  private:
    std::array<std::size_t, N> m_columns{};
};

constexpr NamedColumns<6>::Names rayNames{"ox", "oy", "oz", "dx", "dy", "dz"};
constexpr NamedColumns<4>::Names placeNames{"t", "x", "y", "z"};

base::Rayd rayOf(const Row& row, const NamedColumns<6>& columns) {
    const auto v = columns.numbers(row, rayForm);
    const base::Rayd ray{{v[0], v[1], v[2]}, base::normalized(Vec3d{v[3], v[4], v[5]})};
    if (!base::isFinite(ray.origin) || ray.direction == Vec3d{})
        row.fail("the ray has no finite origin and direction", rayForm);
    return ray;
}

haptics::TimedPlace placeOf(const Row& row, const NamedColumns<4>& columns, const haptics::Trajectory& before) {
    const auto v = columns.numbers(row, placeForm);
    const haptics::TimedPlace out{v[0], {v[1], v[2], v[3]}};
    if (!std::isfinite(out.time) || !base::isFinite(out.place))
        row.fail("the time and place are not finite", placeForm);
    if (!before.empty() && !(out.time > before.back().time))
        row.fail("the time is not later than that of the row before", "times must ascend");
    return out;
}

/// Rows under a header of names.
template <std::size_t N, class Take>
void forNamedRows(const io::FileBytes& file, const base::Progress& progress,
                  const typename NamedColumns<N>::Names& names, const char* begin, const Take& take) {
    const io::TextRows rows(file, 0, rules, {progress});
    std::optional<NamedColumns<N>> columns;
    rows.forRows(0, [&](std::string_view line) {
        const Row row(file, rows, line);
        if (!columns)
            columns.emplace(row, names, begin);
        else
            take(row, *columns);
        return true;
    });
}

} // namespace

std::vector<Vec3d> readPoints(const std::filesystem::path& path, const base::Progress& progress) {
    if (isModel(extensionOf(path)))
        return positionsOf(io::read(path, progress));
    return readPoints(io::FileBytes(path), progress);
}

std::vector<Vec3d> readPoints(const io::FileBytes& file, const base::Progress& progress) {
    const io::TextRows rows(file, 0, rules, {progress});
    std::vector<Vec3d> out;
    out.reserve(rows.count());
    bool first = true;
    rows.forRows(0, [&](std::string_view line) {
        const Row row(file, rows, line);
        if (!std::exchange(first, false) || !isHeader(row))
            out.push_back({row.number(0, pointForm), row.number(1, pointForm), row.number(2, pointForm)});
        return true;
    });
    if (out.empty())
        file.fail("holds no positions", pointForm);
    return out;
}

std::vector<base::Rayd> readRays(const io::FileBytes& file, const base::Progress& progress) {
    std::vector<base::Rayd> out;
    forNamedRows<6>(file, progress, rayNames, "begin with ox,oy,oz,dx,dy,dz",
                    [&](const Row& row, const NamedColumns<6>& columns) { out.push_back(rayOf(row, columns)); });
    if (out.empty())
        file.fail("holds no rays", "begin with ox,oy,oz,dx,dy,dz and give one ray per line");
    return out;
}

haptics::Trajectory readTrajectory(const io::FileBytes& file, const base::Progress& progress) {
    haptics::Trajectory out;
    forNamedRows<4>(file, progress, placeNames, "begin with t,x,y,z",
                    [&](const Row& row, const NamedColumns<4>& columns) { out.push_back(placeOf(row, columns, out)); });
    if (out.empty())
        file.fail("holds no places", "begin with t,x,y,z and give one place per line");
    return out;
}

} // namespace app
