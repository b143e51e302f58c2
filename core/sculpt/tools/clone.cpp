#include "core/sculpt/tools/clone.h"

#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sculpt {

/// Inner radius of the ring that the base planes are means of, in radii.
constexpr float ring = 0.7f;
/// Slopes of the source are told up to here: beyond, it is a cliff.
constexpr float steepest = 5;
/// What lies further than this from the base plane, in radii, is another part of the model and no relief; from half of
/// it on the copy fades.
constexpr float highest = 0.7f;

constexpr ToolParameter parameters[] = {
    {"x", "Source x", "model units", "Where to copy from, relative to the stroke's first contact.", 0, -1e6, 1e6,
     ParameterKind::SourceX},
    {"y", "Source y", "model units", "Where to copy from, relative to the stroke's first contact.", 0, -1e6, 1e6,
     ParameterKind::SourceY},
    {"z", "Source z", "model units", "Where to copy from, relative to the stroke's first contact.", 0, -1e6, 1e6,
     ParameterKind::SourceZ},
};

namespace {

/// A place on the surface and the plane that its relief stands on.
struct Base {
    base::Vec3f place, normal;
    float height; ///< normal . (plane - place)
};

/// Nothing where the model has no surface near `x`, or none that is one sheet.
std::optional<Base> baseAt(const surface::Surface& first, const base::Vec3f& x, const base::Vec3f& facing,
                           float radius) {
    const auto foot = surface::project(first, x, {}, {facing});
    if (!foot.ok() || distance(foot.foot, x) > 2 * radius)
        return {};
    const bool oriented = first.tree().layout()->oriented;
    base::Vec3f up = normalized(foot.at.gradient);
    if (!oriented && dot(up, facing) < 0)
        up = -up;
    base::Vec3d position, normal;
    double count = 0;
    first.tree().forBlocksInBall(foot.foot, radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const float l = distance(block.position(slot), foot.foot), c = dot(block.normal(slot), up);
            if (l < ring * radius || l >= radius || (oriented ? c : std::abs(c)) < 0.17f)
                continue;
            position += base::cast<double>(block.position(slot) - foot.foot);
            normal += base::cast<double>(block.normal(slot)) * (c < 0 ? -1.0 : 1.0);
            count += 1;
        }
    });
    if (count < 6)
        return {};
    const base::Vec3f n = base::cast<float>(normalized(normal, base::cast<double>(up)));
    return Base{foot.foot, n, dot(n, base::cast<float>(position / count))};
}

/// The smallest rotation that takes the unit vector a to b; half a turn about some axis where they are opposite.
base::Mat3f rotation(const base::Vec3f& a, const base::Vec3f& b) {
    const float c = dot(a, b);
    if (c < -0.9999f) {
        const base::Vec3f axis = perpendicular(a);
        return outer(axis, axis) * 2 - base::Mat3f::identity();
    }
    const base::Vec3f h = a + b;
    return base::Mat3f::identity() - outer(h, h) * (1 / (1 + c)) + outer(b, a) * 2;
}

/// 1 - smoothstep of a height, and its derivative.
struct Fade {
    float value = 1, slope = 0;

    Fade(float height, float radius) {
        const float from = 0.5f * highest * radius, t = (std::abs(height) - from) / from;
        if (t <= 0)
            return;
        value = t < 1 ? (1 - t) * (1 - t) * (1 + 2 * t) : 0.0f;
        slope = t < 1 ? 6 * t * (t - 1) / from * (height < 0 ? -1.0f : 1.0f) : 0.0f;
    }
};

/// Where relief comes from and where it goes.
struct Copy {
    const surface::Surface& first;
    base::Vec3f centre; ///< of the brush
    Base from, to;
    base::Mat3f turn; ///< directions here to directions there
    float radius, sign;

    base::Rayf ray(const base::Vec3f& p) const {
        const base::Vec3f d = p - centre, flat = d - to.normal * dot(to.normal, d);
        return {from.place + turn * flat + from.normal * radius, -from.normal};
    }
    /// (+-h - z) fade(h) fade(z), and its gradient.
    float gap(const base::Vec3f& p, const surface::RayHit<float>& hit, base::Vec3f& slope) const {
        const float h = dot(from.normal, hit.position - from.place) - from.height;
        const float z = dot(to.normal, p - to.place) - to.height;
        const float c = dot(hit.normal, from.normal);
        const base::Vec3f flat = hit.normal - from.normal * c;
        const base::Vec3f rise = transposed(turn) * flat * (-1 / std::max(c, 1 / steepest)), up = to.normal;
        const Fade there(h, radius), here(z, radius);
        const float gap = sign * h - z;
        slope = (rise * sign - up) * (there.value * here.value) +
                (rise * (there.slope * here.value) + up * (there.value * here.slope)) * gap;
        return gap * there.value * here.value;
    }
};

std::optional<Copy> copyOf(const surface::Surface& first, const Dab& dab) {
    const base::Vec3f away = dab.image * base::Vec3f{dab.parameter("x"), dab.parameter("y"), dab.parameter("z")};
    const auto start = baseAt(first, dab.anchor, dab.anchorNormal, dab.radius);
    const auto origin = baseAt(first, dab.anchor + away, dab.anchorNormal, dab.radius);
    const auto to = baseAt(first, dab.centre, dab.areaNormal, dab.radius);
    if (away == base::Vec3f{} || !start || !origin || !to)
        return {};
    const base::Vec3f way = rotation(start->normal, origin->normal) * (to->place - start->place);
    const auto from = baseAt(first, origin->place + way, origin->normal, dab.radius);
    if (!from)
        return {};
    return Copy{
        first, dab.centre, *from, *to, rotation(to->normal, from->normal), dab.radius, dab.strength < 0 ? -1.0f : 1.0f};
}

} // namespace

static tree::Edit clone(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    if (dab.strength == 0)
        return {};
    const surface::Surface& first = dab.first ? *dab.first : version;
    const auto copy = copyOf(first, dab);
    if (!copy)
        return {};
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    const Gathered list = gather(blocks, brush);
    std::vector<base::Rayf> rays;
    for (const base::Vec3f& p : list.places)
        rays.push_back(copy->ray(p));
    std::vector<surface::RayHit<float>> hits(rays.size());
    surface::IntersectOptions options;
    options.tMax = 2 * dab.radius;
    surface::intersect(first, rays, options, hits);
    const float full = std::min(1.0f, std::abs(dab.strength));
    return deform(version.tree(), blocks, brush, [&](const LanePlace& where, const BrushLanes& at, ShiftLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        out.clear();
        list.forCluster(where.index, where.cluster, [&](std::size_t i, std::size_t lane) {
            if (!hits[i].hit)
                return;
            const base::Vec3f n = copy->to.normal, from{at.x[lane], at.y[lane], at.z[lane]};
            base::Vec3f slope;
            const float gap = copy->gap(list.places[i], hits[i], slope);
            const base::Vec3f g = (from * (gradient[lane] * gap) + slope * weight[lane]) * full;
            out.set(lane, n * (full * weight[lane] * gap), outer(n, g));
        });
    });
}

const ToolRow cloneTool{"clone",
                        "Clone",
                        "icons/tool-clone.svg",
                        "",
                        "Copies the relief of another place; inverted, its negative.",
                        Motion::Along,
                        1.0,
                        parameters,
                        clone,
                        Writes::Surface,
                        {.source = true}};

} // namespace sculpt
