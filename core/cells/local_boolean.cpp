#include "core/cells/local_boolean.h"

#include "core/surface/rays/intersect.h"
#include "core/surface/rims.h"

namespace cells {

using base::Vec3d;
using surface::Need;

namespace {

constexpr double leastSharpness = 0.02; ///< of a crease; with less both sides are nearly the same function

/// A cell that another one meets, as a plane.
struct Other {
    std::size_t place; ///< among the source's cells, or none
    Meeting how;
    CellSource::Tangent plane;
};

/// How two cells meet by where they are, for those that no surfel has as partners: neighbours of a third one.
template <class Source>
Meeting measured(Source& source, const Other& a, const Other& b) {
    if (a.place != Source::none && b.place != Source::none)
        for (const Meeting known : {source.meeting(a.place, b.place), source.meeting(b.place, a.place)})
            if (known != Meeting::None)
                return known;
    return dot(a.plane.normal - b.plane.normal, b.plane.centroid - a.plane.centroid) < 0 ? Meeting::Convex
                                                                                         : Meeting::Concave;
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

/// Are the surfels of cell j in the sums of cell i: of one face, or across a crease that has faded out?
template <class Source>
bool joined(Source& source, std::size_t i, std::size_t j) {
    return source.smooth(i, j) || (source.meeting(i, j) != Meeting::None && !(source.sharpness(i, j) > leastSharpness));
}

/// Does cell j tell better than i what both have nearly the same sums of: has it most of their weight?
template <class Source>
bool speaksFor(Source& source, std::size_t j, std::size_t i) {
    constexpr double more = 2;
    return joined(source, i, j) && source.sums(j).weight > more * source.sums(i).weight;
}

/// How far aside of the position is the centre of the cell's surfels, and of those smooth to it, along the surface, in
/// h? At a seam they are to one side, and beyond it the more so.
template <class Source>
double aside(Source& source, std::size_t i) {
    const auto& at = source.at(i, Need::Value);
    CellSource::Sums sums = source.sums(i);
    for (std::size_t j = 0; j < source.count(); ++j)
        if (j != i && joined(source, i, j)) {
            const CellSource::Sums other = source.sums(j);
            sums.weight += other.weight;
            sums.way += other.way;
        }
    const Vec3d along = sums.way - at.normal * dot(sums.way, at.normal);
    return sums.weight > 0 ? length(along) / (at.unit * sums.weight) : std::numeric_limits<double>::infinity();
}

/// Nothing cuts a cell off whose surfels lie all around: .11 at the corner of a face of 270 degrees, .23 at a straight
/// seam. Cells without surfels in support are told of by one plane alone, so they cut it off beyond its rim only.
constexpr double allAround = 0.08, beyondRim = 0.2;

constexpr double nearlyFlat = 0.9; ///< cosine between planes

/// Is there something of cell j where it cuts i off? Where both are nearly one plane and j is not, nothing would be:
/// its zeros are looked for no farther from its surfels (cells/README 4).
template <class Source>
bool isThere(Source& source, std::size_t i, std::size_t j, const CellSource::Tangent& plane) {
    if (dot(source.at(i, Need::Value).normal, plane.normal) < nearlyFlat)
        return true;
    const auto& at = source.at(j, Need::Value);
    return valid(at) && at.offCentre <= mostOffCentre(source, j) * at.unit && source.reaches(j);
}

/// The plane of the cell's surfel nearest to x, unless that is a stranger: the cell has none in support, so it is
/// sampled so finely that its surfels are many here. Where both planes are nearly one, x must be over it.
std::optional<CellSource::Tangent> nearestPlane(const CellSurface& cells, std::uint32_t cell, const Vec3d& x,
                                                const Vec3d& normal) {
    constexpr std::size_t looked = 32;
    std::vector<tree::Neighbour> near;
    cells.surface().tree().nearest(base::cast<float>(x), looked, near);
    for (const tree::Neighbour& each : near) {
        if (cells.labels().cellAt(*each.block, each.slot) != cell)
            continue;
        const Vec3d p = base::cast<double>(each.block->position(each.slot));
        const Vec3d n = base::normalized(base::cast<double>(each.block->normal(each.slot))), q = x - p;
        const double reach = static_cast<double>(surfel::surfaceReach * each.block->support(each.slot));
        const double height = dot(n, q);
        if (dot(n, normal) > nearlyFlat && lengthSq(q) - height * height > reach * reach)
            return std::nullopt;
        return CellSource::Tangent{n, p, height};
    }
    return std::nullopt;
}

double beyond(const Other& other, double level) {
    return other.how == Meeting::Convex ? other.plane.height - level : level - other.plane.height;
}

/// Cuts and keeps of cell i by the cells around, present and absent.
template <class Source>
class Cutters {
  public:
    /// `but`: a cell that is not asked, and then others are taken to be where they cut.
    Cutters(Source& source, std::size_t i, double tolerance, std::size_t but = Source::none)
        : m_source(source), m_i(i), m_but(but), m_level(source.at(i, Need::Value).value), m_tolerance(tolerance) {}

    /// Of those that cut and are not excused the one that cuts most; where so asked, of those that nothing but their
    /// plane is known of.
    std::optional<Other> find(bool planesOnly) {
        for (std::size_t j = 0; j < m_source.count(); ++j)
            take(j);
        const std::vector<AbsentCell> absent = m_source.absent(m_i);
        if (m_cuts.empty() && absent.empty())
            return std::nullopt;
        const double far = aside(m_source, m_i);
        if (far < allAround)
            return std::nullopt;
        if (far > beyondRim)
            for (const AbsentCell& each : absent)
                take(each);
        std::optional<Other> most;
        for (const Other& cut : m_cuts)
            if (!(planesOnly && hasValue(cut)) && !excused(cut) &&
                (!most || beyond(cut, m_level) > beyond(*most, m_level)))
                most = cut;
        return most;
    }

  private:
    bool hasValue(const Other& other) {
        return other.place != Source::none && valid(m_source.at(other.place, Need::Value));
    }
    bool excused(const Other& cut) {
        return std::any_of(m_keeps.begin(), m_keeps.end(), [&](const Other& keep) {
            return keep.how == cut.how && measured(m_source, cut, keep) == opposite(cut.how) && isAsNear(keep, cut);
        });
    }
    /// Of a face on both sides of i, far ends say of the near side what is true of their own.
    bool isSpokenFor(std::size_t j) {
        for (std::size_t k = 0; k < m_source.count(); ++k)
            if (k != j && k != m_i && m_source.meeting(m_i, k) != Meeting::None && speaksFor(m_source, k, j))
                return true;
        return false;
    }
    /// Before the tip of a wedge between two sides that go on into one another, the wedge's plane ends one of them, and
    /// then that does not end the other.
    bool endsBefore(std::size_t j) {
        return m_but == Source::none &&
               dot(m_source.at(m_i, Need::Value).normal, m_source.tangent(j).normal) > nearlyFlat &&
               valid(m_source.at(j, Need::Value)) && Cutters(m_source, j, m_tolerance, m_i).find(false).has_value();
    }
    /// At a reflex corner what keeps i is nearer than what it keeps it from.
    bool isAsNear(const Other& keep, const Other& cut) {
        constexpr double least = 0.1;
        return keep.place == Source::none || cut.place == Source::none ||
               m_source.sums(keep.place).weight > least * m_source.sums(cut.place).weight;
    }
    void take(std::size_t j) {
        const Meeting how = j == m_i || j == m_but ? Meeting::None : m_source.meeting(m_i, j);
        if (how == Meeting::None)
            return;
        const Other other{j, how, m_source.tangent(j)};
        if (!std::isfinite(other.plane.height) || !(m_source.sharpness(m_i, j) > leastSharpness))
            return;
        if (!(beyond(other, m_level) > m_tolerance))
            m_keeps.push_back(other);
        else if (isThere(m_source, m_i, j, other.plane) && !isSpokenFor(j) && !endsBefore(j))
            m_cuts.push_back(other);
    }
    void take(const AbsentCell& absent) {
        if (absent.meeting() == Meeting::None || !(absent.sharpness > leastSharpness * absent.weight))
            return;
        const auto plane =
            nearestPlane(m_source.surface(), absent.cell, m_source.position(), m_source.at(m_i, Need::Value).normal);
        if (!plane)
            return;
        const Other other{Source::none, absent.meeting(), *plane};
        (beyond(other, m_level) > m_tolerance ? m_cuts : m_keeps).push_back(other);
    }

    Source& m_source;
    std::size_t m_i, m_but;
    double m_level, m_tolerance;
    std::vector<Other> m_cuts, m_keeps;
};

} // namespace

template <class Source>
bool cutOff(Source& source, std::size_t i, double tolerance) {
    if (Cutters(source, i, tolerance).find(false))
        return true;
    // what goes on over most of the sums' surfels, without one beside their crease, ends with them; but at the end of
    // a crease within a face, what both its sides are summed in
    for (std::size_t j = 0; j < source.count(); ++j)
        if (j != i && speaksFor(source, j, i) && valid(source.at(j, Need::Value)))
            if (const auto cut = Cutters(source, j, tolerance).find(false);
                cut && (cut->place == Source::none || !joined(source, i, cut->place)))
                return true;
    return false;
}

std::optional<CellSource::Tangent> cutOffByPlane(CellSource& source, std::size_t i, double tolerance) {
    const auto cut = Cutters(source, i, tolerance).find(true);
    return cut ? std::optional(cut->plane) : std::nullopt;
}

std::optional<CellSource::Tangent> planeOf(CellSource& source, std::size_t i, const AbsentCell& absent) {
    return nearestPlane(source.surface(), absent.cell, source.position(), source.at(i, Need::Value).normal);
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
    return length(way) > limit * own.unit * weight && surface::mayEnd(source.surface().surface(), source.position());
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
