#include "core/cells/local_boolean.h"

#include "core/surface/rays/intersect.h"

namespace cells {

using surface::Evaluationd;
using surface::Need;

namespace {

constexpr int leastSamples = 3;         ///< of a cell that cuts another one off
constexpr double leastSharpness = 0.02; ///< of a crease; with less both sides are nearly the same function

/// How two cells meet by where they are, for those that no surfel has as partners: neighbours of a third one.
Meeting measured(CellSource& source, std::size_t j, std::size_t k) {
    const Meeting known = source.meeting(j, k);
    if (known != Meeting::None)
        return known;
    const Evaluationd &a = source.at(j, Need::Value), &b = source.at(k, Need::Value);
    return dot(a.normal - b.normal, b.centroid - a.centroid) < 0 ? Meeting::Convex : Meeting::Concave;
}

} // namespace

bool cutOff(CellSource& source, std::size_t i, double tolerance) {
    const double level = source.at(i, Need::Value).value;
    std::vector<std::size_t> cuts, keeps;
    for (std::size_t j = 0; j < source.count(); ++j) {
        const Meeting how = j == i ? Meeting::None : source.meeting(i, j);
        if (how == Meeting::None || source.samples(j) < leastSamples)
            continue;
        const Evaluationd& other = source.at(j, Need::Value);
        if (!valid(other))
            continue;
        if (!(source.sharpness(i, j) > leastSharpness))
            continue;
        const double beyond = how == Meeting::Convex ? other.value - level : level - other.value;
        (beyond > tolerance ? cuts : keeps).push_back(j);
    }
    for (const std::size_t cut : cuts) {
        const Meeting how = source.meeting(i, cut);
        const bool excused = std::any_of(keeps.begin(), keeps.end(), [&](std::size_t keep) {
            return source.meeting(i, keep) == how && measured(source, cut, keep) == opposite(how);
        });
        if (!excused)
            return true;
    }
    return false;
}

bool isFace(CellSource& source, std::size_t i, double tolerance) {
    const Evaluationd& at = source.at(i, Need::Gradient);
    return valid(at) && at.offCentre <= surface::maxOffCentre * at.unit &&
           dot(at.normal, at.gradient) >= surface::minSlope && !cutOff(source, i, tolerance) &&
           !source.beyondBoundary();
}

double cutTolerance(double unit, double far) {
    constexpr double ofUnit = 1e-11, rounding = 16 * std::numeric_limits<double>::epsilon();
    return ofUnit * unit + rounding * far;
}

} // namespace cells
