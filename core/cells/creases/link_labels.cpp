#include "core/cells/creases/link_labels.h"

#include "core/base/parallel.h"
#include "core/cells/crease_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cells {

using base::Vec3d;

namespace {

constexpr double shareReach = 2.8; ///< spacings: links whose share tells how sharp the crease is
constexpr double leastShare = 0.15, shareRange = 0.6;

class LinkLabels {
  public:
    LinkLabels(const SurfelLinks& links, std::span<const std::uint32_t> cells, std::span<const std::uint32_t> faces,
               std::span<const base::Vec3f> normals, double sharpness)
        : m_links(links), m_cells(cells), m_faces(faces), m_normals(normals), m_sharpness(sharpness) {}

    void label(std::uint32_t i, Label& out) const {
        out.cell = m_cells[i];
        out.face = m_faces[i];
        const double known = distanceToKnown(i, out);
        const std::uint32_t partner = nearestAcross(i, known);
        if (partner == m_cells[i])
            return;
        out.partner = partner;
        double cut = 0, all = 0;
        const double reach = shareReach * m_links.spacing(i);
        forCrossings(i, partner, [&](std::uint32_t, std::uint32_t e, double distance) {
            const double part = distance / reach;
            if (!(part < 1) || m_links.link(e).cut == Cut::Wall)
                return;
            const double weight = (1 - part) * (1 - part);
            all += weight;
            cut += m_links.link(e).cut == Cut::Crease ? weight : 0;
        });
        out.meeting = meeting(i, partner);
        // between faces of their own only the whole of a crease is there
        const bool fades = m_faces[i] == faceOf(i, partner);
        const double share = fades ? std::clamp((cut / std::max(all, 1e-30) - leastShare) / shareRange, 0.0, 1.0) : 1;
        out.sharpness = static_cast<std::uint8_t>(std::lround(255 * m_sharpness * share));
    }

  private:
    /// fn(a, e, distance) for links between the surfel's cell and another one, from a in its own.
    template <class Fn>
    void forCrossings(std::uint32_t i, std::uint32_t partner, const Fn& fn) const {
        const auto from = [&](std::uint32_t a) {
            if (m_cells[a] != m_cells[i])
                return;
            for (std::uint32_t e = m_links.begin(a); e < m_links.end(a); ++e)
                if (const std::uint32_t b = m_links.link(e).other;
                    m_cells[b] != m_cells[i] && (partner == m_cells[i] || m_cells[b] == partner))
                    fn(a, e, base::distance(m_links.middle(a, e), m_links.at(i)));
        };
        from(i);
        for (const std::uint32_t a : m_links.near(i))
            from(a);
    }
    /// How far off is the crease that the surfel is known to be beside?
    double distanceToKnown(std::uint32_t i, const Label& label) const {
        double least = std::numeric_limits<double>::infinity();
        if (label.meeting != Meeting::None && label.partner != m_cells[i])
            forCrossings(i, label.partner, [&](std::uint32_t, std::uint32_t e, double distance) {
                if (m_links.link(e).cut != Cut::Wall)
                    least = std::min(least, distance);
            });
        return least;
    }
    /// The cell across the nearest link that is cut and nearer than so, the own one for none.
    std::uint32_t nearestAcross(std::uint32_t i, double within) const {
        double least = std::min(within, partnerReach * m_links.spacing(i));
        std::uint32_t out = m_cells[i];
        forCrossings(i, m_cells[i], [&](std::uint32_t, std::uint32_t e, double distance) {
            if (m_links.link(e).cut == Cut::Crease && distance < least) {
                least = distance;
                out = m_cells[m_links.link(e).other];
            }
        });
        return out;
    }
    /// By the means of both sides around: single links say little where points are noisy.
    Meeting meeting(std::uint32_t i, std::uint32_t partner) const {
        struct Side {
            Vec3d place, normal;
            double count = 0;
        } own, across;
        const auto add = [&](std::uint32_t j) {
            Side* side = m_cells[j] == m_cells[i] ? &own : m_cells[j] == partner ? &across : nullptr;
            if (!side)
                return;
            side->place += m_links.at(j);
            side->normal += base::cast<double>(m_normals[j]);
            ++side->count;
        };
        add(i);
        for (const std::uint32_t j : m_links.near(i))
            add(j);
        if (across.count == 0)
            return Meeting::Convex;
        const Vec3d way = across.place / across.count - own.place / own.count;
        return dot(own.normal / own.count - across.normal / across.count, way) > 0 ? Meeting::Concave : Meeting::Convex;
    }
    std::uint32_t faceOf(std::uint32_t i, std::uint32_t cell) const {
        std::uint32_t out = m_faces[i];
        forCrossings(i, cell, [&](std::uint32_t, std::uint32_t e, double) { out = m_faces[m_links.link(e).other]; });
        return out;
    }

    const SurfelLinks& m_links;
    std::span<const std::uint32_t> m_cells, m_faces;
    std::span<const base::Vec3f> m_normals;
    double m_sharpness;
};

} // namespace

void labelByLinks(const SurfelLinks& links, std::span<const std::uint32_t> cells, std::span<const std::uint32_t> faces,
                  std::span<const base::Vec3f> normals, double sharpness, std::span<Label> labels) {
    const LinkLabels labeller(links, cells, faces, normals, sharpness);
    base::parallelFor(links.size(), 512,
                      [&](std::size_t i) { labeller.label(static_cast<std::uint32_t>(i), labels[i]); });
}

} // namespace cells
