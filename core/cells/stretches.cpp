#include "core/cells/stretches.h"

#include "core/base/clones.h"

#include <bit>

namespace cells {

using base::Vec3d, base::Vec3f;

namespace {

constexpr int lanes = surfel::clusterSize;

/// A cluster's surfels seen from a place on the ray.
struct Seen {
    float along[lanes];  ///< t of the ray's point nearest to them
    float halfSq[lanes]; ///< of half the chord of their balls; below zero: none
    float slope[lanes];  ///< n.d
    float level[lanes];  ///< of the place above their planes, with the sign turned
};

POINTCLAY_CLONES
void see(const float* c, const float* at, const float* direction, float reach, Seen& out) {
    for (int lane = 0; lane < lanes; ++lane) {
        const float qx = c[surfel::X * lanes + lane] - at[0], qy = c[surfel::Y * lanes + lane] - at[1];
        const float qz = c[surfel::Z * lanes + lane] - at[2];
        const float nx = c[surfel::NormalX * lanes + lane], ny = c[surfel::NormalY * lanes + lane];
        const float nz = c[surfel::NormalZ * lanes + lane], r = reach * c[surfel::Support * lanes + lane];
        const float t = qx * direction[0] + qy * direction[1] + qz * direction[2];
        const float ox = qx - direction[0] * t, oy = qy - direction[1] * t, oz = qz - direction[2] * t;
        out.along[lane] = t;
        out.halfSq[lane] = r * r - (ox * ox + oy * oy + oz * oz);
        out.slope[lane] = nx * direction[0] + ny * direction[1] + nz * direction[2];
        out.level[lane] = nx * qx + ny * qy + nz * qz;
    }
}

} // namespace

StretchFinder::StretchFinder(const CellSurface& surface) : m_surface(&surface) {}

void StretchFinder::start(const base::Rayd& ray) {
    m_ray = ray;
    m_rounded = {base::cast<float>(ray.origin), base::cast<float>(ray.direction)};
}

/// All is told from where the ray enters the cluster: exact, however far away it begins.
void StretchFinder::note(const surfel::SurfelBlock& block, int cluster, double enter, double from, double to) {
    const float scale = m_surface->surface().supportScale();
    const Vec3f at = base::cast<float>(m_ray.at(enter));
    Seen seen;
    see(block.channel(cluster, surfel::X), &at.x, &m_rounded.direction.x, scale * surfel::surfaceReach, seen);
    const float* c = block.channel(cluster, surfel::X);
    const LabelLayout::Cluster label = m_surface->labels().cluster(block, cluster);
    const int count = std::min(lanes, block.size() - cluster * lanes);
    for (int lane = 0; lane < count; ++lane) {
        if (!(seen.halfSq[lane] > 0))
            continue;
        const float half = std::sqrt(seen.halfSq[lane]), along = seen.along[lane];
        const double begin = enter + static_cast<double>(along - half), end = enter + static_cast<double>(along + half);
        if (end < from || begin > std::min(to, m_end))
            continue;
        const float slope = seen.slope[lane], inverse = 1 / slope, beyond = seen.level[lane] * inverse - along;
        const bool crossed = std::abs(beyond) <= half;
        const float aside = crossed ? beyond : 0, support = scale * c[surfel::Support * lanes + lane];
        // (reach^2 - halfSq) is the squared distance of the ray
        const float reach = surfel::surfaceReach * support;
        const float nearest = (reach * reach - seen.halfSq[lane] + aside * aside) / (support * support);
        const double guess = enter + static_cast<double>(along + aside);
        if (crossed && guess >= from && guess < m_crossing) {
            m_crossing = guess;
            m_unit = static_cast<double>(support);
        }
        const auto normal = [&](int axis) { return c[(surfel::NormalX + axis) * lanes + lane]; };
        m_chords.push_back({label.cell[lane],
                            label.face[lane],
                            std::max(begin, from),
                            std::min(end, to),
                            guess,
                            static_cast<double>(seen.level[lane]) + static_cast<double>(slope) * enter,
                            static_cast<double>(inverse),
                            nearest,
                            slope,
                            support,
                            {normal(0), normal(1), normal(2)}});
    }
}

/// Into the stretch of its cell that it touches.
void StretchFinder::unite(const Chord& c) {
    const auto slope = static_cast<double>(c.slope), unit = static_cast<double>(c.unit);
    Whole one;
    one.stretch = {c.cell, c.face, c.begin, c.end, c.guess, static_cast<double>(c.nearest), unit, slope, slope, 0, 0};
    one.normals.extend(c.normal);
    one.least = one.most = c.level * c.inverse;
    one.unit = unit;
    for (Whole& whole : m_whole)
        if (whole.touches(one)) {
            const bool grows = c.begin < whole.stretch.begin || c.end > whole.stretch.end;
            whole.unite(one);
            if (grows)
                uniteAll();
            return;
        }
    m_whole.push_back(one);
}

bool StretchFinder::Whole::touches(const Whole& o) const {
    return stretch.cell == o.stretch.cell && stretch.begin <= o.stretch.end && stretch.end >= o.stretch.begin;
}

void StretchFinder::Whole::unite(const Whole& o) {
    const Stretch& from = o.stretch;
    stretch.begin = std::min(stretch.begin, from.begin);
    stretch.end = std::max(stretch.end, from.end);
    stretch.unit = std::min(stretch.unit, from.unit);
    stretch.least = std::min(stretch.least, from.least);
    stretch.most = std::max(stretch.most, from.most);
    if (from.nearest < stretch.nearest) {
        stretch.nearest = from.nearest;
        stretch.guess = from.guess;
    }
    normals.extend(o.normals);
    least = std::min(least, o.least);
    most = std::max(most, o.most);
    unit = std::max(unit, o.unit);
}

/// Those that touch since one has grown.
void StretchFinder::uniteAll() {
    for (std::size_t i = 0; i < m_whole.size(); ++i)
        for (std::size_t j = i + 1; j < m_whole.size();) {
            if (!m_whole[i].touches(m_whole[j])) {
                ++j;
                continue;
            }
            m_whole[i].unite(m_whole[j]);
            m_whole[j] = m_whole.back();
            m_whole.pop_back();
            j = i + 1;
        }
}

namespace {

/// Of what normals differ: f is off the mean of heights by no more. For rounding, in h.
constexpr double ofSpread = 0.6, rounding = 1e-3;
constexpr double flat = 0.05; ///< what normals of a plane differ

} // namespace

/// Where f can be zero along a ray. It is a mean of heights above the planes of the surfels in support, but for half of
/// what their normals differ (surface/README 2.6): where all are above or all are below by more than that, no zero is
/// looked for. What chords leave out (0.7 h to h, a thirtieth of a weight and less) is not asked.
class StretchFinder::Bracket {
  public:
    /// Of the chords of the stretch's face, as far as `end`; `about` is room for them.
    Bracket(const Stretch& stretch, std::span<const Chord> chords, double end, std::vector<const Chord*>& about)
        : m_stretch(stretch), m_end(std::min(stretch.end, end)), m_about(about) {
        m_about.clear();
        for (const Chord& c : chords)
            if (c.face == stretch.face && c.begin <= m_end && c.end >= stretch.begin) {
                m_about.push_back(&c);
                m_normals.extend(c.normal);
                m_unit = std::max(m_unit, c.unit);
            }
    }
    /// Appends the stretch, for each of its pieces that can have zeros.
    void append(std::vector<Stretch>& out) const {
        constexpr double pieceOfUnit = 0.25;
        constexpr int mostPieces = 64;
        const double begin = m_stretch.begin, span = m_end - begin;
        // where the cell bends, what is far along the ray tells nothing
        const int pieces = static_cast<double>(m_normals.diagonal()) < flat
                               ? 1
                               : std::clamp(static_cast<int>(span / (pieceOfUnit * m_stretch.unit)), 1, mostPieces);
        const std::size_t before = out.size();
        for (int k = 0; k < pieces; ++k) {
            Stretch piece = m_stretch;
            piece.first = k == 0 ? begin : begin + k * span / pieces;
            piece.last = k + 1 == pieces ? m_end : begin + (k + 1) * span / pieces;
            appendPiece(piece, pieces == 1, before, out);
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
    void appendPiece(Stretch piece, bool whole, std::size_t before, std::vector<Stretch>& out) const {
        constexpr double mostSpread = 0.7;
        base::Box3f normals = m_normals;
        float unit = m_unit;
        if (!whole) {
            normals = {};
            unit = 0;
            for (const Chord* c : m_about)
                if (c->begin <= piece.last && c->end >= piece.first) {
                    normals.extend(c->normal);
                    unit = std::max(unit, c->unit);
                }
        }
        const auto spread = static_cast<double>(normals.diagonal());
        if (!(spread < mostSpread))
            return join(piece, before, out);
        const double margin = (ofSpread * spread + rounding) * static_cast<double>(unit);
        Span above, below;
        beyond(piece, margin, above, below);
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
    /// Where the ray is farther than `margin` above and below all planes about a piece.
    void beyond(const Stretch& piece, double margin, Span& above, Span& below) const {
        constexpr Span nowhere{0, 0};
        for (const Chord* c : m_about) {
            if (c->begin > piece.last || c->end < piece.first)
                continue;
            const auto slope = static_cast<double>(c->slope);
            if (slope == 0) {
                if (!(-c->level > margin))
                    above = nowhere;
                if (!(c->level > margin))
                    below = nowhere;
                continue;
            }
            const double up = (c->level + margin) * c->inverse, down = (c->level - margin) * c->inverse;
            if (slope > 0) {
                above.lo = std::max(above.lo, up);
                below.hi = std::min(below.hi, down);
            } else {
                above.hi = std::min(above.hi, up);
                below.lo = std::max(below.lo, down);
            }
        }
    }

    const Stretch& m_stretch;
    double m_end;
    std::vector<const Chord*>& m_about;
    base::Box3f m_normals;
    float m_unit = 0;
};

void StretchFinder::look(double from, double to, double ahead) {
    constexpr double none = std::numeric_limits<double>::infinity();
    m_chords.clear();
    m_whole.clear();
    m_found.clear();
    m_crossing = none;
    m_end = to;
    double firstMixed = none;
    const surfel::SurfelBlock* last = nullptr;
    unsigned mixed = 0;
    m_surface->surface().tree().nearRay(m_rounded,
                                        [&](const surfel::SurfelBlock& block, int cluster, float enter, float leave) {
                                            const auto begin = static_cast<double>(enter);
                                            if (begin <= m_end && static_cast<double>(leave) >= from) {
                                                if (&block != last)
                                                    mixed = m_surface->mixed(block);
                                                last = &block;
                                                if ((mixed >> cluster & 1u) != 0)
                                                    firstMixed = std::min(firstMixed, begin);
                                                note(block, cluster, begin, from, to);
                                                if (m_crossing < none)
                                                    m_end = std::min(to, m_crossing + ahead * m_unit);
                                            }
                                            return static_cast<float>(m_end);
                                        });
    m_mixed = firstMixed <= m_end;
    for (const Chord& each : m_chords)
        if (each.begin <= m_end)
            unite(each);
    for (const Whole& each : m_whole)
        append(each);
    std::sort(m_found.begin(), m_found.end(), [](const Stretch& a, const Stretch& b) {
        return a.first != b.first ? a.first < b.first : a.cell < b.cell;
    });
}

void StretchFinder::append(const Whole& whole) {
    const Stretch& stretch = whole.stretch;
    const double end = std::min(stretch.end, m_end);
    if (m_surface->parts().fadesToOtherFaces(stretch.cell)) {
        m_found.push_back(stretch);
        m_found.back().first = stretch.begin;
        m_found.back().last = end;
        return;
    }
    const bool oneCell = std::none_of(m_whole.begin(), m_whole.end(), [&](const Whole& other) {
        return other.stretch.face == stretch.face && other.stretch.cell != stretch.cell;
    });
    const auto spread = static_cast<double>(whole.normals.diagonal());
    if (!oneCell || !stretch.monotone() || !(spread < flat))
        return Bracket(stretch, m_chords, m_end, m_about).append(m_found);
    // a plane has its zero where its surfels' are
    const double slope = std::min(std::abs(stretch.least), std::abs(stretch.most));
    const double margin = (ofSpread * spread + rounding) * whole.unit / slope;
    Stretch piece = stretch;
    piece.first = std::max(stretch.begin, whole.least - margin);
    piece.last = std::min(end, whole.most + margin);
    if (piece.first <= piece.last)
        m_found.push_back(piece);
}

std::vector<Stretch> stretches(const CellSurface& surface, const base::Rayd& ray, double tMin, double tMax) {
    StretchFinder finder(surface);
    finder.start(ray);
    finder.look(tMin, tMax, std::numeric_limits<double>::infinity());
    return finder.found();
}

} // namespace cells
