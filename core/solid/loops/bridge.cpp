#include "core/solid/loops/bridge.h"

#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/process/estimation/part_progress.h"
#include "core/solid/loops/bridge_sheet.h"
#include "core/solid/loops/obstacles.h"
#include "core/solid/loops/open_loops.h"
#include "core/solid/loops/patch_surfels.h"
#include "core/solid/loops/shape_patch.h"

#include <tuple>

namespace solid {

using base::Vec3d;

namespace {

/// Rows behind the loops that tell how dense the sheet is to be.
constexpr double behind = 3;

/// Which two, of so many. Throws base::Error.
std::array<std::size_t, 2> chosen(std::size_t count, const std::optional<std::array<std::size_t, 2>>& wanted) {
    if (count < 2)
        throw base::Error(thereAreLoops(count) + ", and a bridge needs two", "bridge",
                          "cut the model open where it is to begin and end");
    if (!wanted && count > 2)
        throw base::Error(thereAreLoops(count) + ", and nothing says which two to bridge", "bridge",
                          "name two by number, the longest is 0; boundary lists them with their places");
    const std::array<std::size_t, 2> out = wanted.value_or(std::array<std::size_t, 2>{0, 1});
    for (const std::size_t each : out)
        requireLoop(each, count, "bridge");
    if (out[0] == out[1])
        throw base::Error("a loop cannot be bridged with itself", "bridge", "name two loops");
    return out;
}

/// As seen from the other side.
Loop turnedOver(Loop loop) {
    std::reverse(loop.points.begin(), loop.points.end());
    for (LoopPoint& p : loop.points)
        p.normal = -p.normal;
    return loop;
}

Loop together(const Loop& a, const Loop& b) {
    Loop out = a;
    out.points.insert(out.points.end(), b.points.begin(), b.points.end());
    out.length = a.length + b.length;
    out.middle = (a.middle + b.middle) * 0.5;
    return out;
}

/// Throws base::Error where much of the sheet lies folded over itself.
void requireUnfolded(const Patch& patch, std::span<const Vec3d> normals) {
    constexpr double most = 0.01; // part of the triangles that may be turned against their corners
    std::size_t folded = 0;
    for (const mesh::Triangle& t : patch.triangles) {
        const Vec3d &a = patch.positions[t[0]],
                    n = normalized(cross(patch.positions[t[1]] - a, patch.positions[t[2]] - a));
        folded += std::ranges::any_of(t, [&](std::uint32_t corner) { return dot(n, normals[corner]) < -0.2; });
    }
    if (static_cast<double>(folded) > most * static_cast<double>(patch.triangles.size()))
        throw base::Error("a sheet between the two loops would lie folded over itself", "bridge",
                          "choose loops that face each other, or move one of their parts");
}

/// Throws base::Error where the sheet meets what is there, other than at its loops.
void requireFree(const surface::Surface& surface, const Loop& loops, const Patch& patch) {
    if (meetsModel(surface, loops, patch))
        throw base::Error("a sheet between the two loops would run into the model", "bridge",
                          "choose loops that see each other, or move one of their parts");
}

} // namespace

Bridged bridge(const surface::Surface& surface, const std::optional<std::array<std::size_t, 2>>& loops,
               const base::Progress& progress) {
    const base::CancelScope scope(progress.cancel);
    const std::vector<surface::BoundaryCurve> curves =
        openLoops(surface, "bridge", "has no boundary loops to bridge", process::part(progress, 0, 0.4));
    Bridged out{surface, chosen(curves.size(), loops), 0};
    const surface::BoundaryCurve &first = curves[out.loops[0]], &second = curves[out.loops[1]];
    bool turned = false; // the second one, as its normals have the other side
    const auto loopsAt = [&](double coarser) {
        const Loop other = evenLoop(surface, second, coarser, behind);
        return std::pair(evenLoop(surface, first, coarser, behind), turned ? turnedOver(other) : other);
    };
    auto [a, b] = loopsAt(1);
    const std::vector<std::uint8_t> touches = touching({a, b});
    for (std::size_t k = 0; k < 2; ++k)
        if (touches[k] || !(k == 0 ? first : second).closed)
            throw base::Error("boundary loop " + std::to_string(out.loops[k]) +
                                  (touches[k] ? " touches itself or the other one" : " does not close"),
                              "bridge", "choose others, or clean the model there");
    BridgeSheet sheet(surface, a, b);
    constexpr double doubtful = 1.5; // times as far as the other way about
    if (sheet.againstTurned() > doubtful) {
        if (surface.tree().layout()->oriented)
            throw base::Error("the surfaces at the two loops face to opposite sides", "bridge",
                              "turn one over: select it, then flip");
        turned = true;
        b = turnedOver(b);
        sheet = BridgeSheet(surface, a, b);
    }
    const double spacing = 0.5 * (a.meanSpacing() + b.meanSpacing());
    const int halvings = halvingsFor(sheet.across() * 0.5 * (a.length + b.length), spacing);
    if (halvings > 0) {
        const double coarser = std::exp2(halvings);
        std::tie(a, b) = loopsAt(coarser);
        for (Loop* each : {&a, &b})
            for (LoopPoint& p : each->points)
                p.spacing *= coarser;
        sheet = BridgeSheet(surface, a, b);
    }
    const Loop both = together(a, b);
    const Patch patch = patchBetween(both, sheet.places(), sheet, process::part(progress, 0.4, 0.9));
    std::vector<Vec3d> normals = patchNormals(both, patch);
    requireUnfolded(patch, normals);
    Patch fine = patch;
    halveEdges(fine, normals, halvings);
    requireFree(surface, both, patch);
    PatchSurfels surfels(surface);
    out.surfels = surfels.add(both, patch, halvings, fine, normals);
    if (out.surfels > 0) {
        const surface::Surface whole = withSurfels(surface, surfels.surfels());
        out.surface = process::withOwnLimit(whole.tree(), whole.definition(), process::part(progress, 0.9, 1));
    }
    return out;
}

} // namespace solid
