#include "core/cells/cell_roots.h"

#include "core/surface/rays/surface_intervals.h"

#include <bit>

namespace cells {

using base::Vec3d;
using surface::Need;

namespace {

constexpr int lanes = surfel::clusterSize;

/// The chord of a ball about a surfel in which the surface that it tells of can be.
struct Chord {
    std::uint32_t cell;
    double begin, end, guess, nearest, unit, slope;
    std::uint32_t face;
    double level; ///< the ray is slope t - level above the surfel's plane
    Vec3d normal;
};

/// A bit for each surfel of a cluster whose ball the ray passes, and for few that it does not.
unsigned passedBalls(const surfel::SurfelBlock& block, int cluster, const base::Rayf& ray, float scale) {
    const float* x = block.channel(cluster, surfel::X);
    const float* h = block.channel(cluster, surfel::Support);
    const float reach = scale * surfel::surfaceReach * 1.0001f;
    float beyond[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
        const float qx = x[lane] - ray.origin.x, qy = x[lane + lanes] - ray.origin.y;
        const float qz = x[lane + 2 * lanes] - ray.origin.z;
        const float t = qx * ray.direction.x + qy * ray.direction.y + qz * ray.direction.z;
        const float ox = qx - ray.direction.x * t, oy = qy - ray.direction.y * t, oz = qz - ray.direction.z * t;
        // what float32 leaves of a distance from afar
        const float r = reach * h[lane] + 1e-6f * (std::abs(qx) + std::abs(qy) + std::abs(qz));
        beyond[lane] = ox * ox + oy * oy + oz * oz - r * r;
    }
    unsigned out = 0;
    const int count = std::min(lanes, block.size() - cluster * lanes);
    for (int lane = 0; lane < count; ++lane)
        out |= static_cast<unsigned>(beyond[lane] < 0) << lane;
    return out;
}

void append(std::vector<Stretch>& out, const Chord& c) {
    if (out.empty() || out.back().cell != c.cell || c.begin > out.back().end) {
        out.push_back({c.cell, c.face, c.begin, c.end, c.guess, c.nearest, c.unit, c.slope, c.slope, c.begin, c.end});
        return;
    }
    Stretch& last = out.back();
    last.last = last.end = std::max(last.end, c.end);
    last.unit = std::min(last.unit, c.unit);
    last.least = std::min(last.least, c.slope);
    last.most = std::max(last.most, c.slope);
    if (c.nearest < last.nearest) {
        last.nearest = c.nearest;
        last.guess = c.guess;
    }
}

/// Where f can be zero along a ray. It is a mean of heights above the planes of the surfels in support, but for half of
/// what their normals differ (surface/README 2.6): where all are above or all are below by more than that, no zero is
/// looked for. What chords leave out (0.7 h to h, a thirtieth of a weight and less) is not asked.
class Bracket {
  public:
    void add(const Chord& c) {
        m_chords.push_back(&c);
        m_normals.extend(c.normal);
    }
    /// Appends the stretch, for each of its pieces that can have zeros.
    void append(const Stretch& stretch, std::vector<Stretch>& out) const {
        constexpr double flat = 0.05, pieceOfUnit = 0.25;
        constexpr int mostPieces = 64;
        const double span = stretch.end - stretch.begin;
        // where the cell bends, what is far along the ray tells nothing
        const int pieces = m_normals.diagonal() < flat
                               ? 1
                               : std::clamp(static_cast<int>(span / (pieceOfUnit * stretch.unit)), 1, mostPieces);
        const std::size_t before = out.size();
        for (int k = 0; k < pieces; ++k) {
            Stretch piece = stretch;
            piece.first = k == 0 ? stretch.begin : stretch.begin + k * span / pieces;
            piece.last = k + 1 == pieces ? stretch.end : stretch.begin + (k + 1) * span / pieces;
            appendPiece(piece, before, out);
        }
    }

  private:
    struct Span {
        double lo = -std::numeric_limits<double>::infinity(), hi = std::numeric_limits<double>::infinity();
    };
    static void join(const Stretch& piece, std::size_t before, std::vector<Stretch>& out) {
        if (out.size() > before && out.back().last >= piece.first)
            out.back().last = piece.last;
        else
            out.push_back(piece);
    }
    void appendPiece(Stretch piece, std::size_t before, std::vector<Stretch>& out) const {
        constexpr double mostSpread = 0.7, ofSpread = 0.6, rounding = 1e-3;
        base::Box3d normals;
        double unit = 0;
        for (const Chord* c : m_chords)
            if (c->begin <= piece.last && c->end >= piece.first) {
                normals.extend(c->normal);
                unit = std::max(unit, c->unit);
            }
        const double spread = normals.diagonal();
        if (!(spread < mostSpread))
            return join(piece, before, out);
        const double margin = (ofSpread * spread + rounding) * unit;
        Span above = beyond(piece, margin, 1), below = beyond(piece, margin, -1);
        if (below.lo < above.lo)
            std::swap(above, below);
        for (const Span& none : {above, below})
            if (none.lo < none.hi && none.hi > piece.first) {
                if (none.lo > piece.first) {
                    Stretch early = piece;
                    early.last = std::min(piece.last, none.lo);
                    join(early, before, out);
                }
                piece.first = none.hi;
                if (!(piece.first < piece.last))
                    return;
            }
        join(piece, before, out);
    }
    /// Where the ray is farther than `margin` on this side of all planes about a piece.
    Span beyond(const Stretch& piece, double margin, double side) const {
        Span out;
        for (const Chord* c : m_chords) {
            if (c->begin > piece.last || c->end < piece.first)
                continue;
            const double slope = side * c->slope, t = (margin + side * c->level) / slope;
            if (slope > 0)
                out.lo = std::max(out.lo, t);
            else if (slope < 0)
                out.hi = std::min(out.hi, t);
            else if (!(-side * c->level > margin))
                return {0, 0};
        }
        return out;
    }

    std::vector<const Chord*> m_chords;
    base::Box3d m_normals;
};

} // namespace

std::vector<Stretch> stretches(const CellSurface& surface, const base::Rayd& ray, double tMin, double tMax) {
    std::vector<Chord> chords;
    const float scale = surface.surface().supportScale();
    const base::Rayf rounded{base::cast<float>(ray.origin), base::cast<float>(ray.direction)};
    surface.surface().tree().alongRay(rounded, [&](const surfel::SurfelBlock& block, int cluster, float enter, float) {
        if (static_cast<double>(enter) > tMax)
            return false;
        const unsigned passed = passedBalls(block, cluster, rounded, scale);
        for (unsigned left = passed; left != 0; left &= left - 1) {
            const int slot = cluster * lanes + std::countr_zero(left);
            const double support = static_cast<double>(scale) * static_cast<double>(block.support(slot));
            const double reach = support * static_cast<double>(surfel::surfaceReach);
            const Vec3d q = base::cast<double>(block.position(slot)) - ray.origin;
            const double t = dot(q, ray.direction), besideSq = lengthSq(q - ray.direction * t);
            if (!(besideSq < reach * reach))
                continue;
            const double half = std::sqrt(reach * reach - besideSq);
            if (t + half < tMin || t - half > tMax)
                continue;
            const Vec3d n = base::cast<double>(block.normal(slot));
            const double slope = dot(n, ray.direction), crossing = dot(n, q) / slope;
            const double guess = std::abs(crossing - t) <= half ? crossing : t;
            chords.push_back({surface.labels().cellAt(block, slot), std::max(t - half, tMin), std::min(t + half, tMax),
                              guess, lengthSq(q - ray.direction * guess) / (support * support), support, slope,
                              surface.labels().faceAt(block, slot), dot(n, q), n});
        }
        return true;
    });
    std::sort(chords.begin(), chords.end(),
              [](const Chord& a, const Chord& b) { return a.cell != b.cell ? a.cell < b.cell : a.begin < b.begin; });
    std::vector<Stretch> whole, out;
    for (const Chord& each : chords)
        append(whole, each);
    for (const Stretch& each : whole) {
        if (surface.parts().fadesToOtherFaces(each.cell)) {
            out.push_back(each);
            continue;
        }
        Bracket bracket;
        for (const Chord& c : chords)
            if (c.face == each.face && c.begin <= each.end && c.end >= each.begin)
                bracket.add(c);
        bracket.append(each, out);
    }
    std::sort(out.begin(), out.end(), [](const Stretch& a, const Stretch& b) {
        return a.first != b.first ? a.first < b.first : a.cell < b.cell;
    });
    return out;
}

template <class Source>
void CellRoots<Source>::find(const Stretch& stretch, std::vector<double>& out) {
    m_cell = stretch.cell;
    m_source.setScale(stretch.unit);
    double t = 0;
    if (stretch.monotone() && newton(stretch, t)) {
        if (t >= stretch.begin && t <= stretch.end)
            out.push_back(t);
        return;
    }
    march(stretch, out);
}

/// Plain Newton, the step no longer than half a support. False where it leaves the stretch or does not settle.
template <class Source>
bool CellRoots<Source>::newton(const Stretch& stretch, double& t) {
    constexpr int most = 24;
    const double margin = 0.2 * stretch.unit;
    t = std::clamp(stretch.guess, stretch.begin, stretch.end);
    for (int k = 0; k < most; ++k) {
        m_source.moveTo(m_ray.at(t));
        const std::size_t i = m_source.find(m_cell);
        ++m_evaluations;
        if (i == Source::none)
            return false;
        const auto& at = m_source.at(i, Need::Gradient);
        const double slope = valid(at) ? dot(at.gradient, m_ray.direction) : 0;
        if (!(std::abs(slope) > 0.05))
            return false;
        const double step = std::clamp(-at.value / slope, -0.5 * at.unit, 0.5 * at.unit);
        t += step;
        if (t < stretch.begin - margin || t > stretch.end + margin)
            return false;
        if (std::abs(step) <= Source::settled * at.unit + rounding(t))
            return true;
    }
    return false;
}

template <class Source>
auto CellRoots<Source>::sample(double t) -> Sample {
    m_source.moveTo(m_ray.at(t));
    const std::size_t i = m_source.find(m_cell);
    ++m_evaluations;
    if (i == Source::none)
        return {t, 0, false};
    const auto& at = m_source.at(i, Need::Value);
    return {t, at.value, valid(at)};
}

template <class Source>
void CellRoots<Source>::march(const Stretch& stretch, std::vector<double>& out) {
    constexpr double stepOfUnit = 1.0 / 12, dip = 0.6; // of the support; of a step, below which zeros may be in pairs
    constexpr int finer = 8, longest = 4;
    constexpr double leastSpan = 1.5; // steps to a zero, at least: f over the step times this
    const double span = stretch.last - stretch.first;
    const int steps = std::max(2, static_cast<int>(std::min(std::ceil(span / (stepOfUnit * stretch.unit)), 1e6)));
    const double step = span / steps;
    Sample before, last = sample(stretch.first);
    int stride = 1; // in steps, since the sample before
    for (int k = 1; k <= steps; k += stride) {
        const int passed = stride;
        const Sample next = sample(stretch.first + k * step);
        if (last.valid && next.valid && (last.f > 0) != (next.f > 0)) {
            refine(last, next, stretch.unit, out);
        } else if (k > 1 && passed == 1 && before.valid && last.valid && next.valid && std::abs(last.f) < dip * step &&
                   std::abs(last.f) <= std::abs(before.f) && std::abs(last.f) <= std::abs(next.f)) {
            Sample a = last.t - before.t < 1.5 * step ? before : sample(last.t - step);
            const double begin = a.t;
            for (int m = 1; m <= 2 * finer; ++m) {
                const Sample b = sample(begin + m * step / finer);
                if (a.valid && b.valid && (a.f > 0) != (b.f > 0))
                    refine(a, b, stretch.unit, out);
                a = b;
            }
        }
        before = last;
        last = next;
        // f hardly falls faster than by the way: far from zero there is none within the next steps
        stride = next.valid ? std::clamp(static_cast<int>(std::abs(next.f) / (leastSpan * step)), 1, longest) : 1;
        if (k < steps && k + stride > steps)
            stride = steps - k;
    }
    std::sort(out.begin(), out.end());
}

/// False position after Illinois, halving where that is slow.
template <class Source>
void CellRoots<Source>::refine(Sample a, Sample b, double unit, std::vector<double>& out) {
    constexpr int most = 80;
    constexpr double jump = 0.02; // of the support: larger where the interval has shrunk to nothing is no zero
    double fa = a.f, fb = b.f;
    for (int k = 0; k < most && b.t - a.t > Source::precision * unit + rounding(b.t); ++k) {
        double t = k % 4 == 3 ? (a.t + b.t) / 2 : (a.t * fb - b.t * fa) / (fb - fa);
        if (!(t > a.t && t < b.t))
            t = (a.t + b.t) / 2;
        const Sample mid = sample(t);
        if (!mid.valid)
            return;
        if (mid.f == 0) {
            a = b = mid;
            break;
        }
        if ((mid.f > 0) == (a.f > 0)) {
            a = mid;
            fa = mid.f;
            fb /= 2;
        } else {
            b = mid;
            fb = mid.f;
            fa /= 2;
        }
    }
    if (std::min(std::abs(a.f), std::abs(b.f)) > jump * unit)
        return;
    out.push_back(std::abs(a.f) < std::abs(b.f) ? a.t : b.t);
}

template class CellRoots<CellSource>;
template class CellRoots<CellSourcef>;

} // namespace cells
