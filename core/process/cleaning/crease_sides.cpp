#include "core/process/cleaning/crease_sides.h"

#include "core/base/mat3.h"
#include "core/process/estimation/part_progress.h"

#include <algorithm>

namespace process {

using base::Vec3d, base::Vec3f;

namespace {

constexpr std::size_t looked = 50;
/// Standard deviations within which a point is of a plane.
constexpr double reach = 2.2;

/// Of a position and its nearest, relative to it; a plane through one of them and a unit normal.
class Planes {
  public:
    Planes(const Cloud& cloud, std::size_t i, const Neighbours& near, double noise) : m_reach(reach * noise) {
        m_places.push_back({});
        for (const std::uint32_t j : near.index)
            m_places.push_back(base::cast<double>(cloud.positions()[j] - cloud.positions()[i]));
        // What no plane could tell apart, of positions in float.
        m_reach = std::max(m_reach, 1e-3 * length(m_places.back()));
    }
    std::span<const Vec3d> places() const { return m_places; }

    /// How many agree with a plane, those in its middle most.
    double agreement(const Vec3d& point, const Vec3d& normal) const {
        double out = 0;
        for (const Vec3d& q : m_places) {
            const double t = dot(q - point, normal) / m_reach;
            out += std::max(0.0, 1 - t * t);
        }
        return out;
    }
    /// The plane of least squares of those that agree.
    void refine(Vec3d& point, Vec3d& normal) const {
        Vec3d mean;
        double count = 0;
        for (const Vec3d& q : m_places)
            if (std::abs(dot(q - point, normal)) < m_reach)
                mean += q, ++count;
        if (count < 4)
            return;
        mean = mean / count;
        base::Mat3d c;
        for (const Vec3d& q : m_places)
            if (std::abs(dot(q - point, normal)) < m_reach)
                c += base::outer(q - mean, q - mean);
        normal = base::symmetricEigen(c).vector[0], point = mean;
    }
    bool holds(const Vec3d& point, const Vec3d& normal) const {
        return std::abs(dot(point, normal)) < m_reach; // the position itself is the origin
    }

  private:
    std::vector<Vec3d> m_places;
    double m_reach;
};

/// The normal of the face that the position is on: of the planes through it and two of its nearest the one that most
/// agree with, unless the plane of all does as well.
Vec3d faceNormal(const Planes& planes, const Vec3d& given) {
    constexpr std::size_t from = 4, to = 16;
    constexpr double better = 1.1;
    constexpr double clear = 0.68; // of noise alone 0.79 are left
    Vec3d middle;
    const std::span<const Vec3d> places = planes.places();
    for (const Vec3d& q : places)
        middle += q / static_cast<double>(places.size());
    Vec3d normal = given;
    planes.refine(middle, normal);
    double most = planes.holds(middle, normal) ? better * planes.agreement(middle, normal) : 0;
    if (most >= clear * better * static_cast<double>(places.size()))
        return normal;
    Vec3d best = most > 0 ? normal : given;
    for (std::size_t j = from; j < std::min(to, places.size()); ++j)
        for (std::size_t k = j + 1; k < std::min(to, places.size()); ++k) {
            Vec3d n = cross(places[j], places[k]), point;
            if (!(lengthSq(n) > 0.1 * lengthSq(places[j]) * lengthSq(places[k])))
                continue;
            n = n / length(n);
            planes.refine(point, n);
            if (!planes.holds(point, n))
                continue;
            if (const double agreed = planes.agreement(point, n); agreed > most)
                most = agreed, best = n;
        }
    return best;
}

/// In the middle of the widest gap between the angles to the neighbours' normals; -1 where there is none.
float leastCosine(std::vector<double>& angles) {
    constexpr double widest = 0.17;   // 10 degrees: more than noise and curvature leave between 50 of them
    constexpr std::size_t fewest = 3; // on either side
    std::sort(angles.begin(), angles.end());
    double gap = widest, at = -1;
    for (std::size_t k = fewest; k + fewest <= angles.size(); ++k)
        if (angles[k] - angles[k - 1] > gap)
            gap = angles[k] - angles[k - 1], at = (angles[k] + angles[k - 1]) / 2;
    return at < 0 ? -1 : static_cast<float>(std::cos(at));
}

} // namespace

CreaseSides creaseSides(const Cloud& cloud, std::span<const Vec3f> normals, bool oriented, std::span<const float> noise,
                        const base::Progress& progress) {
    CreaseSides out;
    out.normals.assign(normals.begin(), normals.end());
    out.least.assign(cloud.size(), -1);
    if (cloud.size() <= looked)
        return out;
    cloud.forEach(looked, part(progress, 0, 0.7), "Looking for creases", [&](std::size_t i, const Neighbours& near) {
        if (!(noise[i] > 0))
            return;
        const Planes planes(cloud, i, near, static_cast<double>(noise[i]));
        const Vec3f n = base::normalized(base::cast<float>(faceNormal(planes, base::cast<double>(normals[i]))));
        out.normals[i] = dot(n, normals[i]) < 0 ? -n : n;
    });
    cloud.forEach(looked, part(progress, 0.7, 1), "Looking for creases", [&](std::size_t i, const Neighbours& near) {
        std::vector<double> angles;
        for (const std::uint32_t j : near.index) {
            const auto cosine = static_cast<double>(dot(out.normals[i], out.normals[j]));
            angles.push_back(std::acos(std::clamp(oriented ? cosine : std::abs(cosine), -1.0, 1.0)));
        }
        out.least[i] = leastCosine(angles);
    });
    return out;
}

} // namespace process
