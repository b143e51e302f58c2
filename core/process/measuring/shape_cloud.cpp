#include "core/process/measuring/shape_cloud.h"

#include "core/base/disjoint_sets.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/process/cleaning/denoise.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/measuring/primitive_step.h"

#include <limits>

namespace process {

using base::Vec3d;

Vec3d normalAt(const Primitive& p, const Vec3d& x) {
    if (p.shape == Shape::Plane)
        return p.axis;
    const Vec3d q = x - p.place;
    if (p.shape == Shape::Sphere)
        return base::normalized(q, {});
    const double along = dot(q, p.axis);
    const Vec3d out = base::normalized(q - p.axis * along, {});
    if (p.shape == Shape::Cylinder)
        return out;
    if (p.shape == Shape::Cone)
        return out * std::cos(p.angle) - p.axis * std::sin(p.angle);
    return base::normalized(q - out * p.radius, {});
}

ShapeCloud::ShapeCloud(const surfel::SurfelList& list, const DetectWish& wish, const base::Progress& progress)
    : m_cosine(std::cos(wish.angleRad)) {
    // Of noise that no neighbour shares three deviations, and what shapes are rounded and bent by between samples.
    constexpr double deviations = 3, spacings = 0.3;
    if (!list.layout->normals)
        throw base::Error("shapes are told by normals, and the model has none", {}, "make them with \"normals\"");
    const Cloud cloud(list.items, part(progress, 0, 0.2));
    if (cloud.size() < 10)
        throw base::Error("no shape is told by fewer than 10 points", {},
                          "there are only " + std::to_string(cloud.size()));
    CloudNeighbours near = neighboursOf(cloud, 0, part(progress, 0.2, 0.6));
    const NoiseLevel noise = wish.tolerance > 0 ? NoiseLevel{} : estimateNoise(cloud, part(progress, 0.6, 1));
    const auto positions = cloud.positions();
    const auto n = static_cast<double>(cloud.size());
    for (const base::Vec3f& x : positions)
        m_centre += base::cast<double>(x) / n;
    double squares = 0, farthest = 0;
    for (const base::Vec3f& x : positions) {
        squares += lengthSq(base::cast<double>(x) - m_centre) / n;
        farthest = std::max(farthest, length(base::cast<double>(x)));
    }
    m_scale = std::sqrt(squares);
    m_points.resize(cloud.size());
    m_room.resize(cloud.size());
    const double finest = 4 * farthest * static_cast<double>(std::numeric_limits<float>::epsilon());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        m_points[i].position = (base::cast<double>(positions[i]) - m_centre) / m_scale;
        const double own = noise.at.empty() ? wish.tolerance
                                            : deviations * static_cast<double>(noise.at[i]) +
                                                  spacings * static_cast<double>(near.spacing[i]);
        m_room[i] = std::max(own, finest) / m_scale;
    }
    const PointPlaces places = cloud.places();
    for (std::size_t k = list.size(); k-- > 0;) { // the first of several in one place has its say
        m_points[places[k]].normal = base::normalized(base::cast<double>(list.items[k].normal), {});
    }
    m_places.resize(list.size());
    for (std::size_t k = 0; k < list.size(); ++k)
        m_places[k] = places[k];
    m_table = std::move(near.table);
}

double ShapeCloud::misfit(const Primitive& p, std::size_t i) const {
    const OrientedPoint& x = m_points[i];
    const double away = std::abs(p.distance(x.position)) / m_room[i];
    if (!(away < 1))
        return std::numeric_limits<double>::infinity();
    const double turned = (1 - std::abs(dot(normalAt(p, x.position), x.normal))) / (1 - m_cosine);
    return std::max(away * away, turned);
}

std::vector<std::uint32_t> ShapeCloud::pieceOn(const Primitive& p, std::span<const std::uint32_t> open) const {
    constexpr std::size_t grain = 4096;
    std::vector<std::uint8_t> on(size(), 0);
    base::parallelFor(open.size(), grain, [&](std::size_t k) { on[open[k]] = misfit(p, open[k]) < 1; });
    base::DisjointSets pieces(size());
    NeighbourTable::Row row;
    for (const std::uint32_t i : open)
        if (on[i])
            for (const std::uint32_t j : near(i, row))
                if (on[j])
                    pieces.join(i, j);
    std::vector<std::uint32_t> count(size(), 0);
    std::uint32_t best = 0;
    for (const std::uint32_t i : open)
        if (on[i])
            ++count[pieces.find(i)];
    for (std::uint32_t i = 1; i < size(); ++i)
        if (count[i] > count[best])
            best = i;
    std::vector<std::uint32_t> out;
    for (const std::uint32_t i : open)
        if (on[i] && pieces.find(i) == best)
            out.push_back(i);
    return out;
}

bool ShapeCloud::bends(const Primitive& p, std::span<const std::uint32_t> points) const {
    Vec3d mean;
    for (const std::uint32_t i : points)
        mean += normalAt(p, m_points[i].position) / static_cast<double>(points.size());
    return length(mean) < 0.5 * (1 + m_cosine); // that of a cap as wide as the angle to its rim
}

Primitive ShapeCloud::fitted(const Primitive& start, std::span<const std::uint32_t> points) const {
    constexpr std::size_t most = 2000;
    constexpr int steps = 12;
    std::vector<Vec3d> some;
    const std::size_t count = std::min(most, points.size());
    for (std::size_t k = 0; k < count; ++k)
        some.push_back(m_points[points[k * points.size() / count]].position);
    return descend(start, some, std::numeric_limits<double>::infinity(), steps);
}

DetectedShape ShapeCloud::told(const Primitive& p, std::span<const std::uint32_t> points) const {
    DetectedShape out{p, points.size(), 0};
    Vec3d middle;
    for (const std::uint32_t i : points) {
        const double d = p.distance(m_points[i].position);
        out.rms += d * d / static_cast<double>(points.size());
        middle += m_points[i].position / static_cast<double>(points.size());
    }
    Primitive& own = out.primitive;
    if (p.shape == Shape::Plane)
        own.place = middle - p.axis * dot(middle - p.place, p.axis);
    else if (p.shape == Shape::Cylinder)
        own.place += p.axis * dot(middle - p.place, p.axis);
    own.place = m_centre + own.place * m_scale;
    own.radius *= m_scale, own.tube *= m_scale;
    out.rms = std::sqrt(out.rms) * m_scale;
    const Vec3d a = own.axis;
    const double largest = std::abs(a.x) >= std::abs(a.y) && std::abs(a.x) >= std::abs(a.z) ? a.x
                           : std::abs(a.y) >= std::abs(a.z)                                 ? a.y
                                                                                            : a.z;
    if (p.shape == Shape::Sphere)
        own.axis = {0, 0, 1};
    else if (p.shape != Shape::Cone && largest < 0)
        own.axis = -own.axis;
    return out;
}

} // namespace process
