#include "core/base/row_of_id.h"
#include "core/process/measuring/detect_shapes.h"
#include "core/process/measuring/measured_attribute.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/place_text.h"
#include "core/session/shape_text.h"

#include <array>
#include <nlohmann/json.hpp>
#include <numbers>

namespace session {

using nlohmann::json;
using process::DetectedShape, process::DetectedShapes;

namespace {

constexpr const char* attribute = "shape";

process::DetectWish wishOf(const json& complete) {
    process::DetectWish out;
    out.shapes.clear();
    const json& kinds = complete.at("kinds");
    for (const process::ShapeRow& row : process::shapeTable())
        if (kinds.is_array() ? std::find(kinds.begin(), kinds.end(), row.id) != kinds.end() : kinds == row.id)
            out.shapes.push_back(row.shape);
    out.tolerance = complete.value("tolerance", 0.0);
    out.angleRad = complete.at("angle").get<double>() * std::numbers::pi / 180;
    out.fewest = complete.value("fewest", std::size_t(0));
    return out;
}

/// Colours that are easily told apart, as many as wanted: hues by the golden ratio; grey for none.
surfel::Colour colourOf(std::uint32_t shape) {
    if (shape == 0)
        return surfel::rgba(150, 150, 150);
    const double hue = 6 * std::fmod(0.618033988749895 * shape, 1.0), light = shape % 2 == 0 ? 0.62 : 0.88;
    const auto part = [&](double from) {
        const double x = std::abs(std::fmod(hue + from, 6.0) - 3) - 1;
        return static_cast<std::uint8_t>(std::lround(255 * light * (0.35 + 0.65 * std::clamp(x, 0.0, 1.0))));
    };
    return surfel::rgba(part(0), part(4), part(2));
}

void tell(Context& context, const DetectedShapes& found) {
    constexpr std::size_t most = 30;
    std::size_t on = 0;
    for (const DetectedShape& each : found.shapes)
        on += each.points;
    const std::size_t all = found.shapeOf.size();
    context.figures["shapes"] = static_cast<double>(found.shapes.size());
    context.figures["on"] = static_cast<double>(on);
    const double size = context.document.surface().tree().bounds().diagonal();
    const base::Vec3d& origin = context.document.provenance().origin;
    for (std::size_t k = 0; k < std::min(most, found.shapes.size()); ++k)
        context.messages.push_back("Shape " + std::to_string(k + 1) + ": " + sentenceOf(found.shapes[k], origin, size) +
                                   ".");
    if (found.shapes.size() > most)
        context.messages.push_back("And " + std::to_string(found.shapes.size() - most) + " smaller ones.");
    if (found.shapes.empty())
        context.messages.push_back("No shape of at least " + std::to_string(found.fewest) +
                                   " points was found; fewer can be asked for, or a larger tolerance.");
    else
        context.messages.push_back("Found " + std::to_string(found.shapes.size()) +
                                   (found.shapes.size() == 1 ? " shape with " : " shapes with ") + std::to_string(on) +
                                   " of " + std::to_string(all) +
                                   " points; the attribute shape has their numbers, for select by range and colours.");
}

void shapes(Context& context, const json& complete) {
    requireModel(context);
    requireSurface(context);
    const surface::Surface& now = context.document.surface();
    const DetectedShapes found = process::detectShapes(now.tree().surfels(), wishOf(complete), context.progress);
    tell(context, found);
    if (found.shapes.empty() && !now.tree().layout()->find(attribute))
        return;
    const std::vector<float> numbers(found.shapeOf.begin(), found.shapeOf.end());
    tree::SurfelTree next = process::withAttribute(now.tree(), attribute, numbers);
    if (complete.at("colours").get<bool>()) {
        std::vector<surfel::Colour> colours;
        for (const std::uint32_t each : found.shapeOf)
            colours.push_back(colourOf(each));
        next = process::withColours(next, colours);
    }
    clean::commit(context, {next, now.definition()}, "Find shapes");
}

} // namespace

CommandRow shapesCommand() {
    static const std::string kinds = idsOf(process::shapeTable());
    static const CommandParameter parameters[] = {
        {"kinds", "choices", "", "which shapes to look for", "[\"plane\",\"sphere\",\"cylinder\"]", kinds.c_str(), 0,
         0},
        {"tolerance", "number", "model units",
         "how far from a shape a point of it may be; of each point its own unless told, from noise and spacing there",
         "null", "", positive, largest},
        {"angle", "number", "degrees", "by which normals may differ from a shape's", "20", "", 1, 90},
        {"fewest", "integer", "", "points of a shape; a hundredth of all unless told", "null", "", 10, largestCount},
        {"colours", "boolean", "", "colours the points by shape; grey are those of none", "false", "", 0, 0},
    };
    return {"shapes",
            "Find shapes",
            "Finds planes, spheres, cylinders and the like, largest first, and numbers their points in the attribute "
            "\"shape\".",
            parameters,
            true,
            false,
            shapes,
            nullptr};
}

} // namespace session
