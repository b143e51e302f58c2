#include "core/cells/cell_source_float.h"

#include "core/base/clones.h"
#include "core/surface/evaluation/assemble.h"
#include "core/surface/evaluation/weights.h"
#include "core/surfel/shape.h"

#include <bit>
#include <cmath>

namespace cells {

using base::Vec3d, base::Vec3f;
using surface::Need;

namespace {

constexpr int lanes = surfel::clusterSize;
constexpr float slack = 0.35f; ///< of the scale: how far around a position parts are collected

template <class E>
void take(const E& from, CellField& to) {
    to.status = from.status;
    to.weight = static_cast<double>(from.weight);
    to.value = static_cast<double>(from.value);
    to.offCentre = static_cast<double>(from.offCentre);
    to.unit = static_cast<double>(from.unit);
    to.agreement = static_cast<double>(from.agreement);
    to.centroid = base::cast<double>(from.centroid);
    to.normal = base::cast<double>(from.normal);
    to.gradient = base::cast<double>(from.gradient);
}

/// A table, as the compiler does not make vectors of shifts.
constexpr int bitOf[lanes] = {1,      1 << 1, 1 << 2,  1 << 3,  1 << 4,  1 << 5,  1 << 6,  1 << 7,
                              1 << 8, 1 << 9, 1 << 10, 1 << 11, 1 << 12, 1 << 13, 1 << 14, 1 << 15};

/// For each cluster a bit for each surfel with weight at x, supports multiplied by `scale`; `shape` as in SumOptions.
POINTCLAY_CLONES
void inSupport(const float* const* clusters, std::size_t count, float x, float y, float z, float scale, int shape,
               std::uint16_t* out) {
    for (std::size_t k = 0; k < count; ++k) {
        const float* c = clusters[k];
        float beyond[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const float dx = c[surfel::X * lanes + lane] - x, dy = c[surfel::Y * lanes + lane] - y;
            const float dz = c[surfel::Z * lanes + lane] - z, h = scale * c[surfel::Support * lanes + lane];
            beyond[lane] = dx * dx + dy * dy + dz * dz - h * h;
        }
        if (shape > 0)
            for (int lane = 0; lane < lanes; ++lane) {
                const float* b = c + shape * lanes;
                const float along = (c[surfel::X * lanes + lane] - x) * b[lane] +
                                    (c[surfel::Y * lanes + lane] - y) * b[lane + lanes] +
                                    (c[surfel::Z * lanes + lane] - z) * b[lane + 2 * lanes];
                beyond[lane] += along * along;
            }
        int bits = 0;
        for (int lane = 0; lane < lanes; ++lane)
            bits |= beyond[lane] < 0 ? bitOf[lane] : 0;
        out[k] = static_cast<std::uint16_t>(bits);
    }
}

/// fn(position, normal, distanceSq, support) for these lanes of a cluster.
template <class Fn>
void forLanes(const float* c, unsigned left, const Vec3f& x, float scale, int shape, const Fn& fn) {
    for (; left != 0; left &= left - 1) {
        const int lane = std::countr_zero(left);
        const auto of = [&](int channel) { return c[channel * lanes + lane]; };
        const Vec3f p{of(surfel::X), of(surfel::Y), of(surfel::Z)};
        const Vec3f b = shape > 0 ? Vec3f{of(shape), of(shape + 1), of(shape + 2)} : Vec3f();
        fn(p, Vec3f{of(surfel::NormalX), of(surfel::NormalY), of(surfel::NormalZ)}, surfel::shapedSq(p - x, b),
           scale * of(surfel::Support));
    }
}

} // namespace

CellSourcef::CellSourcef(const CellSurface& surface)
    : m_surface(&surface), m_source(surface.surface()), m_plain(surface.surface()), m_shape(m_plain.shape()) {}

void CellSourcef::moveTo(const Vec3d& x) {
    m_x = x;
    m_xf = base::cast<float>(x);
    m_met = false;
    if (!m_box.contains(m_xf))
        collect();
    gather();
}

/// Whatever may have weight about the position, by cell.
void CellSourcef::collect() {
    m_box = base::Box3f{m_xf, m_xf}.inflated(slack * m_scale);
    m_about.clear();
    const float reach = surface::queryReach(m_surface->surface().supportScale());
    const CellParts& parts = m_surface->parts();
    m_surface->surface().tree().forBlocksInSupport(
        m_box,
        [&](std::uint32_t number, const surfel::SurfelBlock& block) {
            for (unsigned left = block.boundsLanes().supporting(m_box, reach) & block.clusterMask(); left != 0;
                 left &= left - 1)
                for (const CellPart& part : parts.of(number, std::countr_zero(left)))
                    m_about.push_back(&part);
        },
        reach);
    std::stable_sort(m_about.begin(), m_about.end(),
                     [](const CellPart* a, const CellPart* b) { return a->cell < b->cell; });
    m_aboutChannels.clear();
    for (const CellPart* each : m_about)
        m_aboutChannels.push_back(each->channels);
    m_lanes.resize(m_about.size());
}

/// Of these what has weight at the position.
void CellSourcef::gather() {
    inSupport(m_aboutChannels.data(), m_aboutChannels.size(), m_xf.x, m_xf.y, m_xf.z,
              m_surface->surface().supportScale(), m_shape, m_lanes.data());
    m_found.clear();
    m_clusters.clear();
    m_near.clear();
    for (std::size_t k = 0; k < m_about.size(); ++k) {
        if (m_lanes[k] == 0)
            continue;
        const CellPart& part = *m_about[k];
        if (m_near.empty() || m_near.back().cell != part.cell) {
            Near& near = m_near.emplace_back();
            near.cell = part.cell;
            near.face = part.face;
            near.begin = static_cast<std::uint32_t>(m_found.size());
        }
        m_found.push_back({&part, m_lanes[k]});
        m_clusters.push_back(part.channels);
        m_near.back().end = static_cast<std::uint32_t>(m_found.size());
    }
    for (Near& a : m_near)
        for (const Near& b : m_near)
            a.joined |= a.cell != b.cell && a.face == b.face;
}

std::size_t CellSourcef::find(std::uint32_t cell) const {
    for (std::size_t i = 0; i < count(); ++i)
        if (this->cell(i) == cell)
            return i;
    return none;
}

/// What cell i's surfels say of the crease with another one: above zero convex, below concave.
double CellSourcef::votes(std::size_t i, std::uint32_t partner) const {
    double out = 0;
    const surface::Surface& surface = m_surface->surface();
    for (const Found& found : partsOf(i))
        for (const BesideCrease& each : found.part->beside)
            if (each.partner == partner)
                for (const bool convex : {true, false}) {
                    const unsigned signs = convex ? each.convex : ~static_cast<unsigned>(each.convex);
                    forLanes(found.part->channels, each.all & found.lanes & signs, m_xf, surface.supportScale(),
                             m_shape, [&](const Vec3f&, const Vec3f&, float distanceSq, float support) {
                                 const auto theta = static_cast<double>(
                                     surface::weightAt(surface.definition().weight, distanceSq, support));
                                 out += convex ? theta : -theta;
                             });
                }
    return out;
}

void CellSourcef::meet() {
    m_met = true;
    m_votes.assign(m_near.size() * m_near.size(), 0);
    m_faded.assign(m_votes.size(), {unknown, {}});
    // mostly all say the same, and their weights do not matter
    constexpr unsigned says[2] = {1, 2};
    m_said.assign(m_votes.size(), 0);
    for (std::size_t i = 0; i < m_near.size(); ++i)
        for (const Found& found : partsOf(i))
            for (const BesideCrease& each : found.part->beside) {
                const unsigned there = each.all & found.lanes, convex = there & each.convex;
                m_near[i].beside |= there != 0;
                if (const std::size_t j = there != 0 ? find(each.partner) : none; j != none)
                    m_said[i * m_near.size() + j] |=
                        static_cast<std::uint8_t>((convex != 0 ? says[0] : 0) | (convex != there ? says[1] : 0));
            }
    for (std::size_t i = 0; i < m_near.size(); ++i)
        for (std::size_t j = 0; j < m_near.size(); ++j) {
            const unsigned own = m_said[i * m_near.size() + j], other = m_said[j * m_near.size() + i];
            if (own != 0)
                vote(i, j) = (own | other) == says[0] ? 1 : (own | other) == says[1] ? -1 : votes(i, cell(j));
        }
}

std::vector<AbsentCell> CellSourcef::absent(std::size_t i) {
    std::vector<AbsentCell> out;
    const surface::Surface& surface = m_surface->surface();
    for (const Found& found : partsOf(i))
        for (const BesideCrease& each : found.part->beside) {
            const unsigned there = each.all & found.lanes;
            if (there == 0 || find(each.partner) != none)
                continue;
            for (unsigned left = there; left != 0; left &= left - 1) {
                const unsigned one = left & -left;
                Label label;
                label.cell = cell(i);
                label.partner = each.partner;
                label.meeting = (each.convex & one) != 0 ? Meeting::Convex : Meeting::Concave;
                if ((each.faded & one) != 0)
                    label.sharpness = each.sharpness(std::countr_zero(one));
                forLanes(found.part->channels, one, m_xf, surface.supportScale(), m_shape,
                         [&](const Vec3f&, const Vec3f&, float distanceSq, float support) {
                             AbsentCell::add(label,
                                             static_cast<double>(
                                                 surface::weightAt(surface.definition().weight, distanceSq, support)),
                                             out);
                         });
            }
        }
    return out;
}

CellSourcef::Share CellSourcef::shareOf(std::size_t i, std::size_t j) {
    if (j == i)
        return {1, {}};
    const bool oneFace = m_near[i].face == m_near[j].face;
    if (!oneFace && !m_surface->parts().fade())
        return {};
    if (meeting(i, j) == Meeting::None)
        return {oneFace ? 1.0 : 0.0, {}};
    Share& known = m_faded[std::min(i, j) * m_near.size() + std::max(i, j)];
    if (known.v == unknown)
        known = fadedShare(i, j);
    return known;
}

CellSourcef::Share CellSourcef::fadedShare(std::size_t i, std::size_t j) {
    m_fades.clear();
    bool faded = false;
    for (const auto& [a, b] : {std::pair(std::min(i, j), std::max(i, j)), std::pair(std::max(i, j), std::min(i, j))})
        for (const Found& found : partsOf(a))
            for (const BesideCrease& each : found.part->beside)
                if (each.fade && each.partner == cell(b) && (each.all & found.lanes) != 0) {
                    faded |= (each.faded & found.lanes) != 0;
                    m_fades.push_back(each.fade);
                }
    if (!faded)
        return {};
    surface::SumOptions options;
    options.weight = m_surface->surface().definition().weight;
    options.scale = m_surface->surface().supportScale();
    options.shape = m_shape;
    surface::Moments<float, 1> m;
    surface::sum(m_fades, m_xf, options, m);
    if (!(m.one.v > surface::leastWeight<float>))
        return {};
    const float k = m.n[0].v / m.one.v;
    Share out{1 - static_cast<double>(k), {}};
    for (std::size_t a = 0; a < 3; ++a)
        out.slope[a] = -static_cast<double>((m.n[0].d[a] - k * m.one.d[a]) / m.one.v);
    return out;
}

/// Of the cells with at least this share.
surface::ClusterSpan CellSourcef::clustersFrom(double share) {
    m_joined.clear();
    for (std::size_t j = 0; j < m_near.size(); ++j)
        if (m_shares[j].v >= share) {
            const surface::ClusterSpan clusters = clustersOf(j);
            m_joined.insert(m_joined.end(), clusters.begin(), clusters.end());
        }
    return m_joined;
}

surface::Evaluationf CellSourcef::evaluate(surface::ClusterSpan clusters, Need need) const {
    surface::Evaluationf out;
    if (m_plain.applies() && m_plain.evaluate(clusters, m_xf, need, out))
        return out;
    return need == Need::Value ? surface::Assembler<float, 0>(m_source, clusters, m_xf, {}).run()
                               : surface::Assembler<float, 1>(m_source, clusters, m_xf, {}).run();
}

void CellSourcef::sumOf(std::size_t i, Need need, CellField& out) {
    if (m_near.size() == 1 || (!m_near[i].joined && !m_surface->parts().fade()))
        return take(evaluate(clustersOf(i), need), out);
    m_shares.resize(m_near.size());
    bool whole = true;
    for (std::size_t j = 0; j < m_near.size(); ++j) {
        m_shares[j] = shareOf(i, j);
        whole &= m_shares[j].v <= 0 || m_shares[j].v >= 1;
    }
    if (whole)
        take(evaluate(clustersFrom(1), need), out);
    else
        layered(need, out);
}

/// As CellSource has it.
void CellSourcef::layered(Need need, CellField& out) {
    m_steps = m_shares;
    std::sort(m_steps.begin(), m_steps.end(), [](const Share& a, const Share& b) { return a.v > b.v; });
    surface::SumOptions options;
    options.weight = m_surface->surface().definition().weight;
    options.scale = m_surface->surface().supportScale();
    options.shape = m_shape;
    out = CellField();
    double total = 0;
    Vec3d totalSlope, sumSlope;
    for (std::size_t l = 0; l < m_steps.size(); ++l) {
        const Share next = l + 1 < m_steps.size() ? m_steps[l + 1] : Share();
        const double share = m_steps[l].v - next.v;
        if (!(share > 0))
            continue;
        const surface::ClusterSpan clusters = clustersFrom(m_steps[l].v);
        CellField e;
        const surface::Evaluationf found = evaluate(clusters, need);
        take(found, e);
        if (!valid(e))
            continue;
        const auto weight = static_cast<double>(found.weight);
        const double a = share * weight;
        total += a;
        out.status = surface::Status::Ok;
        out.value += a * e.value;
        out.centroid += e.centroid * a;
        out.normal += e.normal * a;
        out.unit += a * e.unit;
        out.agreement += a * e.agreement;
        if (need == Need::Value)
            continue;
        surface::Moments<float, 1> m;
        surface::sum(clusters, m_xf, options, m);
        const Vec3d slope = base::cast<double>(Vec3f{m.one.d[0], m.one.d[1], m.one.d[2]}) * share +
                            (m_steps[l].slope - next.slope) * weight;
        out.gradient += e.gradient * a;
        totalSlope += slope;
        sumSlope += slope * e.value;
    }
    if (!(total > static_cast<double>(surface::leastWeight<float>))) {
        out = CellField();
        return;
    }
    out.weight = total;
    out.value /= total;
    out.centroid = out.centroid / total;
    out.normal = base::normalized(out.normal);
    out.unit /= total;
    out.agreement /= total;
    out.offCentre = base::distance(m_x, out.centroid);
    if (need >= Need::Gradient)
        out.gradient = (out.gradient + sumSlope - totalSlope * out.value) / total;
}

const CellField& CellSourcef::at(std::size_t i, Need need) {
    Near& near = m_near[i];
    if (!near.known || near.need < need) {
        CellField found;
        sumOf(i, need, found);
        near.at = found;
        near.known = true;
        near.need = need;
    }
    return near.at;
}

CellSource::Tangent CellSourcef::tangent(std::size_t i) {
    const CellField& known = at(i, Need::Value);
    if (valid(known))
        return {known.normal, known.centroid, known.value};
    return sums(i).plane(m_x);
}

CellSource::Sums CellSourcef::sums(std::size_t i) const {
    CellSource::Sums out;
    const surface::Surface& surface = m_surface->surface();
    for (const Found& found : partsOf(i))
        forLanes(found.part->channels, found.lanes, m_xf, surface.supportScale(), m_shape,
                 [&](const Vec3f& position, const Vec3f& normal, float distanceSq, float support) {
                     const float theta = surface::weightAt(surface.definition().weight, distanceSq, support);
                     out.add(static_cast<double>(theta), base::cast<double>(position) - m_x,
                             base::cast<double>(normal));
                 });
    return out;
}

bool CellSourcef::reaches(std::size_t i) const {
    for (const float* cluster : clustersOf(i)) {
        std::uint16_t within = 0;
        inSupport(&cluster, 1, m_xf.x, m_xf.y, m_xf.z, surfel::surfaceReach * m_surface->surface().supportScale(),
                  m_shape, &within);
        if (within != 0)
            return true;
    }
    return false;
}

} // namespace cells
