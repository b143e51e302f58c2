#include "core/cells/local_boolean.h"

#include "core/surface/rays/intersect.h"

namespace cells {

using base::Vec3d;
using surface::Need;

namespace {

constexpr double leastSharpness = 0.02; ///< of a crease; with less both sides are nearly the same function

/// How two cells meet by where they are, for those that no surfel has as partners: neighbours of a third one.
template <class Source>
Meeting measured(Source& source, std::size_t j, std::size_t k) {
    for (const Meeting known : {source.meeting(j, k), source.meeting(k, j)})
        if (known != Meeting::None)
            return known;
    const CellSource::Tangent a = source.tangent(j), b = source.tangent(k);
    return dot(a.normal - b.normal, b.centroid - a.centroid) < 0 ? Meeting::Convex : Meeting::Concave;
}

/// At corners a face has its surfels to one side, the more so the narrower it is; others end it there.
template <class Source>
double mostOffCentre(Source& source, std::size_t i) {
    constexpr double atCorners = 0.7; // of h
    int meets = 0;
    for (std::size_t j = 0; j < source.count(); ++j)
        meets += j != i && source.meeting(i, j) != Meeting::None ? 1 : 0;
    return meets >= 2 ? atCorners : surface::maxOffCentre;
}

/// Do surfels of the cell, and of those smooth to it, lie all around? At a seam they are to one side, and beyond it the
/// more so.
template <class Source>
bool surrounded(Source& source, std::size_t i) {
    constexpr double within = 0.08; // of h: their centre along the surface; .11 at the corner of a face of 270 degrees
    const auto& at = source.at(i, Need::Value);
    CellSource::Sums sums = source.sums(i);
    for (std::size_t j = 0; j < source.count(); ++j)
        if (j != i && source.smooth(i, j)) {
            const CellSource::Sums other = source.sums(j);
            sums.weight += other.weight;
            sums.way += other.way;
        }
    const Vec3d along = sums.way - at.normal * dot(sums.way, at.normal);
    return sums.weight > 0 && length(along) < within * at.unit * sums.weight;
}

/// Is there something of cell j where it cuts i off? Where both are nearly one plane and j is not, nothing would be:
/// its zeros are looked for no farther from its surfels (cells/README 4).
template <class Source>
bool isThere(Source& source, std::size_t i, std::size_t j, const CellSource::Tangent& plane) {
    constexpr double flat = 0.9; // cosine
    if (dot(source.at(i, Need::Value).normal, plane.normal) < flat)
        return true;
    const auto& at = source.at(j, Need::Value);
    return valid(at) && at.offCentre <= mostOffCentre(source, j) * at.unit && source.reaches(j);
}

} // namespace

template <class Source>
bool cutOff(Source& source, std::size_t i, double tolerance) {
    const double level = source.at(i, Need::Value).value;
    std::vector<std::size_t> cuts, keeps;
    for (std::size_t j = 0; j < source.count(); ++j) {
        const Meeting how = j == i ? Meeting::None : source.meeting(i, j);
        if (how == Meeting::None)
            continue;
        const CellSource::Tangent other = source.tangent(j);
        if (!std::isfinite(other.height) || !(source.sharpness(i, j) > leastSharpness))
            continue;
        const double beyond = how == Meeting::Convex ? other.height - level : level - other.height;
        if (!(beyond > tolerance))
            keeps.push_back(j);
        else if (isThere(source, i, j, other))
            cuts.push_back(j);
    }
    for (const std::size_t cut : cuts) {
        const Meeting how = source.meeting(i, cut);
        const bool excused = std::any_of(keeps.begin(), keeps.end(), [&](std::size_t keep) {
            return source.meeting(i, keep) == how && measured(source, cut, keep) == opposite(how);
        });
        if (!excused)
            return !surrounded(source, i);
    }
    return false;
}

namespace {

/// q, turned as little as turns direction a into b.
Vec3d turned(const Vec3d& q, const Vec3d& a, const Vec3d& b) {
    const double cosine = dot(a, b);
    if (!(cosine > -0.999999)) // half a turn, about whatever axis
        return -q;
    const Vec3d axis = cross(a, b);
    return q * cosine + cross(axis, q) + axis * (dot(axis, q) / (1 + cosine));
}

} // namespace

template <class Source>
bool beyondBoundary(Source& source, std::size_t i) {
    const auto limit = static_cast<double>(source.surface().surface().definition().boundaryLimit);
    const auto& own = source.at(i, Need::Value);
    if (!std::isfinite(limit))
        return false;
    Vec3d way = (own.centroid - source.position()) * own.weight;
    double weight = own.weight;
    for (std::size_t j = 0; j < source.count(); ++j) {
        if (j == i || source.smooth(i, j))
            continue;
        const bool meets = source.meeting(i, j) != Meeting::None;
        const double share = meets ? source.sharpness(i, j) : 1;
        const CellSource::Sums sums = share > 0 ? source.sums(j) : CellSource::Sums();
        if (!(sums.weight > 0))
            continue;
        way += (meets ? turned(sums.way, base::normalized(sums.normal), own.normal) : sums.way) * share;
        weight += sums.weight * share;
    }
    return length(way) > limit * own.unit * weight;
}

template <class Source>
bool isFace(Source& source, std::size_t i, double tolerance) {
    const auto& at = source.at(i, Need::Gradient);
    return valid(at) && at.offCentre <= mostOffCentre(source, i) * at.unit &&
           dot(at.normal, at.gradient) >= surface::minSlope && !cutOff(source, i, tolerance) &&
           !beyondBoundary(source, i);
}

template bool cutOff(CellSource&, std::size_t, double);
template bool cutOff(CellSourcef&, std::size_t, double);
template bool beyondBoundary(CellSource&, std::size_t);
template bool beyondBoundary(CellSourcef&, std::size_t);
template bool isFace(CellSource&, std::size_t, double);
template bool isFace(CellSourcef&, std::size_t, double);

double cutTolerance(double unit, double far) {
    constexpr double ofUnit = 1e-11, rounding = 16 * std::numeric_limits<double>::epsilon();
    return ofUnit * unit + rounding * far;
}

double cutTolerance(const CellSourcef&, double unit, double far) {
    return CellSourcef::noise * unit + 4 * CellSourcef::rounding * far;
}

} // namespace cells
