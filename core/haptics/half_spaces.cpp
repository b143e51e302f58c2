#include "core/haptics/half_spaces.h"

#include "core/base/mat3.h"

#include <algorithm>
#include <array>

namespace haptics {

using base::Vec3d;

namespace {

constexpr double leastDeterminant = 1e-9; ///< of cosines: planes that are parallel, or three about one line
constexpr double rounding = 1e-12;        ///< relative to the lengths that occur

/// Planes that hold the place; the others do not touch it.
struct ActiveSet {
    std::array<const HalfSpace*, 3> planes{};
    int count = 0;

    /// Nearest to `goal` on all planes at once, if each of them pushes and none pulls.
    std::optional<Vec3d> nearest(const Vec3d& goal) const {
        base::Mat3d cosines = base::Mat3d::identity();
        Vec3d missing;
        for (int i = 0; i < count; ++i) {
            const auto row = static_cast<std::size_t>(i);
            missing[row] = planes[row]->offset - dot(planes[row]->normal, goal);
            for (int j = 0; j < count; ++j)
                cosines[i][j] = dot(planes[row]->normal, planes[static_cast<std::size_t>(j)]->normal);
        }
        if (!(determinant(cosines) > leastDeterminant))
            return std::nullopt;
        const Vec3d push = inverse(cosines) * missing;
        Vec3d out = goal;
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            if (push[i] < 0)
                return std::nullopt;
            out += planes[i]->normal * push[i];
        }
        return out;
    }
};

bool allHold(std::span<const HalfSpace> spaces, const Vec3d& q, double slack) {
    return std::all_of(spaces.begin(), spaces.end(),
                       [&](const HalfSpace& s) { return dot(s.normal, q) >= s.offset - slack; });
}

/// Sets with further planes from `first` on, the smaller sets first.
std::optional<Vec3d> search(std::span<const HalfSpace> spaces, const Vec3d& goal, double slack, ActiveSet set,
                            std::size_t first, int more) {
    if (more == 0) {
        const std::optional<Vec3d> q = set.nearest(goal);
        return q && allHold(spaces, *q, slack) ? q : std::nullopt;
    }
    for (std::size_t i = first; i < spaces.size(); ++i) {
        ActiveSet larger = set;
        larger.planes[static_cast<std::size_t>(larger.count++)] = &spaces[i];
        if (const auto q = search(spaces, goal, slack, larger, i + 1, more - 1))
            return q;
    }
    return std::nullopt;
}

} // namespace

std::optional<Vec3d> nearestIn(std::span<const HalfSpace> spaces, const Vec3d& goal) {
    double size = length(goal);
    for (const HalfSpace& s : spaces)
        size = std::max(size, std::abs(s.offset));
    for (int count = 0; count <= 3; ++count)
        if (const auto q = search(spaces, goal, rounding * size, {}, 0, count))
            return q;
    return std::nullopt;
}

} // namespace haptics
