#include "core/base/error.h"
#include "core/cells/cell_surface.h"
#include "core/cells/creases/detect_creases.h"
#include "core/cells/creases/draw_crease.h"
#include "core/cells/creases/labelled_surface.h"
#include "core/session/commands/commands.h"
#include "core/session/number_lists.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace session {

using base::Vec3d;
using nlohmann::json;

static void detect(Context& context, const json& complete) {
    const surface::Surface before = context.document.surface();
    const double sharpness = complete.at("sharpness").get<double>();
    if (sharpness == 0) {
        surface::Surface smooth = cells::unlabelled(before);
        if (smooth.tree() == before.tree())
            context.messages.push_back("there are no creases to make smooth");
        else
            context.document.commit(std::move(smooth), "Smooth creases");
        return;
    }
    cells::DetectedCreases result = cells::detectCreases(
        before, {complete.at("angle").get<double>() * std::numbers::pi / 180, sharpness}, context.progress);
    context.figures["noise"] = result.noise;
    context.figures["narrow"] = static_cast<double>(result.narrow);
    if (result.narrow > 0)
        context.messages.push_back(std::to_string(result.narrow) +
                                   " patches are too narrow for their spacing: they stay smooth");
    if (!result.found) {
        context.messages.push_back("no creases were found");
        return;
    }
    const cells::CellCounts counts = cells::countCells(result.surface.tree().surfels());
    context.messages.push_back(std::to_string(counts.cells) + " smooth patches meet in creases, " +
                               std::to_string(counts.pairs) + " pairs of them");
    context.document.commit(std::move(result.surface), "Find creases");
}

static void draw(Context& context, const json& complete) {
    cells::DrawnCrease result = cells::drawCrease(context.document.surface(), placesOf(context, complete, "along"),
                                                  complete.at("sharpness").get<double>(), context.progress);
    context.figures["creased"] = static_cast<double>(result.creased);
    context.figures["changed"] = static_cast<double>(result.changed);
    context.messages.push_back(std::to_string(result.creased) + " points are at a new crease, " +
                               std::to_string(result.changed) + " at one that is as sharp as asked now");
    if (result.creased + result.changed > 0)
        context.document.commit(std::move(result.surface), "Crease");
}

static void crease(Context& context, const json& complete) {
    requireModel(context);
    const bool detected = complete.at("detect").get<bool>();
    if (detected == complete.contains("along"))
        throw base::Error("\"crease\" needs \"detect\" or \"along\"", {}, "give one of them");
    (detected ? detect : draw)(context, complete);
}

CommandRow creaseCommand() {
    static const CommandParameter parameters[] = {
        {"detect", "boolean", "", "find creases in the points, in place of those that are there; give this or along",
         "false", "", 0, 0},
        {"angle", "number", "degrees", "with detect: normals that differ by more than this are parted by a crease",
         "32", "", 10, 150},
        {"along", "list", "model units",
         "[[x,y,z],...], places on the surface: the line through them becomes a crease; closed where it ends at its "
         "beginning",
         "null", "", 0, 0},
        {"sharpness", "number", "", "of the crease, 0 (smooth: creases that are there go) to 1", "1", "", 0, 1},
    };
    return {"crease",
            "Crease",
            "Makes edges that stay sharp, where the points have them or along a line; or makes them smooth again.",
            parameters,
            true,
            false,
            crease,
            nullptr};
}

} // namespace session
