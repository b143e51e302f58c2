#include "core/mesh/marching/edge_walk.h"

namespace mesh {

using base::Vec3d, base::Vec3f;
using surface::Evaluationf;

namespace {

constexpr double steepest = 1.15;  ///< |f| over distance, at most (mesh/README 3.2)
constexpr double shortStep = 0.25; ///< of the spacing
constexpr double thoroughStep = 1 / 16.0;
constexpr int mostHalvings = 4;                        ///< of short steps, where unoriented normals turn
constexpr double turned = 0.7;                         ///< cosine below which they do
constexpr double rootHeight = 1e-3, goodHeight = 2e-4; ///< of |f|, in spacings: accepted, and no further step

/// What carries the frame's sign from a to b.
double signBetween(const SurfaceTraits& traits, const NodeValue& a, const NodeValue& b) {
    return traits.oriented || dot(a.normal, b.normal) >= 0 ? 1 : -1;
}

/// Are both values far larger than the distance between them?
bool farAway(const NodeValue& a, const NodeValue& b, double length) {
    const double fa = a.usable() ? std::abs(double(a.f)) : 0, fb = b.usable() ? std::abs(double(b.f)) : 0;
    return fa + fb > steepest * length;
}

/// Do the ends tell of one smooth sheet? Then they may be judged by signs alone.
bool smooth(const SurfaceTraits& traits, const Vec3d& direction, double length, const NodeValue& a,
            const NodeValue& b) {
    constexpr double alike = 0.9, flat = 0.12, deepest = 0.5; // cosine; of the length; of the error
    if (length > 1.05 * double(std::min(a.unit, b.unit)) * traits.spacingsPerUnit)
        return false;
    if (traits.oriented && double(std::min(a.agreement, b.agreement)) < alike)
        return false;
    const double side = signBetween(traits, a, b), fa = double(a.f), fb = side * double(b.f);
    if (double(dot(a.normal, b.normal)) * side < alike)
        return false;
    const double slopeA = dot(base::cast<double>(a.normal), direction);
    const double slopeB = side * dot(base::cast<double>(b.normal), direction);
    const double error = std::max(std::abs(fb - fa - slopeA * length), std::abs(fb - fa - slopeB * length));
    return error <= flat * length && (fa * fb < 0 || std::min(std::abs(fa), std::abs(fb)) > deepest * error);
}

} // namespace

bool EdgeWalk::passes(const SurfaceTraits& traits, const Edge& edge, const NodeValue& first, const NodeValue& last) {
    if (traits.distances && farAway(first, last, edge.length))
        return true;
    if (!first.usable() || !last.usable() || !smooth(traits, edge.direction, edge.length, first, last))
        return false;
    return (first.f < 0) == (signBetween(traits, first, last) * double(last.f) < 0);
}

NodeValue NodeValue::of(const Evaluationf& at) {
    if (!at.ok() && at.status != surface::Status::BeyondBoundary)
        return {};
    return {at.value, at.normal, at.unit, at.agreement};
}

std::optional<Crossing> EdgeWalk::run(const NodeValue& first, const NodeValue& last) {
    between({0, first}, {m_edge.length, last}, mostHalvings);
    return m_roots % 2 == 1 ? std::optional(m_best) : std::nullopt;
}

std::optional<Crossing> EdgeWalk::facing(int way, const NodeValue& first, const NodeValue& last) {
    m_way = way;
    between({0, first}, {m_edge.length, last}, mostHalvings);
    return m_roots > 0 ? std::optional(m_best) : std::nullopt;
}

EdgeWalk::Sample EdgeWalk::sample(double t) {
    Evaluationf at;
    m_source.evaluate(base::cast<float>(m_edge.from + m_edge.direction * t), surface::Need::Value, {}, at);
    return {t, NodeValue::of(at)};
}

double EdgeWalk::sign(const Sample& a, const Sample& b) const {
    return signBetween(m_traits, a.at, b.at);
}

void EdgeWalk::between(const Sample& a, const Sample& b, int halvings) {
    const double length = b.t - a.t;
    if (m_traits.distances && m_care == Care::Usual && farAway(a.at, b.at, length))
        return;
    const bool both = a.at.usable() && b.at.usable();
    const bool trusted = both && m_care == Care::Usual && smooth(m_traits, m_edge.direction, length, a.at, b.at);
    if (!trusted) {
        const double unit = double(a.at.usable() ? a.at.unit : b.at.unit);
        const double step = (m_care == Care::Thorough ? thoroughStep : shortStep) * m_traits.spacingsPerUnit * unit;
        const bool turns = both && !m_traits.oriented && std::abs(double(dot(a.at.normal, b.at.normal))) < turned;
        const bool coarse = unit > 0 ? length > step : length > m_edge.length / 4;
        if (coarse || (turns && halvings > 0)) {
            const Sample middle = sample(0.5 * (a.t + b.t));
            between(a, middle, coarse ? halvings : halvings - 1);
            between(middle, b, coarse ? halvings : halvings - 1);
            return;
        }
    }
    if (both && (a.at.f < 0) != (sign(a, b) * double(b.at.f) < 0))
        refine(a, b);
}

/// Newton's method along the edge within the bracket, else Illinois' false position, else halves.
void EdgeWalk::refine(Sample a, Sample b) {
    const Vec3f reference = a.at.normal;
    double fa = double(a.at.f), fb = sign(a, b) * double(b.at.f);
    double t = a.t + (b.t - a.t) * fa / (fa - fb);
    for (int i = 0; i < 40; ++i) {
        Evaluationf at;
        m_source.evaluate(base::cast<float>(m_edge.from + m_edge.direction * t), surface::Need::Gradient, {}, at);
        Sample c{t, NodeValue::of(at)};
        if (!c.at.usable())
            return;
        const double side = m_traits.oriented || dot(at.normal, reference) >= 0 ? 1 : -1;
        const double f = side * double(at.value);
        const double slope = side * dot(base::cast<double>(at.gradient), m_edge.direction);
        const double spacing = double(at.unit) * m_traits.spacingsPerUnit;
        const double step = std::abs(slope) > 1e-9 ? -f / slope : 0;
        if (std::abs(f) <= goodHeight * spacing) {
            const bool near = std::abs(step) <= 0.1 * spacing;
            return accept(std::clamp(t + (near ? step : 0), 0.0, m_edge.length), at);
        }
        if (b.t - a.t <= 1e-4 * spacing) {
            if (std::abs(f) <= rootHeight * spacing || (jumps(a, b) && onOwnSheet(t, at)))
                accept(t, at);
            return;
        }
        if ((f < 0) == (fa < 0)) {
            a = c, fa = f;
            fb *= i % 3 == 2 ? 0.5 : 1;
        } else {
            b = c, fb = f;
            fa *= i % 3 == 2 ? 0.5 : 1;
        }
        t = std::abs(slope) > 0.05 && i < 6 ? t + step : a.t + (b.t - a.t) * fa / (fa - fb);
        const double margin = 1e-3 * (b.t - a.t);
        if (!(t > a.t + margin && t < b.t - margin) || i > 12)
            t = 0.5 * (a.t + b.t);
    }
}

/// A step of f where the second pass for near sheets of some frames sets in: the ray caster takes it for surface too
/// (ray_roots.h).
bool EdgeWalk::jumps(const Sample& a, const Sample& b) const {
    constexpr double widest = 0.1, steady = 0.9; // of h; least cosine of the normals
    const double side = sign(a, b), step = side * double(b.at.f) - double(a.at.f);
    const double along = dot(base::cast<double>(a.at.normal), m_edge.direction);
    const double behind = side * dot(base::cast<double>(b.at.normal), m_edge.direction);
    return side * double(dot(a.at.normal, b.at.normal)) >= steady && along * step > 0 && behind * step > 0 &&
           std::abs(step) <= widest * double(b.at.unit);
}

/// Is the sheet that faces as f does there surface by itself, and near? Beside a step f may be steep for no longer than
/// the step is wide.
bool EdgeWalk::onOwnSheet(double t, const Evaluationf& at) {
    const surface::OrientationHint sheet{base::normalized(at.gradient)};
    Evaluationf own;
    m_source.evaluate(base::cast<float>(m_edge.from + m_edge.direction * t), surface::Need::Gradient, sheet, own);
    const float slope = dot(own.normal, own.gradient);
    return surface::isSurface(own) &&
           std::abs(own.value) <= static_cast<float>(0.5 * m_traits.spacingsPerUnit) * own.unit * slope;
}

void EdgeWalk::accept(double t, const Evaluationf& at) {
    if (!surface::isSurface(at) || m_way * dot(base::cast<double>(at.gradient), m_edge.direction) < 0)
        return;
    const float offCentre = at.offCentre / at.unit;
    if (m_roots++ > 0 && offCentre >= m_best.offCentre)
        return;
    m_best = {m_edge.from + m_edge.direction * t, base::normalized(at.gradient), at.unit, offCentre, false};
}

} // namespace mesh
