#include "core/cells/creases/point_normals.h"

#include "core/base/mat3.h"
#include "core/base/parallel.h"
#include "core/base/ranked.h"

#include <algorithm>
#include <cmath>

namespace cells {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr std::size_t few = 14, many = SurfelLinks::nearCount; ///< neighbours of a plane, by the noise
constexpr float otherWall = -0.3f;                             ///< cosine: beyond it a neighbour is on another wall
constexpr double muchNoise = 0.1;                              ///< spacings
constexpr double exactest = 0.02;                              ///< spacings: planes do not fit better than that
constexpr double tolerance = 0.25, noiseTolerance = 2;         ///< spacings: how far from a point its plane passes
constexpr int passes = 8;
constexpr double smoothReach = 2.5;  ///< spacings
constexpr double smoothSigma = 0.35; ///< of the difference of unit normals

struct Plane {
    Vec3d middle, normal;
    double spread = 0; ///< mean squared distance of its points
};

Plane planeOf(const SurfelLinks& links, std::uint32_t i, std::size_t count) {
    const Vec3f own = links.surfel(i).normal;
    Plane out;
    const auto forMembers = [&](const auto& fn) {
        fn(links.at(i));
        std::size_t taken = 0;
        for (const std::uint32_t j : links.near(i))
            if (taken < count && dot(links.surfel(j).normal, own) > otherWall) {
                fn(links.at(j));
                ++taken;
            }
        return static_cast<double>(taken + 1);
    };
    const double members = forMembers([&](const Vec3d& p) { out.middle += p; });
    out.middle = out.middle / members;
    base::Mat3d sums;
    forMembers([&](const Vec3d& p) { sums += base::outer(p - out.middle, p - out.middle); });
    const base::SymmetricEigen<double> eigen = base::symmetricEigen(sums * (1 / members));
    out.normal = eigen.vector[0];
    if (dot(out.normal, base::cast<double>(own)) < 0)
        out.normal = -out.normal;
    out.spread = std::max(eigen.value[0], 0.0);
    return out;
}

std::vector<Plane> planes(const SurfelLinks& links, std::size_t count) {
    std::vector<Plane> out(links.size());
    base::parallelFor(out.size(), 256,
                      [&](std::size_t i) { out[i] = planeOf(links, static_cast<std::uint32_t>(i), count); });
    return out;
}

/// The root of the lower quartile: that of places without edges and bends.
double noiseOf(const SurfelLinks& links, const std::vector<Plane>& planes) {
    std::vector<double> spreads(planes.size());
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double s = links.spacing(static_cast<std::uint32_t>(i));
        spreads[i] = planes[i].spread / (s * s);
    }
    return std::sqrt(base::ranked(spreads, spreads.size() / 4));
}

/// The normal of that neighbour whose plane passes the point and fits its own neighbours best. Its side is the
/// neighbour's: at acute edges that of the point's own normal, which the edge has smeared, is anybody's guess.
Vec3d bestNormal(const SurfelLinks& links, const std::vector<Plane>& planes, std::uint32_t i, std::size_t count,
                 double noise) {
    const double s = links.spacing(i), within = (tolerance + noiseTolerance * noise) * s;
    const double floor = (noise * noise / 4 + exactest * exactest) * s * s;
    const Vec3d p = links.at(i);
    Vec3d out = planes[i].normal;
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](std::uint32_t j) {
        const Plane& plane = planes[j];
        const double off = std::abs(dot(plane.normal, p - plane.middle));
        const double cost =
            (plane.spread + floor) * (1 + 0.15 * base::distanceSq(links.at(j), p) / (s * s)) + 0.5 * off * off;
        if (off < within && cost < least) {
            least = cost;
            out = plane.normal;
        }
    };
    look(i);
    for (const std::uint32_t j : links.near(i).first(std::min(count, links.near(i).size())))
        look(j);
    return out;
}

Vec3d smoothed(const SurfelLinks& links, const std::vector<Vec3d>& normals, std::uint32_t i, double noise) {
    const double s = links.spacing(i), within = (tolerance + noiseTolerance * noise) * s;
    const Vec3d p = links.at(i), n = normals[i];
    Vec3d sum = n;
    for (const std::uint32_t j : links.near(i)) {
        const Vec3d d = links.at(j) - p;
        const double part = lengthSq(d) / (smoothReach * smoothReach * s * s), off = dot(d, n) / within;
        if (!(part < 1))
            break; // they are sorted
        sum += normals[j] * ((1 - part) * (1 - part) *
                             std::exp(-lengthSq(normals[j] - n) / (2 * smoothSigma * smoothSigma) - off * off / 2));
    }
    return base::normalized(sum);
}

} // namespace

PointNormals pointNormals(const SurfelLinks& links, const base::Progress& progress) {
    PointNormals out;
    if (links.size() == 0)
        return out;
    progress.step(0, "Measuring noise");
    std::vector<Plane> of = planes(links, few);
    std::size_t count = few;
    out.noise = noiseOf(links, of);
    if (out.noise > muchNoise) {
        of = planes(links, many);
        count = many;
        out.noise = noiseOf(links, of);
    }
    progress.step(0.4, "Finding normals beside edges");
    std::vector<Vec3d> normals(links.size()), next(links.size());
    base::parallelFor(links.size(), 256, [&](std::size_t i) {
        normals[i] = bestNormal(links, of, static_cast<std::uint32_t>(i), count, out.noise);
    });
    for (int pass = 0; pass < passes; ++pass) {
        progress.step(0.5 + 0.5 * pass / passes, "Finding normals beside edges");
        base::parallelFor(links.size(), 256, [&](std::size_t i) {
            next[i] = smoothed(links, normals, static_cast<std::uint32_t>(i), out.noise);
        });
        normals.swap(next);
    }
    out.normals.resize(links.size());
    for (std::size_t i = 0; i < links.size(); ++i)
        out.normals[i] = base::cast<float>(normals[i]);
    return out;
}

} // namespace cells
