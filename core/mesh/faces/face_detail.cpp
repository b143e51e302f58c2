#include "core/mesh/faces/face_detail.h"

#include "core/base/cancel_scope.h"
#include "core/base/cells.h"
#include "core/base/mat3.h"
#include "core/base/parallel.h"
#include "core/base/parallel_sort.h"
#include "core/mesh/faces/face_scraps.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace mesh {

using base::Mat3d;
using base::Vec3d;
using base::Vec3f;

namespace {

/// Of normals spread evenly over the 15 degrees that they may turn within a spacing: their deviation.
const double resolvedBend = std::numbers::pi / 12 / std::sqrt(12.0);
constexpr double ofWidth = 0.7;       ///< of a triangle's width: two samples on a square of two, nearly one on each
constexpr double finest = 1.0 / 16;   ///< of a piece's spacing
constexpr double roundTriangle = 1.2; ///< of its width: sides of one that need not be cut
constexpr double sparse = 0.1;        ///< of a cell's side squared: less area in it tells little
constexpr double nearlyAsFine = 0.85; ///< of the piece's spacing: not worth a place

struct Entry {
    std::uint64_t cell;
    std::uint32_t patch, scrap;
    bool operator<(const Entry& o) const {
        return patch != o.patch ? patch < o.patch : cell != o.cell ? cell < o.cell : scrap < o.scrap;
    }
};

class Detail {
  public:
    Detail(const FaceTopology& topology, std::span<const Vec3f> positions, std::span<const double> spacings)
        : m_topology(topology), m_positions(positions), m_spacings(spacings) {
        m_widths.resize(topology.triangles.size());
        for (std::size_t t = 0; t < m_widths.size(); ++t) {
            double longest = 0;
            for (std::size_t k = 0; k < 3; ++k)
                longest = std::max(longest, distance(corner(t, k), corner(t, (k + 1) % 3)));
            m_widths[t] = longest > 0 ? 2 * topology.areas[t] / longest : 0;
            m_any = m_any || (topology.areas[t] > 0 && ofWidth * m_widths[t] < nearlyAsFine * spacingOf(t));
        }
    }

    std::vector<SpacedPlace> run(std::span<const std::uint32_t> patches) {
        std::vector<SpacedPlace> out;
        if (!m_any)
            return out;
        cutAll();
        std::vector<Entry> entries(m_scraps.size());
        base::parallelFor(entries.size(), 4096, [&](std::size_t i) {
            const std::uint32_t t = m_scraps[i].triangle;
            entries[i] = {base::cellOf(base::cast<double>(m_scraps[i].place), {}, 1 / spacingOf(t)).key(), patches[t],
                          static_cast<std::uint32_t>(i)};
        });
        base::parallelSort(entries, std::less<>{});
        std::vector<std::size_t> first;
        for (std::size_t i = 0; i < entries.size(); ++i)
            if (i == 0 || entries[i].patch != entries[i - 1].patch || entries[i].cell != entries[i - 1].cell)
                first.push_back(i);
        std::vector<std::vector<SpacedPlace>> found(base::chunkCount(first.size(), 256));
        base::parallelChunks(first.size(), 256, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            std::vector<Scrap> scraps;
            for (std::size_t c = begin; c < end; ++c) {
                base::CancelScope::check();
                scraps.clear();
                const std::size_t last = c + 1 < first.size() ? first[c + 1] : entries.size();
                for (std::size_t i = first[c]; i < last; ++i)
                    scraps.push_back(m_scraps[entries[i].scrap]);
                const double side = spacingOf(scraps.front().triangle);
                const Vec3d p = base::cast<double>(scraps.front().place);
                Vec3d lo;
                for (std::size_t k = 0; k < 3; ++k)
                    lo[k] = std::floor(p[k] / side) * side;
                look(scraps, lo, side, side, found[chunk]);
            }
        });
        for (const std::vector<SpacedPlace>& each : found)
            out.insert(out.end(), each.begin(), each.end());
        return out;
    }

  private:
    Vec3d corner(std::size_t t, std::size_t k) const {
        return base::cast<double>(m_positions[m_topology.triangles[t][k]]);
    }
    double spacingOf(std::size_t t) const { return m_spacings[m_topology.pieces[t]]; }

    void cutAll() {
        std::vector<double> sizes(m_widths.size());
        for (std::size_t t = 0; t < sizes.size(); ++t)
            sizes[t] = roundTriangle * std::clamp(m_widths[t], finest * spacingOf(t), spacingOf(t));
        m_scraps = scrapsOf(m_topology, m_positions, sizes);
    }

    /// What a cell asks for, or the cells that it is halved into.
    void look(std::span<Scrap> scraps, const Vec3d& lo, double side, double spacing,
              std::vector<SpacedPlace>& out) const {
        double area = 0, width = 0;
        Vec3d middle;
        Mat3d axes;
        for (const Scrap& each : scraps) {
            const auto a = static_cast<double>(each.area);
            const Vec3d& n = m_topology.normals[each.triangle];
            area += a;
            width += a * m_widths[each.triangle];
            middle += base::cast<double>(each.place) * a;
            axes += outer(n, n) * a;
        }
        if (!(area > sparse * side * side))
            return;
        width /= area;
        const double bend = std::sqrt(std::max(0.0, base::symmetricEigen(axes).value[1] / area));
        const double wanted = std::max(ofWidth * width, bend > 0 ? side * resolvedBend / bend : spacing);
        if (bend <= resolvedBend || side / 2 < std::max(ofWidth * width, finest * spacing)) {
            if (wanted < nearlyAsFine * spacing)
                out.push_back({middle / area, std::max(wanted, finest * spacing), side / 2});
            return;
        }
        const Vec3d half = lo + Vec3d{side, side, side} / 2;
        const auto split = [&](std::span<Scrap> some, std::size_t k) {
            const auto middleOf = std::stable_partition(some.begin(), some.end(), [&](const Scrap& each) {
                return static_cast<double>(each.place[k]) < half[k];
            });
            const auto below = static_cast<std::size_t>(middleOf - some.begin());
            return std::pair(some.first(below), some.subspan(below));
        };
        for (std::size_t octant = 0; octant < 8; ++octant) {
            std::span<Scrap> part = scraps;
            Vec3d corner = lo;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [below, above] = split(part, k);
                const bool up = (octant >> k & 1) != 0;
                part = up ? above : below;
                corner[k] = up ? half[k] : lo[k];
            }
            if (!part.empty())
                look(part, corner, side / 2, spacing, out);
        }
    }

    const FaceTopology& m_topology;
    std::span<const Vec3f> m_positions;
    std::span<const double> m_spacings;
    std::vector<double> m_widths; ///< of triangles: the least of their heights
    bool m_any = false;           ///< is any triangle fine enough to ask for more?
    std::vector<Scrap> m_scraps;
};

} // namespace

std::vector<SpacedPlace> detailedPlaces(const FaceTopology& topology, std::span<const Vec3f> positions,
                                        std::span<const double> spacings, std::span<const std::uint32_t> patches) {
    return Detail(topology, positions, spacings).run(patches);
}

} // namespace mesh
