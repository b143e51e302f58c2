#include "core/cells/cell_source.h"

#include "core/surface/evaluation/assemble.h"
#include "core/surface/evaluation/weights.h"
#include "core/surfel/shape.h"

namespace cells {

using base::Vec3d;
using surface::Evaluationd;
using surface::Need;

namespace {

constexpr std::size_t lanes = surfel::clusterSize;
constexpr float farAway = 1e15f; ///< of slots without a surfel, as in blocks: no weight, and finite squares

} // namespace

CellSource::CellSource(const CellSurface& surface)
    : m_surface(&surface), m_source(surface.surface()),
      m_shape(surfel::shapeChannel(*surface.surface().tree().layout())),
      m_clusterFloats(static_cast<std::size_t>(m_shape > 0 ? m_shape + 3 : surfel::Support + 1) * lanes) {}

void CellSource::moveTo(const Vec3d& x) {
    m_x = x;
    gather();
    m_votes.clear();
}

/// In tree order, whatever the box: sums over those that count have the same bits then.
void CellSource::collect() {
    const surface::Surface& surface = m_surface->surface();
    const float scale = surface.supportScale();
    const base::Vec3f nearest = base::cast<float>(m_x);
    const float size = std::max({std::abs(nearest.x), std::abs(nearest.y), std::abs(nearest.z)});
    const float inexact = 1e-6f * size;
    m_box = base::Box3d{m_x, m_x}.inflated(m_slack);
    m_around.clear();
    surface.tree().forClustersInSupport(
        base::Box3f{nearest, nearest}.inflated(static_cast<float>(m_slack) * 1.000001f + inexact),
        [&](const surfel::SurfelBlock& block, int cluster) {
            const int begin = cluster * surfel::clusterSize, end = std::min(begin + surfel::clusterSize, block.size());
            for (int slot = begin; slot < end; ++slot) {
                const double h = static_cast<double>(scale) * static_cast<double>(block.support(slot));
                const Vec3d p = base::cast<double>(block.position(slot));
                if (m_box.distanceSq(p) < h * h)
                    m_around.push_back({p, h * h, block.normal(slot), block.support(slot),
                                        surfel::shapeOf(block, slot, m_shape), m_surface->labels().at(block, slot)});
            }
        },
        surface::queryReach(surface::queryReach(scale)));
}

void CellSource::gather() {
    constexpr double slackOfSupport = 0.4; // steps of rays and projections are mostly shorter
    if (m_around.empty() || !m_box.contains(m_x))
        collect();
    m_found.clear();
    m_cells.clear();
    m_faded = false;
    for (const Around& each : m_around) {
        const Vec3d q = each.position - m_x;
        const double along = dot(base::cast<double>(each.shape), q), distanceSq = lengthSq(q) + along * along;
        if (!(distanceSq < each.supportSq))
            continue;
        const Label& label = each.label;
        auto at = std::lower_bound(m_cells.begin(), m_cells.end(), label.cell,
                                   [](const Near& near, std::uint32_t cell) { return near.cell < cell; });
        if (at == m_cells.end() || at->cell != label.cell) {
            const auto place = static_cast<std::uint32_t>(at - m_cells.begin());
            at = m_cells.insert(at, Near());
            at->cell = label.cell;
            at->face = label.face;
            for (Found& earlier : m_found)
                earlier.cell += earlier.cell >= place ? 1 : 0;
        }
        m_found.push_back({&each, static_cast<std::uint32_t>(at - m_cells.begin()), distanceSq});
        ++at->samples;
        at->beside |= label.meeting != Meeting::None;
        m_faded |= label.sharpness != 255;
    }
    if (!m_found.empty())
        m_slack = slackOfSupport * std::sqrt(m_found.front().of->supportSq);
}

double CellSource::weightOf(const Found& found) const {
    const surface::Surface& surface = m_surface->surface();
    return static_cast<double>(surface::weightAt(surface.definition().weight, static_cast<float>(found.distanceSq),
                                                 surface.supportScale() * found.of->support));
}

void CellSource::meet() const {
    m_votes.assign(m_cells.size() * m_cells.size(), 0);
    for (const Found& each : m_found) {
        if (each.of->label.meeting == Meeting::None)
            continue;
        const std::size_t j = find(each.of->label.partner);
        if (j == none)
            continue;
        const double theta = weightOf(each);
        vote(each.cell, j) += each.of->label.meeting == Meeting::Convex ? theta : -theta;
    }
}

std::size_t CellSource::find(std::uint32_t cell) const {
    const auto at = std::lower_bound(m_cells.begin(), m_cells.end(), cell,
                                     [](const Near& near, std::uint32_t label) { return near.cell < label; });
    return at == m_cells.end() || at->cell != cell ? none : static_cast<std::size_t>(at - m_cells.begin());
}

void AbsentCell::add(const Label& label, double theta, std::vector<AbsentCell>& all) {
    auto at = std::find_if(all.begin(), all.end(), [&](const AbsentCell& each) { return each.cell == label.partner; });
    if (at == all.end())
        at = all.insert(at, AbsentCell{label.partner});
    at->weight += theta;
    at->convex += label.meeting == Meeting::Convex ? theta : -theta;
    at->sharpness += theta * label.sharpness / 255;
}

std::vector<AbsentCell> CellSource::absent(std::size_t i) const {
    std::vector<AbsentCell> out;
    for (const Found& each : m_found)
        if (each.cell == i && each.of->label.meeting != Meeting::None && find(each.of->label.partner) == none)
            AbsentCell::add(each.of->label, weightOf(each), out);
    return out;
}

Meeting CellSource::meeting(std::size_t i, std::size_t j) const {
    if (m_votes.empty())
        meet();
    if (vote(i, j) == 0 && !m_cells[i].beside)
        return Meeting::None;
    const double convex = vote(i, j) + vote(j, i);
    return convex > 0 ? Meeting::Convex : convex < 0 ? Meeting::Concave : Meeting::None;
}

const Evaluationd& CellSource::at(std::size_t i, Need need) {
    Near& near = m_cells[i];
    if (!near.known || near.need < need) {
        const Evaluationd found = sumOf(i, need);
        near.at = found;
        near.need = need;
        near.known = true;
    }
    return near.at;
}

CellSource::Tangent CellSource::tangent(std::size_t i) {
    const Evaluationd& known = at(i, Need::Value);
    if (valid(known))
        return {known.normal, known.centroid, known.value};
    return sums(i).plane(m_x);
}

CellSource::Sums CellSource::sums(std::size_t i) const {
    Sums out;
    for (const Found& each : m_found)
        if (each.cell == i)
            out.add(weightOf(each), each.of->position - m_x, base::cast<double>(each.of->normal));
    return out;
}

bool CellSource::reaches(std::size_t i) const {
    constexpr auto reach = static_cast<double>(surfel::surfaceReach);
    return std::any_of(m_found.begin(), m_found.end(), [&](const Found& each) {
        return each.cell == i && each.distanceSq < reach * reach * each.of->supportSq;
    });
}

surface::SumOptions CellSource::plainSums() const {
    surface::SumOptions out;
    out.weight = m_surface->surface().definition().weight;
    out.scale = m_surface->surface().supportScale();
    out.shape = m_shape;
    return out;
}

template <class Take>
surface::ClusterSpan CellSource::pack(const Take& take) {
    m_packed.clear();
    m_clusters.clear();
    std::size_t count = 0;
    for (const Found& each : m_found) {
        const std::optional<base::Vec3f> normal = take(each);
        if (!normal)
            continue;
        if (count % lanes == 0) {
            m_packed.resize(m_packed.size() + m_clusterFloats);
            float* fresh = m_packed.data() + m_packed.size() - m_clusterFloats;
            std::fill_n(fresh, m_clusterFloats, 0.0f);
            std::fill_n(fresh, 3 * lanes, farAway);
            std::fill_n(fresh + surfel::Support * lanes, lanes, 1.0f);
        }
        float* c = m_packed.data() + m_packed.size() - m_clusterFloats + count % lanes;
        const base::Vec3f p = base::cast<float>(each.of->position);
        c[surfel::X * lanes] = p.x, c[surfel::Y * lanes] = p.y, c[surfel::Z * lanes] = p.z;
        c[surfel::NormalX * lanes] = normal->x, c[surfel::NormalY * lanes] = normal->y;
        c[surfel::NormalZ * lanes] = normal->z;
        c[surfel::Support * lanes] = each.of->support;
        for (std::size_t k = 0; m_shape > 0 && k < 3; ++k)
            c[(static_cast<std::size_t>(m_shape) + k) * lanes] = each.of->shape[k];
        ++count;
    }
    for (std::size_t at = 0; at < m_packed.size(); at += m_clusterFloats)
        m_clusters.push_back(m_packed.data() + at);
    return m_clusters;
}

Evaluationd CellSource::evaluate(surface::ClusterSpan clusters, Need need) const {
    switch (need) {
    case Need::Value:
        return surface::Assembler<double, 0>(m_source, clusters, m_x, {}).run();
    case Need::Gradient:
        return surface::Assembler<double, 1>(m_source, clusters, m_x, {}).run();
    case Need::Hessian:
        break;
    }
    return surface::Assembler<double, 2>(m_source, clusters, m_x, {}).run();
}

/// Of cells that meet in a crease what its sharpness leaves; without one, all of the same face and nothing of others.
CellSource::Share CellSource::shareOf(std::size_t i, std::size_t j) {
    if (!m_faded && m_cells[i].face != m_cells[j].face)
        return {};
    if (meeting(i, j) == Meeting::None)
        return {m_cells[i].face == m_cells[j].face ? 1.0 : 0.0, {}};
    if (!m_faded)
        return {};
    // the mean of the sharpness is a quotient of sums, one of them with it in place of a normal
    const auto beside = [&](const Found& f, std::size_t own, std::size_t other) {
        return f.cell == own && f.of->label.partner == m_cells[other].cell;
    };
    const bool faded = std::any_of(m_found.begin(), m_found.end(), [&](const Found& f) {
        return (beside(f, i, j) || beside(f, j, i)) && f.of->label.sharpness != 255;
    });
    if (!faded)
        return {};
    const surface::ClusterSpan clusters = pack([&](const Found& f) -> std::optional<base::Vec3f> {
        if (!beside(f, i, j) && !beside(f, j, i))
            return std::nullopt;
        return base::Vec3f{static_cast<float>(f.of->label.sharpness) / 255, 0, 0};
    });
    surface::Moments<double, 1> m;
    surface::sum(clusters, m_x, plainSums(), m);
    if (!(m.one.v > surface::leastWeight<double>))
        return {};
    const double k = m.n[0].v / m.one.v;
    Share out{1 - k, {}};
    for (std::size_t a = 0; a < 3; ++a)
        out.slope[a] = -(m.n[0].d[a] - k * m.one.d[a]) / m.one.v;
    return out;
}

Evaluationd CellSource::sumOf(std::size_t i, Need need) {
    if (m_cells.size() == 1)
        return m_source.evaluate(m_x, need);
    std::vector<Share> shares(m_cells.size());
    bool whole = true;
    for (std::size_t j = 0; j < m_cells.size(); ++j) {
        shares[j] = j == i ? Share{1, {}} : shareOf(i, j);
        whole &= shares[j].v <= 0 || shares[j].v >= 1;
    }
    if (!whole)
        return layered(shares, need);
    const auto counts = [&](const Found& f) -> std::optional<base::Vec3f> {
        if (!(shares[f.cell].v > 0))
            return std::nullopt;
        return f.of->normal;
    };
    return evaluate(pack(counts), need);
}

/// Sums with shares are put together of sums without: those over all cells with at least the largest share, the next
/// one and so on, each with what the share adds to the one before (cells/README 2.2).
Evaluationd CellSource::layered(const std::vector<Share>& shares, Need need) {
    std::vector<Share> steps = shares;
    std::sort(steps.begin(), steps.end(), [](const Share& a, const Share& b) { return a.v > b.v; });
    Evaluationd out;
    double total = 0;
    Vec3d totalSlope, sumSlope;
    for (std::size_t l = 0; l < steps.size(); ++l) {
        const Share next = l + 1 < steps.size() ? steps[l + 1] : Share();
        const double share = steps[l].v - next.v;
        if (!(share > 0))
            continue;
        const surface::ClusterSpan clusters = pack([&](const Found& f) -> std::optional<base::Vec3f> {
            if (shares[f.cell].v < steps[l].v)
                return std::nullopt;
            return f.of->normal;
        });
        const Evaluationd e = evaluate(clusters, need);
        if (!valid(e))
            continue;
        surface::Moments<double, 1> m;
        surface::sum(clusters, m_x, plainSums(), m);
        const double a = share * m.one.v;
        const Vec3d slope = Vec3d{m.one.d[0], m.one.d[1], m.one.d[2]} * share + (steps[l].slope - next.slope) * m.one.v;
        out.status = surface::Status::Ok;
        out.cause = surface::Cause::None;
        out.samples = std::max(out.samples, e.samples);
        out.weight += a;
        out.value += a * e.value;
        out.centroid += e.centroid * a;
        out.normal += e.normal * a;
        out.unit += a * e.unit;
        out.agreement += a * e.agreement;
        if (need >= Need::Gradient)
            out.gradient += e.gradient * a;
        if (need >= Need::Hessian)
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < 3; ++c)
                    out.hessian.m[r][c] += a * e.hessian.m[r][c];
        total += a;
        totalSlope += slope;
        sumSlope += slope * e.value;
    }
    if (!(total > surface::leastWeight<double>))
        return Evaluationd();
    out.value /= total;
    out.centroid = out.centroid / total;
    out.normal = base::normalized(out.normal);
    out.unit /= total;
    out.agreement /= total;
    out.offCentre = base::distance(m_x, out.centroid);
    if (need >= Need::Gradient)
        out.gradient = (out.gradient + sumSlope - totalSlope * out.value) / total;
    if (need >= Need::Hessian)
        for (auto& row : out.hessian.m)
            for (double& each : row)
                each /= total;
    return out;
}

} // namespace cells
