#include "core/process/estimation/scan_lines.h"

#include "core/base/mat3.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/cloud_spacing.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace process {

namespace {

using base::Vec3d;

constexpr std::size_t grain = 512, slab = 16 * grain; ///< a tenth of a second where all are sought again
/// The nearest that lie on one line where others are more than four times as far apart as points on them.
constexpr std::size_t ownLine = 8;
/// Of the variance along: across it so many of an even sampling, by chance as it may be, have more in all but one of
/// 400 places, and there the next ones are as near as ever; those of one line, noise included, have less.
constexpr double onLine = 0.05;
/// Neighbours looked at: lines are found beside a line that has up to 30 points to the gap between them.
constexpr std::size_t looked = 80;
constexpr std::size_t leastBeside = 3, keptOfLine = 4;
/// Of the gap, the spacing that supports are made from: at 3.5 spacings they reach 1.75 gaps, over the next line.
constexpr double spacingOfGap = 0.5;
/// Lines on both sides have gaps that differ by no more; what is farther is another part of the model.
constexpr float mostUneven = 2;

/// The direction of the line that a position and its neighbours are on, if they are.
std::optional<Vec3d> lineThrough(std::span<const base::Vec3f> positions, std::uint32_t i,
                                 std::span<const std::uint32_t> row) {
    const auto n = static_cast<double>(row.size() + 1);
    const auto way = [&](std::uint32_t j) {
        return base::cast<double>(positions[j]) - base::cast<double>(positions[i]);
    };
    Vec3d mean;
    for (const std::uint32_t j : row)
        mean += way(j) / n;
    base::Mat3d c = base::outer(mean, mean);
    for (const std::uint32_t j : row)
        c += base::outer(way(j) - mean, way(j) - mean);
    // Most are told without eigenvalues: on a line the sum of the products of two of them is nearly nothing.
    const double trace = c[0][0] + c[1][1] + c[2][2];
    const double pairs = c[0][0] * c[1][1] - c[0][1] * c[1][0] + c[0][0] * c[2][2] - c[0][2] * c[2][0] +
                         c[1][1] * c[2][2] - c[1][2] * c[2][1];
    if (!(trace > 0) || pairs > 2 * onLine * trace * trace)
        return std::nullopt;
    const base::SymmetricEigen<double> eigen = base::symmetricEigen(c);
    if (!(eigen.value[1] < onLine * eigen.value[2]))
        return std::nullopt;
    return eigen.vector[2];
}

/// Whether supports of a spacing bridge both gaps beside the line already, by neighbours that are at hand: most of
/// those that are on a line by chance.
bool isBridged(std::span<const base::Vec3f> positions, std::uint32_t i, const Vec3d& u,
               std::span<const std::uint32_t> row, float spacing) {
    const double reach = static_cast<double>(spacing) / spacingOfGap;
    Vec3d first;
    for (const std::uint32_t j : row) {
        const Vec3d d = base::cast<double>(positions[j]) - base::cast<double>(positions[i]);
        const double along = dot(d, u);
        const Vec3d across = d - u * along;
        if (lengthSq(across) < along * along || lengthSq(d) > reach * reach)
            continue;
        if (first == Vec3d())
            first = across;
        else if (dot(across, first) < 0)
            return true;
    }
    return false;
}

struct Beside {
    std::uint32_t position = 0;
    NeighbourTable::Row row{};
    float spacing = 0;
    base::Vec3f normal;
};

/// One position at a time; working memory of one thread.
class LineRow {
  public:
    LineRow(const Cloud& cloud, std::size_t count, bool normals) : m_cloud(cloud), m_count(count), m_normals(normals) {}

    /// Nothing where no line is beside that of i, which runs along `u`, but as near as what its own spacing bridges.
    std::optional<Beside> at(std::uint32_t i, const Vec3d& u, float spacing) {
        m_cloud.nearest(i, std::min(looked, m_cloud.size() - 1), m_near);
        sort(i, u);
        if (m_sides[0].size() + m_sides[1].size() < leastBeside)
            return std::nullopt;
        Beside out;
        out.position = i;
        out.spacing = static_cast<float>(spacingOfGap) * gap();
        if (out.spacing <= spacing)
            return std::nullopt;
        choose(out.row);
        if (m_normals)
            out.normal = normalAt(i);
        return out;
    }

  private:
    /// The wider one of both sides.
    float gap() const {
        const float near = std::sqrt(m_near.distanceSq[m_sides[0].front()]);
        if (m_sides[1].empty())
            return near;
        const float other = std::sqrt(m_near.distanceSq[m_sides[1].front()]);
        return other <= mostUneven * near ? other : near; // sides come by distance
    }

    /// More across the line than along it is beside it, on the side of the nearest of these or on the other.
    void sort(std::uint32_t i, const Vec3d& u) {
        m_line.clear(), m_sides[0].clear(), m_sides[1].clear();
        const auto positions = m_cloud.positions();
        Vec3d first;
        for (std::uint32_t k = 0; k < m_near.size(); ++k) {
            const Vec3d d = base::cast<double>(positions[m_near.index[k]]) - base::cast<double>(positions[i]);
            const double along = dot(d, u);
            const Vec3d across = d - u * along;
            if (lengthSq(across) < along * along) {
                m_line.push_back(k);
                continue;
            }
            if (m_sides[0].empty())
                first = across;
            m_sides[dot(across, first) < 0 ? 1 : 0].push_back(k);
        }
    }

    /// The nearest of the line and of both sides in turn, by distance.
    void choose(NeighbourTable::Row& row) const {
        std::vector<std::uint32_t> chosen(
            m_line.begin(), m_line.begin() + static_cast<std::ptrdiff_t>(std::min(keptOfLine, m_line.size())));
        for (std::size_t k = 0; chosen.size() < m_count && (k < m_sides[0].size() || k < m_sides[1].size()); ++k)
            for (const auto& side : m_sides)
                if (k < side.size() && chosen.size() < m_count)
                    chosen.push_back(side[k]);
        for (std::size_t k = keptOfLine; chosen.size() < m_count && k < m_line.size(); ++k)
            chosen.push_back(m_line[k]);
        std::sort(chosen.begin(), chosen.end()); // as they were found: nearest first
        for (std::size_t k = 0; k < m_count; ++k)
            row[k] = m_near.index[chosen[std::min(k, chosen.size() - 1)]];
    }

    base::Vec3f normalAt(std::uint32_t i) const {
        NearestRows rows;
        rows.first = i, rows.count = 1, rows.k = m_near.size();
        rows.index = m_near.index, rows.distanceSq = m_near.distanceSq;
        base::Vec3f out;
        planeNormals(m_cloud.positions(), rows, rows.k, &out);
        return out;
    }

    const Cloud& m_cloud;
    std::size_t m_count;
    bool m_normals;
    Neighbours m_near;
    std::vector<std::uint32_t> m_line, m_sides[2]; ///< places among those near
};

} // namespace

std::size_t lookBesideLines(const Cloud& cloud, CloudNeighbours& near, const base::Progress& progress) {
    const std::size_t count = near.table.count();
    if (count < NeighbourTable::most || cloud.size() <= looked)
        return 0;
    std::size_t found = 0;
    for (std::size_t from = 0; from < cloud.size(); from += slab) {
        progress.step(static_cast<double>(from) / static_cast<double>(cloud.size()), "Looking at neighbours");
        const std::size_t size = std::min(slab, cloud.size() - from);
        std::vector<std::vector<Beside>> parts(base::chunkCount(size, grain));
        base::parallelChunks(size, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            LineRow line(cloud, count, !near.normals.empty());
            for (auto i = static_cast<std::uint32_t>(from + begin); i < from + end; ++i) {
                const NeighbourTable::Row row = near.table.row(i);
                const auto u = lineThrough(cloud.positions(), i, std::span(row).first(ownLine));
                if (!u || isBridged(cloud.positions(), i, *u, std::span(row).first(count), near.spacing[i]))
                    continue;
                if (const auto each = line.at(i, *u, near.spacing[i]))
                    parts[chunk].push_back(*each);
            }
        });
        for (const auto& part : parts)
            for (const Beside& each : part) {
                near.table.set(each.position, std::span(each.row).first(count));
                near.spacing[each.position] = each.spacing;
                if (!near.normals.empty())
                    near.normals[each.position] = each.normal;
                ++found;
            }
    }
    return found;
}

} // namespace process
