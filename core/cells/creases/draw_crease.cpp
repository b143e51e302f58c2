#include "core/cells/creases/draw_crease.h"

#include "core/base/segment.h"
#include "core/cells/creases/cell_refit.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/cells/creases/link_bands.h"
#include "core/cells/creases/link_labels.h"
#include "core/cells/creases/surface_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace cells {

using base::Vec3d;
using base::Vec3f;

namespace {

constexpr double crossingReach = 1.2; ///< spacings from the middle of a link to the piece that it crosses
/// A line follows a crease that is within so many spacings for so long; what is shorter only crosses it. Beside one
/// that it does not run along a crease of its own would share its surfels, which have one partner each (labels.h).
struct Following {
    double reach, shortest;
};
constexpr Following following[] = {{1, 3}, {2.5, 7}};
constexpr double besideReach = 2.5; ///< spacings: surfels beside a crease that is followed
constexpr double usualNoise = 0.05; ///< spacings

class Drawer {
  public:
    Drawer(const surface::Surface& surface, std::span<const Vec3d> points, double sharpness)
        : m_surface(surface), m_surfels(surface.tree().surfels()), m_links(surface.tree(), m_surfels.items),
          m_line(lineOnSurface(surface, m_links, points)), m_labels(labelsOf(surface.tree())), m_before(m_labels),
          m_sharpness(sharpness) {}

    DrawnCrease run() {
        findFollowed();
        if (m_sharpness > 0)
            crease();
        sharpen();
        if (m_sharpness == 0)
            mergeSmooth();
        DrawnCrease out;
        out.surface = m_surface;
        for (std::size_t i = 0; i < m_labels.size(); ++i) {
            const bool was = m_before[i].meeting != Meeting::None, is = m_labels[i].meeting != Meeting::None;
            out.creased += is && (!was || m_before[i].cell != m_labels[i].cell) ? 1 : 0;
            out.changed += was && (!is || m_before[i].sharpness != m_labels[i].sharpness) ? 1 : 0;
        }
        if (m_labels != m_before) {
            const bool any = std::any_of(m_labels.begin(), m_labels.end(),
                                         [](const Label& l) { return l.meeting != Meeting::None; });
            out.surface = any ? labelled(m_surface, std::move(m_surfels), m_labels) : unlabelled(m_surface);
        }
        return out;
    }

  private:
    /// Which pieces run along a crease that is there, for so long that they do not only cross it.
    void findFollowed() {
        m_followed.assign(m_line.pieces.size(), false);
        for (const Following& each : following)
            findFollowed(each);
    }
    void findFollowed(const Following& how) {
        const std::size_t count = m_line.pieces.size();
        std::vector<bool> beside(count);
        for (std::size_t k = 0; k < count; ++k)
            beside[k] = onCrease(m_line.pieces[k], how.reach);
        for (std::size_t begin = 0; begin < count;) {
            std::size_t end = begin;
            double along = 0;
            for (; end < count && beside[end] == beside[begin]; ++end)
                along += base::distance(m_line.pieces[end].from, m_line.pieces[end].to);
            if (beside[begin] && along >= how.shortest * m_links.spacing(m_line.pieces[begin].nearest))
                std::fill(m_followed.begin() + static_cast<std::ptrdiff_t>(begin),
                          m_followed.begin() + static_cast<std::ptrdiff_t>(end), true);
            begin = end;
        }
    }
    bool onCrease(const LinePiece& piece, double spacings) const {
        const Vec3d middle = (piece.from + piece.to) / 2;
        const double reach = spacings * m_links.spacing(piece.nearest);
        std::set<std::uint32_t> cells{m_labels[piece.nearest].cell};
        const auto around = m_links.near(piece.nearest);
        for (const std::uint32_t i : around)
            if (base::distance(m_links.at(i), middle) < reach)
                cells.insert(m_labels[i].cell);
        const auto meets = [&](std::uint32_t i) {
            return m_labels[i].meeting != Meeting::None && cells.contains(m_labels[i].cell) &&
                   cells.contains(m_labels[i].partner);
        };
        return meets(piece.nearest) || std::any_of(around.begin(), around.end(), meets);
    }

    struct Nearest {
        double distanceSq;
        std::size_t piece;
    };
    static double shareOn(const LinePiece& piece, const Vec3d& p) { return shareAlong(piece.from, piece.to, p); }
    static double distanceSqTo(const LinePiece& piece, const Vec3d& p) {
        return base::distanceSq(p, nearestOnSegment(piece.from, piece.to, p));
    }
    /// Of surfel i, by the piece that is nearest to it: on which side of the line? At a bend by both pieces.
    bool isLeft(std::uint32_t i, const Nearest& nearest) const {
        const std::size_t count = m_line.pieces.size();
        const LinePiece& piece = m_line.pieces[nearest.piece];
        const double share = shareOn(piece, m_links.at(i));
        Vec3d way = base::normalized(piece.to - piece.from), foot = piece.from;
        const auto bend = [&](std::size_t other) {
            way += base::normalized(m_line.pieces[other].to - m_line.pieces[other].from);
        };
        if (share < 0 && (nearest.piece > 0 || m_line.closed))
            bend((nearest.piece + count - 1) % count);
        if (share > 1 && (nearest.piece + 1 < count || m_line.closed)) {
            bend((nearest.piece + 1) % count);
            foot = piece.to;
        }
        return dot(m_links.at(i) - foot, cross(piece.normal, way)) > 0;
    }
    /// Cuts the links between surfels of one cell that cross the line.
    void cutLinks() {
        std::map<std::uint32_t, Nearest> nearest; // piece by surfel
        for (std::size_t k = 0; k < m_line.pieces.size(); ++k) {
            const LinePiece& piece = m_line.pieces[k];
            const auto look = [&](std::uint32_t i) {
                const Nearest here{distanceSqTo(piece, m_links.at(i)), k};
                const auto [at, fresh] = nearest.emplace(i, here);
                if (!fresh && here.distanceSq < at->second.distanceSq)
                    at->second = here;
            };
            look(piece.nearest);
            for (const std::uint32_t i : m_links.near(piece.nearest))
                look(i);
        }
        for (const auto& [a, atA] : nearest)
            for (std::uint32_t e = m_links.begin(a); e < m_links.end(a); ++e) {
                const std::uint32_t b = m_links.link(e).other;
                const auto atB = nearest.find(b);
                if (b > a && atB != nearest.end() && crosses(a, atA, b, atB->second, m_links.link(e).cut))
                    m_links.cut(e, Cut::Crease);
            }
    }
    bool crosses(std::uint32_t a, const Nearest& atA, std::uint32_t b, const Nearest& atB, Cut cut) const {
        if (cut != Cut::None || m_labels[a].cell != m_labels[b].cell)
            return false;
        const Vec3d middle = (m_links.at(a) + m_links.at(b)) / 2;
        const double toA = distanceSqTo(m_line.pieces[atA.piece], middle);
        const double toB = distanceSqTo(m_line.pieces[atB.piece], middle);
        const std::size_t k = toA <= toB ? atA.piece : atB.piece;
        const double reach = crossingReach * m_links.spacing(a), share = shareOn(m_line.pieces[k], middle);
        if (m_followed[k] || !(std::min(toA, toB) < reach * reach))
            return false;
        if (!m_line.closed && ((share < 0 && k == 0) || (share > 1 && k + 1 == m_line.pieces.size())))
            return false; // round the end
        return isLeft(a, atA) != isLeft(b, atB);
    }

    /// Bands reach farther than their crease does: what lies beyond is given back to the rest of their face, so that a
    /// line there does not run along the end of a band.
    void shrinkBands() {
        constexpr double reach = 1.2;                // of h
        std::map<std::uint32_t, std::uint32_t> rest; // cell of a face
        for (const Label& label : m_labels) {
            const auto [at, fresh] = rest.emplace(label.face, label.cell);
            at->second = std::min(at->second, label.cell);
        }
        constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
        std::vector<std::uint32_t> source(m_labels.size(), none), front;
        for (std::uint32_t i = 0; i < m_labels.size(); ++i)
            if (m_labels[i].meeting != Meeting::None) {
                source[i] = i;
                front.push_back(i);
            }
        for (std::size_t at = 0; at < front.size(); ++at) {
            const std::uint32_t i = front[at];
            for (const std::uint32_t j : m_links.near(i)) {
                const double far = reach * static_cast<double>(m_surfels.items[j].support);
                if (source[j] == none && m_labels[j].cell == m_labels[i].cell &&
                    base::distance(m_links.at(j), m_links.at(source[i])) < far) {
                    source[j] = source[i];
                    front.push_back(j);
                }
            }
        }
        for (std::uint32_t i = 0; i < m_labels.size(); ++i)
            if (source[i] == none)
                m_labels[i].cell = m_labels[i].partner = rest[m_labels[i].face];
    }

    void crease() {
        shrinkBands();
        std::vector<Vec3f> normals(m_links.size());
        std::vector<std::uint32_t> before(m_links.size()), faces(m_links.size());
        for (std::size_t i = 0; i < m_links.size(); ++i) {
            normals[i] = m_surfels.items[i].normal;
            before[i] = m_labels[i].cell;
            faces[i] = m_labels[i].face;
        }
        m_links.cutWalls(normals);
        cutLinks();
        std::vector<std::uint32_t> cells = splitAtCreases(m_links, before);
        const std::vector<Vec3f> own = CellRefit(m_links, cells, faces, normals, usualNoise).ownNormals();
        for (std::uint32_t i = 0; i < m_links.size(); ++i)
            m_surfels.items[i].normal = own[i];
        moveToCells(m_links, cells, m_labels);
        labelByLinks(m_links, cells, faces, own, m_sharpness, m_labels);
    }

    void sharpen() {
        const auto byte = static_cast<std::uint8_t>(std::lround(255 * m_sharpness));
        for (std::size_t k = 0; k < m_line.pieces.size(); ++k) {
            if (!m_followed[k])
                continue;
            const LinePiece& piece = m_line.pieces[k];
            const auto look = [&](std::uint32_t i) {
                if (m_before[i].meeting != Meeting::None &&
                    base::distance(m_links.at(i), piece.from) < besideReach * m_links.spacing(i))
                    m_labels[i].sharpness = byte;
            };
            look(piece.nearest);
            for (const std::uint32_t i : m_links.near(piece.nearest))
                look(i);
        }
    }

    /// Cells that only creases without any sharpness part become one.
    void mergeSmooth() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> most; // sharpness
        for (const Label& label : m_labels)
            if (label.meeting != Meeting::None) {
                int& sharpest = most[std::minmax(label.cell, label.partner)];
                sharpest = std::max(sharpest, static_cast<int>(label.sharpness));
            }
        std::map<std::uint32_t, std::uint32_t> lower, lowerFace; // by number
        const auto rootIn = [](const std::map<std::uint32_t, std::uint32_t>& of, std::uint32_t i) {
            for (auto at = of.find(i); at != of.end(); at = of.find(i))
                i = at->second;
            return i;
        };
        const auto join = [&](std::map<std::uint32_t, std::uint32_t>& of, std::uint32_t a, std::uint32_t b) {
            a = rootIn(of, a), b = rootIn(of, b);
            if (a != b)
                of[std::max(a, b)] = std::min(a, b);
        };
        std::map<std::uint32_t, std::uint32_t> faceOf;
        for (const Label& label : m_labels)
            faceOf.emplace(label.cell, label.face);
        for (const auto& [pair, sharpest] : most)
            if (sharpest == 0) {
                join(lower, pair.first, pair.second);
                join(lowerFace, faceOf[pair.first], faceOf[pair.second]);
            }
        for (Label& label : m_labels) {
            label.cell = rootIn(lower, label.cell);
            label.face = rootIn(lowerFace, label.face);
            label.partner = rootIn(lower, label.partner);
            if (label.partner == label.cell) {
                label.meeting = Meeting::None;
                label.sharpness = 255;
            }
        }
        joinWhatMeetsNothing();
    }
    /// Bands whose creases are gone become the rest of their face again.
    void joinWhatMeetsNothing() {
        std::set<std::uint32_t> meets;
        std::map<std::uint32_t, std::uint32_t> first; // cell of a face
        for (const Label& label : m_labels) {
            const auto [at, fresh] = first.emplace(label.face, label.cell);
            at->second = std::min(at->second, label.cell);
            if (label.meeting != Meeting::None)
                meets.insert({label.cell, label.partner});
        }
        for (Label& label : m_labels)
            if (!meets.contains(label.cell))
                label.cell = label.partner = first[label.face];
    }

    const surface::Surface& m_surface;
    surfel::SurfelList m_surfels;
    SurfelLinks m_links;
    SurfaceLine m_line;
    std::vector<Label> m_labels, m_before;
    double m_sharpness;
    std::vector<bool> m_followed; ///< of each piece
};

} // namespace

DrawnCrease drawCrease(const surface::Surface& surface, std::span<const Vec3d> line, double sharpness,
                       const base::Progress& progress) {
    requireSides(surface);
    progress.step(0, "Looking for neighbours");
    return Drawer(surface, line, sharpness).run();
}

} // namespace cells
