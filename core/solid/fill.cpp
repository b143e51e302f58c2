#include "core/solid/fill.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/relief.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/definition_text.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"

#include <numbers>

namespace solid {

using base::Vec3d;
using base::Vec3f;

namespace {

/// Patches of more vertices are shaped coarser, and their edges halved.
constexpr double mostShaped = 20000;

/// What surfels carry at the loop's points.
struct Carried {
    std::vector<std::vector<double>> numbers; ///< support and channels of the colour
    std::vector<std::uint32_t> words;         ///< layout->words() each
};

Carried carriedAt(const surface::Surface& surface, const Loop& loop) {
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    Carried out{{}, std::vector<std::uint32_t>(loop.size() * layout.words(), 0)};
    for (std::size_t i = 0; i < loop.size(); ++i) {
        surface::AttributeSum sum(layout);
        surface::forWeights(
            surface, base::cast<float>(loop.points[i].position),
            [&](const surfel::SurfelBlock& block, int slot, float theta) { sum.add(block, slot, theta); });
        const surfel::Colour colour = sum.any() ? sum.colour() : surfel::white;
        std::vector<double> numbers{loop.points[i].support};
        for (unsigned shift = 0; shift < 32; shift += 8)
            numbers.push_back(static_cast<double>(colour >> shift & 255u));
        out.numbers.push_back(std::move(numbers));
        if (sum.any() && layout.words() > 0)
            sum.further({out.words.data() + i * layout.words(), layout.words()});
    }
    return out;
}

/// Stands there already a surfel that faces the same way?
bool taken(const tree::SurfelTree& tree, const Vec3d& p, const Vec3d& normal, double within, bool oriented) {
    const Vec3f x = base::cast<float>(p);
    std::vector<tree::Neighbour> near;
    tree.nearest(x, 4, near, static_cast<float>(within));
    return std::any_of(near.begin(), near.end(), [&](const tree::Neighbour& each) {
        const double agreement = dot(base::cast<double>(each.block->normal(each.slot)), normal);
        return !oriented || agreement > 0.17; // one sheet: process/README 4.1
    });
}

class Filler {
  public:
    explicit Filler(const surface::Surface& surface) : m_surface(surface) {
        m_out.layout = surface.tree().layout();
        m_oriented = m_out.layout->normals && m_out.layout->oriented;
    }

    void fill(const surface::BoundaryCurve& curve, Loop loop, const FillOptions& options, LoopFate& fate,
              const base::Progress& progress) {
        const double wanted = areaOver(loop) / (loop.meanSpacing() * loop.meanSpacing());
        const int halvings = std::max(0, static_cast<int>(std::ceil(std::log(wanted / mostShaped) / std::log(4.0))));
        if (halvings > 0)
            loop = evenLoop(m_surface, curve, std::exp2(halvings));
        for (LoopPoint& p : loop.points)
            p.spacing *= std::exp2(halvings);
        Patch patch = patchOver(loop, process::part(progress, 0, 0.5));
        const base::Progress rest = process::part(progress, 0.5, 1);
        const Shape shape = options.shape;
        if (shape == Shape::Flat || !shapePatch(m_surface, loop, shape, patch, rest)) {
            fate.flattened = shape != Shape::Flat;
            shapePatch(m_surface, loop, Shape::Flat, patch, rest);
        }
        add(loop, std::move(patch), halvings, options.relief && !fate.flattened, fate);
    }
    const surfel::SurfelList& surfels() const { return m_out; }

  private:
    void add(const Loop& loop, Patch patch, int halvings, bool relief, LoopFate& fate) {
        const Carried carried = carriedAt(m_surface, loop);
        std::vector<std::vector<double>> numbers = spreadOver(patch, carried.numbers);
        const std::vector<std::uint32_t> nearest = nearestOfLoop(patch);
        std::vector<Vec3d> normals = patchNormals(loop, patch);
        Patch fine = patch;
        halveEdges(fine, normals, halvings);
        if (relief)
            fate.plain = followRelief(m_surface, loop, patch, fine, normals) == ReliefFate::TooLittle;
        const std::vector<std::uint32_t> from = sources(patch, halvings);
        const std::size_t words = m_out.layout->words();
        for (std::size_t v = 0; v < fine.positions.size(); ++v) {
            const Vec3d& p = fine.positions[v];
            if (taken(m_surface.tree(), p, normals[v], 0.65 * fine.spacings[v], m_oriented))
                continue;
            const std::vector<double>& number = numbers[from[v]];
            surfel::Surfel s;
            s.position = base::cast<float>(p);
            s.normal = base::cast<float>(m_out.layout->normals ? normals[v] : Vec3d{});
            s.support = static_cast<float>(number[0]);
            s.colour = 0;
            for (unsigned k = 0; k < 4; ++k)
                s.colour |= static_cast<unsigned>(std::clamp(std::lround(number[k + 1]), 0L, 255L)) << 8 * k;
            m_out.append(s, {carried.words.data() + nearest[from[v]] * words, words});
            ++fate.surfels;
        }
    }
    /// Of each vertex after `halvings` one of those before it that it lies beside.
    static std::vector<std::uint32_t> sources(Patch patch, int halvings) {
        std::vector<std::uint32_t> out(patch.positions.size());
        for (std::uint32_t v = 0; v < out.size(); ++v)
            out[v] = v;
        for (int level = 0; level < halvings; ++level) {
            const std::vector<mesh::Triangle> coarse = patch.triangles;
            std::vector<Vec3d> unused(patch.positions.size());
            halveEdges(patch, unused, 1);
            out.resize(patch.positions.size(), 0);
            for (std::size_t t = 0; t < coarse.size(); ++t) // the triangle in the middle comes last of four
                for (std::size_t k = 0; k < 3; ++k)
                    out[patch.triangles[4 * t + 3][k]] = out[coarse[t][k]];
        }
        return out;
    }

    const surface::Surface& m_surface;
    surfel::SurfelList m_out;
    bool m_oriented = false;
};

void check(const surface::Surface& surface) {
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) + " has no holes to fill", "fill",
                          "open the model as a surface");
    if (!std::isfinite(surface.definition().boundaryLimit))
        throw base::Error("the surface has no boundary: it is closed, or its boundary limit is none", "fill",
                          "give it a limit, 0.25 for example, if it has holes");
}

} // namespace

Filled fillHoles(const surface::Surface& surface, const FillOptions& options, const base::Progress& progress) {
    check(surface);
    const base::CancelScope scope(progress.cancel);
    const std::vector<surface::BoundaryCurve> curves =
        surface::findBoundaryCurves(surface, process::part(progress, 0, 0.4));
    if (options.only && *options.only >= curves.size())
        throw base::Error("there is no boundary loop number " + std::to_string(*options.only), "fill",
                          std::to_string(curves.size()) + " were found; they count from 0");
    Filled out{surface, {}};
    std::vector<Loop> loops;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        loops.push_back(evenLoop(surface, curves[i]));
        LoopFate fate{i, loops[i].middle, curves[i].length()};
        fate.asked =
            fate.length <= options.longest && !(options.keepLargest && i == 0) && (!options.only || *options.only == i);
        if (!curves[i].closed)
            fate.why = "it does not close";
        out.loops.push_back(fate);
    }
    const std::vector<std::uint8_t> touches = touching(loops);
    Filler filler(surface);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        LoopFate& fate = out.loops[i];
        if (curves[i].closed && touches[i])
            fate.why = "it touches itself or another one";
        if (fate.asked && fate.why[0] == 0)
            filler.fill(curves[i], std::move(loops[i]), options, fate,
                        process::part(progress, 0.4 + 0.5 * double(i) / double(curves.size()),
                                      0.4 + 0.5 * double(i + 1) / double(curves.size())));
    }
    tree::Edit edit;
    edit.inserted = filler.surfels();
    if (edit.inserted.size() == 0)
        return out;
    surface::SurfaceDefinition definition = surface.definition();
    out.surface = {surface.tree().apply(edit), definition};
    if (definition.boundary == surface::Boundary::Auto) {
        definition.boundaryLimit = process::automaticBoundaryLimit(out.surface, process::part(progress, 0.9, 1));
        out.surface = {out.surface.tree(), definition};
    }
    return out;
}

} // namespace solid
