#include "core/mesh/faces/face_density.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mesh {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double slack = 1e-3;      ///< for what float coordinates round
constexpr double evenEnough = 0.35; ///< spacings differ by so much within a part, over that of its middle
constexpr double sliver = 0.2;      ///< of its length: a triangle's least side, or its height

/// A corner, and where it is in the triangle.
struct Corner {
    Vec3d place;
    float b, c;
};

Corner between(const Corner& one, const Corner& other, double share) {
    const auto s = static_cast<float>(share);
    return {one.place + (other.place - one.place) * share, one.b + (other.b - one.b) * s,
            one.c + (other.c - one.c) * s};
}

/// Halves the longest sides until the spacing is nearly one. Of slivers, halves of one side would be ever thinner and
/// grow in number by more than the sliver is long: both long sides are halved there, which leaves its tip and a strip.
class Cutting {
  public:
    Cutting(const NearSpacings* near, double own, double slope, std::uint32_t triangle, std::vector<FacePart>& out)
        : m_near(near), m_own(own), m_slope(slope), m_triangle(triangle), m_out(out) {}

    void cut(const std::array<Corner, 3>& p) {
        if (ends({p[0], p[1], p[2]}))
            return;
        const auto side = [&](std::size_t k) { return distance(p[k].place, p[(k + 1) % 3].place); };
        std::size_t k = 0; // the longest side begins there
        for (std::size_t i = 1; i < 3; ++i)
            if (side(i) > side(k))
                k = i;
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        const Corner &from = p[k], &to = p[l], &top = p[m];
        const double next = side(l), last = side(m); // from `to` on, and back to `from`
        if (std::min(next, last) < sliver * side(k)) {
            const bool atEnd = next < last; // the tip is where it begins
            const Corner &tip = atEnd ? from : to, &base = atEnd ? to : from;
            const Corner one = between(tip, base, 0.5), two = between(tip, top, 0.5);
            cut(atEnd ? std::array{tip, one, two} : std::array{one, tip, two});
            strip(atEnd ? std::array{one, base, top, two} : std::array{base, one, two, top});
            return;
        }
        const Corner middle = between(from, to, footOf(from, to, top));
        cut({from, middle, top});
        cut({middle, to, top});
    }

  private:
    /// Where a side is cut: in the middle, but below the corner of a flat triangle, which leaves two with short sides.
    static double footOf(const Corner& from, const Corner& to, const Corner& top) {
        const Vec3d way = to.place - from.place, up = top.place - from.place;
        const bool flat = length(cross(way, up)) < sliver * lengthSq(way);
        return flat ? std::clamp(dot(up, way) / lengthSq(way), sliver, 1 - sliver) : 0.5;
    }

    /// Of four corners, long from the first to the second and from the third to the fourth.
    void strip(const std::array<Corner, 4>& p) {
        if (ends({p[0], p[1], p[2], p[3]}))
            return;
        if (distance(p[0].place, p[3].place) + distance(p[1].place, p[2].place) > distance(p[0].place, p[1].place)) {
            cut({p[0], p[1], p[2]});
            cut({p[0], p[2], p[3]});
            return;
        }
        const Corner one = between(p[0], p[1], 0.5), two = between(p[3], p[2], 0.5);
        strip({p[0], one, two, p[3]});
        strip({one, p[1], p[2], two});
    }

    /// What has nearly one spacing becomes a part.
    bool ends(std::initializer_list<Corner> p) {
        base::CancelScope::check();
        Vec3d middle;
        for (const Corner& each : p)
            middle += each.place / static_cast<double>(p.size());
        double radiusSq = 0;
        for (const Corner& each : p)
            radiusSq = std::max(radiusSq, distanceSq(each.place, middle));
        const double varies = m_slope * std::sqrt(radiusSq), nobodyAsks = m_own + varies;
        const double asked = m_near ? m_near->at(middle, nobodyAsks) : nobodyAsks, spacing = std::min(m_own, asked);
        const bool even = asked >= nobodyAsks;
        if (!even && varies > evenEnough * spacing)
            return false;
        const Corner* const c = p.begin();
        for (std::size_t k = 2; k < p.size(); ++k) {
            FacePart part{m_triangle, {c[0].b, c[k - 1].b, c[k].b}, {c[0].c, c[k - 1].c, c[k].c}};
            part.even = even;
            part.most = even ? m_own : std::min(m_own, spacing + (1 + slack) * varies);
            part.weight = length(cross(c[k - 1].place - c[0].place, c[k].place - c[0].place)) / 2 / (spacing * spacing);
            m_out.push_back(part);
        }
        return true;
    }

    const NearSpacings* m_near; ///< null: nobody asks for less
    double m_own, m_slope;
    std::uint32_t m_triangle;
    std::vector<FacePart>& m_out;
};

} // namespace

FaceDensity::FaceDensity(const FaceTopology& topology, std::span<const Vec3f> positions, std::vector<double> spacings,
                         std::vector<SpacedPlace> places, double slope)
    : m_topology(topology), m_positions(positions), m_spacings(std::move(spacings)),
      m_least(*std::min_element(m_spacings.begin(), m_spacings.end())) {
    for (const SpacedPlace& each : places)
        m_least = std::min(m_least, each.spacing);
    if (!places.empty())
        m_near.emplace(std::move(places), slope);
    cut(slope);
}

double FaceDensity::at(const Vec3d& place, std::uint32_t triangle) const {
    return near(place, m_spacings[m_topology.pieces[triangle]]);
}

double FaceDensity::at(const Vec3d& place, const FacePart& part) const {
    return m_near && !part.even ? m_near->at(place, part.most) : part.most;
}

void FaceDensity::cut(double slope) {
    constexpr std::size_t grain = 256;
    std::vector<std::vector<FacePart>> found(base::chunkCount(m_topology.triangles.size(), grain));
    base::parallelChunks(
        m_topology.triangles.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t t = begin; t < end; ++t) {
                const auto corner = [&](std::size_t k) {
                    return base::cast<double>(m_positions[m_topology.triangles[t][k]]);
                };
                if (m_topology.areas[t] > 0)
                    Cutting(m_near ? &*m_near : nullptr, m_spacings[m_topology.pieces[t]], slope,
                            static_cast<std::uint32_t>(t), found[chunk])
                        .cut({Corner{corner(0), 0, 0}, Corner{corner(1), 1, 0}, Corner{corner(2), 0, 1}});
            }
        });
    std::size_t count = 0;
    for (const auto& each : found)
        count += each.size();
    m_parts.reserve(count);
    for (std::vector<FacePart>& each : found) {
        m_parts.insert(m_parts.end(), each.begin(), each.end());
        each = {};
    }
}

double FaceDensity::samples(const InnerPlaces* inside) const {
    const FaceDraws draws(m_parts);
    return draws.total() * draws.outerShare(m_topology, m_positions, inside);
}

} // namespace mesh
