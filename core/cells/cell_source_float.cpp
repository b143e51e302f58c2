#include "core/cells/cell_source_float.h"

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
constexpr std::size_t mostCubes = 256, mostWide = 64; ///< kept
constexpr int widening = 2;                           ///< of the cubes that others are packed from, as a power of two

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

/// fn(position, normal, distanceSq, support) for surfels of clusters with weight at x; `shape` as in SumOptions.
template <class Fn>
void forPacked(surface::ClusterSpan clusters, const Vec3f& x, float scale, int shape, const Fn& fn) {
    for (const float* c : clusters)
        for (int lane = 0; lane < lanes; ++lane) {
            const auto of = [&](int channel) { return c[channel * lanes + lane]; };
            const Vec3f p{of(surfel::X), of(surfel::Y), of(surfel::Z)};
            const float h = scale * of(surfel::Support);
            const Vec3f b = shape > 0 ? Vec3f{of(shape), of(shape + 1), of(shape + 2)} : Vec3f();
            const float distanceSq = surfel::shapedSq(p - x, b);
            if (distanceSq < h * h)
                fn(p, Vec3f{of(surfel::NormalX), of(surfel::NormalY), of(surfel::NormalZ)}, distanceSq, h);
        }
}

bool anyPacked(surface::ClusterSpan clusters, const Vec3f& x, float scale, int shape) {
    if (shape > 0) {
        bool any = false;
        forPacked(clusters, x, scale, shape, [&](const Vec3f&, const Vec3f&, float, float) { any = true; });
        return any;
    }
    for (const float* c : clusters) {
        float nearest = 0; // below zero within a support
        for (int lane = 0; lane < lanes; ++lane) {
            const float dx = c[surfel::X * lanes + lane] - x.x, dy = c[surfel::Y * lanes + lane] - x.y;
            const float dz = c[surfel::Z * lanes + lane] - x.z, h = scale * c[surfel::Support * lanes + lane];
            nearest = std::min(nearest, dx * dx + dy * dy + dz * dz - h * h);
        }
        if (nearest < 0)
            return true;
    }
    return false;
}

} // namespace

std::size_t CellSourcef::CubeHash::operator()(const Cube& cube) const {
    std::uint64_t out = base::mix(static_cast<std::uint64_t>(cube.exponent));
    for (const std::int64_t each : cube.at)
        out = base::mix(out ^ static_cast<std::uint64_t>(each));
    return out;
}

CellSourcef::CellSourcef(const CellSurface& surface)
    : m_surface(&surface), m_source(surface.surface()), m_plain(surface.surface()), m_shape(m_plain.shape()) {}

void CellSourcef::setScale(double support) {
    m_exponent = std::ilogb(support) - 1;
}

/// With what float32 leaves of its coordinates, whichever of its places is asked for.
base::Box3f CellSourcef::boxOf(const Cube& cube) {
    const double side = std::ldexp(1.0, cube.exponent);
    base::Box3f box;
    double size = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        box.lo[a] = static_cast<float>(static_cast<double>(cube.at[a]) * side);
        box.hi[a] = static_cast<float>(static_cast<double>(cube.at[a] + 1) * side);
        size = std::max({size, static_cast<double>(std::abs(box.lo[a])), static_cast<double>(std::abs(box.hi[a]))});
    }
    return box.inflated(static_cast<float>(size * 1e-7));
}

const CellSurfels& CellSourcef::surfelsAbout(const Cube& cube) {
    Cube wide = cube;
    wide.exponent += widening;
    for (std::int64_t& each : wide.at)
        each >>= widening; // towards minus infinity
    auto found = m_wide.find(wide);
    if (found == m_wide.end()) {
        if (m_wide.size() >= mostWide)
            m_wide.clear();
        found = m_wide.try_emplace(wide, *m_surface, boxOf(wide)).first;
    }
    return found->second;
}

void CellSourcef::moveTo(const Vec3d& x) {
    m_x = x;
    m_xf = base::cast<float>(x);
    m_met = false;
    // cubes that float32 still tells apart
    const double far = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    Cube cube;
    cube.exponent = std::max(m_exponent, far > 0 ? std::ilogb(far) - 22 : m_exponent);
    const double side = std::ldexp(1.0, cube.exponent);
    for (std::size_t a = 0; a < 3; ++a)
        cube.at[a] = static_cast<std::int64_t>(std::floor(x[a] / side));
    if (!m_cube || !(cube == m_which)) {
        auto found = m_cubes.find(cube);
        if (found == m_cubes.end()) {
            if (m_cubes.size() >= mostCubes)
                m_cubes.clear();
            found = m_cubes.try_emplace(cube, surfelsAbout(cube), boxOf(cube)).first;
        }
        m_cube = &found->second;
        m_which = cube;
    }
    m_near.assign(m_cube->cells().size(), Near());
}

std::size_t CellSourcef::find(std::uint32_t cell) const {
    for (std::size_t i = 0; i < count(); ++i)
        if (this->cell(i) == cell)
            return i;
    return none;
}

bool CellSourcef::there(std::size_t i) {
    Near& near = m_near[i];
    if (!near.counted) {
        near.counted = true;
        near.there =
            anyPacked(m_cube->clusters(m_cube->cells()[i]), m_xf, m_surface->surface().supportScale(), m_shape);
    }
    return near.there;
}

bool CellSourcef::alone() {
    int found = 0;
    for (std::size_t i = 0; i < m_near.size() && found < 2; ++i)
        found += there(i) ? 1 : 0;
    return found == 1;
}

void CellSourcef::meet() {
    m_met = true;
    m_votes.assign(m_near.size() * m_near.size(), 0);
    for (const CellClusters::Beside& each : m_cube->beside()) {
        const float distanceSq = surfel::shapedSq(each.position - m_xf, each.shape);
        if (!(distanceSq < each.support * each.support))
            continue;
        m_near[each.own].beside = true;
        if (each.partner >= m_near.size() || !there(each.partner))
            continue;
        const auto theta =
            static_cast<double>(surface::weightAt(m_surface->surface().definition().weight, distanceSq, each.support));
        vote(each.own, each.partner) += each.label.meeting == Meeting::Convex ? theta : -theta;
    }
}

std::vector<AbsentCell> CellSourcef::absent(std::size_t i) {
    std::vector<AbsentCell> out;
    for (const CellClusters::Beside& each : m_cube->beside()) {
        if (each.own != i || (each.partner < m_near.size() && there(each.partner)))
            continue;
        const float distanceSq = surfel::shapedSq(each.position - m_xf, each.shape);
        if (distanceSq < each.support * each.support)
            AbsentCell::add(each.label,
                            static_cast<double>(
                                surface::weightAt(m_surface->surface().definition().weight, distanceSq, each.support)),
                            out);
    }
    return out;
}

Meeting CellSourcef::meeting(std::size_t i, std::size_t j) {
    if (!m_met)
        meet();
    if (vote(i, j) == 0 && !m_near[i].beside)
        return Meeting::None;
    const double convex = vote(i, j) + vote(j, i);
    return convex > 0 ? Meeting::Convex : convex < 0 ? Meeting::Concave : Meeting::None;
}

double CellSourcef::sharpness(std::size_t i, std::size_t j) {
    return meeting(i, j) == Meeting::None ? 0 : 1 - shareOf(i, j).v;
}

CellSourcef::Share CellSourcef::shareOf(std::size_t i, std::size_t j) {
    if (j == i)
        return {1, {}};
    const std::span<const CellClusters::Cell> cells = m_cube->cells();
    const std::span<const CellClusters::Fade> fades = m_cube->fades();
    const bool oneFace = cells[i].face == cells[j].face;
    if (!oneFace && fades.empty())
        return {};
    if (meeting(i, j) == Meeting::None)
        return {oneFace ? 1.0 : 0.0, {}};
    const auto fade = std::find_if(fades.begin(), fades.end(), [&](const CellClusters::Fade& each) {
        return each.a == std::min(i, j) && each.b == std::max(i, j);
    });
    if (fade == fades.end())
        return {};
    surface::SumOptions options;
    options.weight = m_surface->surface().definition().weight;
    options.scale = m_surface->surface().supportScale();
    options.shape = m_shape;
    surface::Moments<float, 1> m;
    surface::sum(m_cube->clusters(*fade), m_xf, options, m);
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
            const surface::ClusterSpan clusters = m_cube->clusters(m_cube->cells()[j]);
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
    const CellClusters::Cell& own = m_cube->cells()[i];
    if (!own.joined && m_cube->fades().empty())
        return take(evaluate(m_cube->clusters(own), need), out);
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
    forPacked(m_cube->clusters(m_cube->cells()[i]), m_xf, surface.supportScale(), m_shape,
              [&](const Vec3f& position, const Vec3f& normal, float distanceSq, float support) {
                  const float theta = surface::weightAt(surface.definition().weight, distanceSq, support);
                  out.add(static_cast<double>(theta), base::cast<double>(position) - m_x, base::cast<double>(normal));
              });
    return out;
}

bool CellSourcef::reaches(std::size_t i) const {
    return anyPacked(m_cube->clusters(m_cube->cells()[i]), m_xf,
                     surfel::surfaceReach * m_surface->surface().supportScale(), m_shape);
}

} // namespace cells
