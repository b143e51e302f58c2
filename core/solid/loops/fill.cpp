#include "core/solid/loops/fill.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/loops/open_loops.h"
#include "core/solid/loops/patch_surfels.h"
#include "core/solid/loops/relief.h"

namespace solid {

using base::Vec3d;

namespace {

class Filler {
  public:
    explicit Filler(const surface::Surface& surface) : m_surface(surface), m_out(surface) {}

    void fill(const surface::BoundaryCurve& curve, Loop loop, const FillOptions& options, LoopFate& fate,
              const base::Progress& progress) {
        const int halvings = halvingsFor(areaOver(loop), loop.meanSpacing());
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
    const surfel::SurfelList& surfels() const { return m_out.surfels(); }

  private:
    void add(const Loop& loop, const Patch& patch, int halvings, bool relief, LoopFate& fate) {
        std::vector<Vec3d> normals = patchNormals(loop, patch);
        Patch fine = patch;
        halveEdges(fine, normals, halvings);
        if (relief)
            fate.plain = followRelief(m_surface, loop, patch, fine, normals) == ReliefFate::TooLittle;
        fate.surfels += m_out.add(loop, patch, halvings, fine, normals);
    }

    const surface::Surface& m_surface;
    PatchSurfels m_out;
};

} // namespace

Filled fillHoles(const surface::Surface& surface, const FillOptions& options, const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    const std::vector<surface::BoundaryCurve> curves =
        openLoops(surface, "fill", "has no holes to fill", process::part(progress, 0, 0.4));
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
    out.surface = withSurfels(surface, filler.surfels(), process::part(progress, 0.9, 1));
    return out;
}

} // namespace solid
