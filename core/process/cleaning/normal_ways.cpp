#include "core/process/cleaning/normal_ways.h"

#include "core/base/key_index.h"
#include "core/process/cleaning/local_quadric.h"

namespace process {

using base::Vec3d, base::Vec3f;

std::vector<Vec3f> quadricNormals(const Cloud& cloud, const base::Progress& progress) {
    constexpr std::size_t neighbours = 24;
    std::vector<Vec3f> out(cloud.size(), {0, 0, 1});
    if (cloud.size() <= 3)
        return out;
    cloud.forEach(neighbours, progress, "Estimating normals", [&](std::size_t i, const Neighbours& near) {
        const LocalFrame frame = planeFrame(cloud.positions(), i, near.index, {});
        QuadricSums sums(std::sqrt(static_cast<double>(near.distanceSq.back())));
        sums.add(0, 0, 0);
        for (const std::uint32_t j : near.index)
            sums.add(frame, cloud.positions()[j]);
        out[i] = base::normalized(base::cast<float>(sums.fit().normal(frame)), {0, 0, 1});
    });
    return out;
}

namespace {

/// Points by row and column, and by scan where there are several. Of several at one place in the grid the first counts.
class Grid {
    auto keys() const {
        return [this](std::uint32_t i) { return m_keys[i]; };
    }

  public:
    Grid(const surfel::SurfelList& points, const surfel::Attribute& row, const surfel::Attribute& column,
         const surfel::Attribute* scan)
        : m_keys(points.size()) {
        double rows = 0;
        for (std::size_t i = 0; i < points.size(); ++i)
            rows = std::max(rows, surfel::read(row, points.extraOf(i)) + 2);
        for (std::uint32_t i = 0; i < m_keys.size(); ++i) {
            const double before = scan ? rows * surfel::read(*scan, points.extraOf(i)) : 0; // one above the other
            m_keys[i] = keyOf(before + surfel::read(row, points.extraOf(i)), surfel::read(column, points.extraOf(i)));
            if (m_index.find(m_keys[i], keys()) == base::KeyIndex::none)
                m_index.add(i, keys());
        }
    }
    /// KeyIndex::none where there is no point.
    std::uint32_t beside(std::uint32_t i, int rows, int columns) const {
        return m_index.find(m_keys[i] + (static_cast<std::uint64_t>(rows) << 32) + static_cast<std::uint64_t>(columns),
                            keys());
    }

  private:
    /// Both plus one, so that the place before the first is none.
    static std::uint64_t keyOf(double row, double column) {
        return (static_cast<std::uint64_t>(row + 1) << 32) + static_cast<std::uint64_t>(column + 1);
    }
    std::vector<std::uint64_t> m_keys;
    base::KeyIndex m_index;
};

/// From the point before to the one behind; only to the nearer one where the other is beyond a step in depth.
Vec3d along(const surfel::SurfelList& points, std::uint32_t i, std::uint32_t before, std::uint32_t behind) {
    constexpr double step = 2.5; ///< of distances, from which on the farther one is on another surface
    const auto at = [&](std::uint32_t j) { return base::cast<double>(points.items[j].position); };
    const bool hasBefore = before != base::KeyIndex::none, hasBehind = behind != base::KeyIndex::none;
    const Vec3d back = hasBefore ? at(i) - at(before) : Vec3d(), ahead = hasBehind ? at(behind) - at(i) : Vec3d();
    const double lengthBack = length(back), lengthAhead = length(ahead);
    if (hasBefore && (!hasBehind || lengthAhead > step * lengthBack))
        return back;
    if (hasBehind && (!hasBefore || lengthBack > step * lengthAhead))
        return ahead;
    return back + ahead;
}

} // namespace

std::optional<std::vector<Vec3f>> gridNormals(const surfel::SurfelList& points, const base::Progress& progress) {
    const surfel::Attribute *row = points.layout->find("row"), *column = points.layout->find("column");
    const surfel::Attribute* scan = points.layout->find("scan");
    if (!row || !column || points.items.empty())
        return {};
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const surfel::Attribute* each : {row, column, scan})
            if (const double v = each ? surfel::read(*each, points.extraOf(i)) : 0;
                !(v >= 0 && v < (each == scan ? 1e5 : 1e9)))
                return {};
    progress.step(0, "Estimating normals");
    const Grid grid(points, *row, *column, scan);
    std::vector<Vec3f> out(points.size());
    base::parallelFor(points.size(), 4096, [&](std::size_t n) {
        const auto i = static_cast<std::uint32_t>(n);
        const Vec3d down = along(points, i, grid.beside(i, -1, 0), grid.beside(i, 1, 0));
        const Vec3d across = along(points, i, grid.beside(i, 0, -1), grid.beside(i, 0, 1));
        out[i] = base::cast<float>(base::normalized(cross(down, across)));
    });
    return out;
}

} // namespace process
