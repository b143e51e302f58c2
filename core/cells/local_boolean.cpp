#include "core/cells/local_boolean.h"

#include "core/surface/rays/intersect.h"

namespace cells {

using surface::Evaluationd;
using surface::Need;

namespace {

constexpr double leastSharpness = 0.02; ///< of a crease; with less both sides are nearly the same function

/// How two cells meet by where they are, for those that no surfel has as partners: neighbours of a third one.
Meeting measured(CellSource& source, std::size_t j, std::size_t k) {
    for (const Meeting known : {source.meeting(j, k), source.meeting(k, j)})
        if (known != Meeting::None)
            return known;
    const CellSource::Tangent a = source.tangent(j), b = source.tangent(k);
    return dot(a.normal - b.normal, b.centroid - a.centroid) < 0 ? Meeting::Convex : Meeting::Concave;
}

} // namespace

bool cutOff(CellSource& source, std::size_t i, double tolerance) {
    const double level = source.at(i, Need::Value).value;
    std::vector<std::size_t> cuts, keeps;
    for (std::size_t j = 0; j < source.count(); ++j) {
        const Meeting how = j == i ? Meeting::None : source.meeting(i, j);
        if (how == Meeting::None)
            continue;
        const double other = source.tangent(j).height;
        if (!std::isfinite(other))
            continue;
        if (!(source.sharpness(i, j) > leastSharpness))
            continue;
        const double beyond = how == Meeting::Convex ? other - level : level - other;
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

namespace {

/// At corners a face has its surfels to one side, the more so the narrower it is; others end it there.
double mostOffCentre(const CellSource& source, std::size_t i) {
    constexpr double atCorners = 0.7; // of h
    int meets = 0;
    for (std::size_t j = 0; j < source.count(); ++j)
        meets += j != i && source.meeting(i, j) != Meeting::None ? 1 : 0;
    return meets >= 2 ? atCorners : surface::maxOffCentre;
}

} // namespace

bool isFace(CellSource& source, std::size_t i, double tolerance) {
    const Evaluationd& at = source.at(i, Need::Gradient);
    return valid(at) && at.offCentre <= mostOffCentre(source, i) * at.unit &&
           dot(at.normal, at.gradient) >= surface::minSlope && !cutOff(source, i, tolerance) &&
           !source.beyondBoundary();
}

double cutTolerance(double unit, double far) {
    constexpr double ofUnit = 1e-11, rounding = 16 * std::numeric_limits<double>::epsilon();
    return ofUnit * unit + rounding * far;
}

} // namespace cells
