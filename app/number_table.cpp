#include "app/number_table.h"

#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/named_rows.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace app {

using base::Vec3d;
using io::NamedColumns;
using Row = io::NumberRow;

namespace {

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

constexpr const char* pointForm = "each line holds x y z";
constexpr const char* rayForm = "each line holds the numbers that the header ox,oy,oz,dx,dy,dz names";

constexpr NamedColumns<6>::Names rayNames{"ox", "oy", "oz", "dx", "dy", "dz"};

base::Rayd rayOf(const Row& row, const NamedColumns<6>& columns) {
    const auto v = columns.numbers(row, rayForm);
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
    const io::TextRows rows = io::namedRows(file, progress);
    std::vector<Vec3d> out;
    out.reserve(rows.count());
    bool first = true;
    rows.forRows(0, [&](std::string_view line) {
        const Row row(file, rows, line);
        if (!std::exchange(first, false) || !row.isHeader())
            out.push_back({row.number(0, pointForm), row.number(1, pointForm), row.number(2, pointForm)});
        return true;
    });
    if (out.empty())
        file.fail("holds no positions", pointForm);
    return out;
}

std::vector<base::Rayd> readRays(const io::FileBytes& file, const base::Progress& progress) {
    std::vector<base::Rayd> out;
    io::forNamedRows<6>(file, progress, rayNames, "begin with ox,oy,oz,dx,dy,dz",
                        [&](const Row& row, const NamedColumns<6>& columns) { out.push_back(rayOf(row, columns)); });
    if (out.empty())
        file.fail("holds no rays", "begin with ox,oy,oz,dx,dy,dz and give one ray per line");
    return out;
}

} // namespace app
