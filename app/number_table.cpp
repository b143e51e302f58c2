#include "app/number_table.h"

#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/number_text.h"
#include "core/io/text_rows.h"

#include <algorithm>
#include <array>
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
constexpr const char* rayForm = "each line holds the numbers that the header ox,oy,oz,dx,dy,dz names";

bool isHeader(const Row& row) {
    return std::none_of(row.fields().begin(), row.fields().end(),
                        [](std::string_view field) { return io::numberOf(field).has_value(); });
}

using RayColumns = std::array<std::size_t, 6>;

RayColumns columnsOf(const Row& header) {
    constexpr std::array<std::string_view, 6> names{"ox", "oy", "oz", "dx", "dy", "dz"};
    RayColumns out{};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto& fields = header.fields();
        const auto found = std::find(fields.begin(), fields.end(), names[k]);
        if (found == fields.end())
            header.fail("the column " + std::string(names[k]) + " is missing", "begin with ox,oy,oz,dx,dy,dz");
        out[k] = static_cast<std::size_t>(found - fields.begin());
    }
    return out;
}

base::Rayd rayOf(const Row& row, const RayColumns& columns) {
    std::array<double, 6> v{};
    for (std::size_t k = 0; k < v.size(); ++k)
        v[k] = row.number(columns[k], rayForm);
    const base::Rayd ray{{v[0], v[1], v[2]}, base::normalized(Vec3d{v[3], v[4], v[5]})};
    if (!base::isFinite(ray.origin) || ray.direction == Vec3d{})
        row.fail("the ray has no finite origin and direction", rayForm);
    return ray;
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
    const io::TextRows rows(file, 0, rules, {progress});
    std::vector<base::Rayd> out;
    out.reserve(rows.count());
    RayColumns columns{};
    bool first = true;
    rows.forRows(0, [&](std::string_view line) {
        const Row row(file, rows, line);
        if (std::exchange(first, false))
            columns = columnsOf(row);
        else
            out.push_back(rayOf(row, columns));
        return true;
    });
    if (out.empty())
        file.fail("holds no rays", "begin with ox,oy,oz,dx,dy,dz and give one ray per line");
    return out;
}

} // namespace app
