#include "core/base/error.h"
#include "core/base/unit_normal.h"
#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"
#include "core/session/number_text_list.h"
#include "core/surface/rays/intersect.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static solid::Combined withPrimitive(Context& context, const solid::PrimitiveRow& row, const solid::Size& size,
                                     const solid::Pose& pose, double spacing, const json& complete,
                                     solid::Operation operation) {
    const surface::Surface& model = context.document.surface();
    surfel::SurfelList surfels = solid::surfelsOf(row, size, spacing, model.definition());
    for (surfel::Surfel& s : surfels.items) {
        s.position = base::cast<float>(pose.place(base::cast<double>(s.position)));
        s.normal = base::unitNormal(base::cast<float>(pose.turn * base::cast<double>(s.normal)));
    }
    const solid::PrimitiveSide side(row, size, pose);
    tellOfGuess(context, model);
    return solid::combine(model, {side, std::move(surfels)}, operation, combineOptions(complete), context.progress);
}

static void primitive(Context& context, const json& complete) {
    requireModel(context);
    const solid::PrimitiveRow& row = solid::primitive(complete.at("shape").get<std::string>());
    const auto count = static_cast<std::size_t>(row.sizeCount);
    const std::vector<double> numbers = numbersOf(complete.at("size").get<std::string>(), "size", count, count);
    solid::Size size{};
    std::copy(numbers.begin(), numbers.end(), size.begin());
    for (std::size_t k = 0; k < count; ++k)
        if (!(size[k] > 0))
            throw base::Error("a size must be above 0", "primitive", std::string("the numbers are: ") + row.sizes);
    const solid::Pose pose = poseOf(complete, context.document.provenance().origin);
    const double spacing = complete.contains("spacing") ? complete.at("spacing").get<double>()
                                                        : spacingNear(context.document.surface(), pose.middle);
    takeBoth(context,
             withPrimitive(context, row, size, pose, spacing, complete,
                           solid::operation(complete.at("operation").get<std::string>())),
             row.label);
}

CommandRow primitiveCommand() {
    static const std::string shapes = idsOf(solid::primitiveTable()), operations = idsOf(solid::operationTable());
    static const std::string sizes = [] {
        std::string out = "as numbers with commas between them:";
        for (const solid::PrimitiveRow& row : solid::primitiveTable())
            out += std::string(out.ends_with(':') ? " " : "; ") + row.id + " " + row.sizes;
        return out;
    }();
    static const CommandParameter parameters[] = {
        {"shape", "choice", "", "what to join or take away", "\"ball\"", shapes.c_str(), 0, 0},
        {"size", "text", "model units", sizes.c_str(), "", "", 0, 0},
        {"position", "text", "model units", "of its middle, as x,y,z", "\"0,0,0\"", "", 0, 0},
        {"rotation", "text", "degrees", "by which its axis, z, is turned, about x, then y, then z, as x,y,z",
         "\"0,0,0\"", "", 0, 0},
        {"operation", "choice", "", "union joins it, difference takes it away, intersection keeps what is in it",
         "\"union\"", operations.c_str(), 0, 0},
        {"spacing", "number", "model units", "of its points; by default as the model's nearest", "null", "", positive,
         largest},
        creasesParameter(),
        filletParameter(),
        chamferParameter(),
    };
    return {"primitive",
            "Add a shape",
            "Joins a ball, box, cylinder, cone, torus or capsule to the model, or takes it away.",
            parameters,
            true,
            false,
            primitive,
            nullptr};
}

/// Where on a line the model's surfels begin and end.
static std::pair<double, double> alongModel(const surface::Surface& model, const base::Vec3d& from,
                                            const base::Vec3d& direction) {
    const base::Box3f box = model.tree().bounds();
    std::pair<double, double> out{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int corner = 0; corner < 8; ++corner) {
        const base::Vec3f c{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                            corner & 4 ? box.hi.z : box.lo.z};
        const double t = dot(base::cast<double>(c) - from, direction);
        out = {std::min(out.first, t), std::max(out.second, t)};
    }
    return out;
}

/// From before the model to the depth below the first hit, or to behind the model.
static void drill(Context& context, const json& complete) {
    requireModel(context);
    const surface::Surface& model = context.document.surface();
    const base::Vec3d from = vectorOf(complete.at("from").get<std::string>(), "from") -
                             context.document.provenance().origin,
                      direction = directionOf(complete.at("direction").get<std::string>(), "direction");
    const auto radius = complete.at("radius").get<double>(), depth = complete.at("depth").get<double>();
    const surface::RayHit<double> hit = surface::intersectReference(model, {from, direction});
    if (!hit.hit)
        throw base::Error("the drill misses the model", "drill", "aim at it: give another \"from\" or \"direction\"");
    requireWidth(model, hit.position, radius, "hole", "drill");
    const double spacing = spacingNear(model, hit.position);
    const auto [first, last] = alongModel(model, from, direction);
    const double begin = first - radius, end = depth > 0 ? hit.t + depth : last + radius;
    const solid::Pose pose = solid::poseAlong(from + direction * (0.5 * (begin + end)), direction);
    takeBoth(context,
             withPrimitive(context, solid::primitive("cylinder"), {radius, end - begin, 0}, pose, spacing, complete,
                           solid::Operation::Difference),
             "Drill");
}

CommandRow drillCommand() {
    static const CommandParameter parameters[] = {
        {"from", "text", "model units", "a place on the drill's axis, before the model, as x,y,z", "", "", 0, 0},
        {"direction", "text", "", "of the drill, as x,y,z", "", "", 0, 0},
        {"radius", "number", "model units", "of the hole", "", "", positive, largest},
        {"depth", "number", "model units", "of its bottom below where the axis meets the model; 0: right through", "0",
         "", 0, largest},
        creasesParameter(),
        filletParameter(),
        chamferParameter(),
    };
    return {"drill", "Drill", "Drills a round hole, through the model or to a depth.", parameters, true, false,
            drill,   nullptr};
}

} // namespace session
