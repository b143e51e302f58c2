#include "core/base/error.h"
#include "core/selection/affine.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/number_lists.h"

#include <nlohmann/json.hpp>

namespace session {

using base::Vec3d;
using nlohmann::json;
using selection::Affine, selection::Limit;

namespace {

Vec3d stretchOf(const json& scale) {
    if (scale.is_number())
        return Vec3d{1, 1, 1} * scale.get<double>();
    const std::vector<double> v = numbersOf({{"op", "transform"}, {"stretch", scale}}, "stretch", 3, "[x,y,z]");
    return {v[0], v[1], v[2]};
}

/// A matrix of 16 numbers by row, in the file's coordinates.
Affine matrixOf(const Context& context, const json& complete) {
    const std::vector<double> m = numbersOf(complete, "matrix", 16, "16 numbers by row");
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
        throw base::Error("the last row of \"matrix\" is not 0, 0, 0, 1", {}, "give an affine map");
    const base::Mat3d linear{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
    const Vec3d origin = context.document.provenance().origin;
    return {linear, Vec3d{m[3], m[7], m[11]} + linear * origin - origin};
}

/// Scaled, turned, then moved; about the middle of what is changed unless a point is told. Mirrored or by a matrix
/// first.
Affine mapOf(const Context& context, const json& complete, Limit limit) {
    const base::Box3f box = selection::boxUnder(context.document.surface().tree(), limit);
    const Vec3d centre = placeOf(context, complete, "about").value_or(base::cast<double>(box.centre()));
    Affine map;
    if (complete.contains("matrix"))
        map = matrixOf(context, complete);
    if (complete.contains("mirror"))
        map = Affine::mirroring(planeOf(context, complete, "mirror")).after(map);
    Affine turned;
    if (complete.contains("scale"))
        turned = Affine::stretching(stretchOf(complete.at("scale")));
    if (complete.contains("stretch"))
        turned = Affine::stretching(stretchOf(complete.at("stretch"))).after(turned);
    if (const auto turn = turnOf(complete))
        turned = Affine::turning(turn->axis, turn->angle).after(turned);
    map = turned.about(centre).after(map);
    return Affine::moving(vectorOf(complete, "move").value_or(Vec3d())).after(map);
}

void transform(Context& context, const json& complete) {
    requireModel(context);
    const Limit limit = limitOf(context, complete);
    commitMoved(context, mapOf(context, complete, limit), limit, "Transform");
}

void duplicate(Context& context, const json& complete) {
    requireModel(context);
    requireSelection(context);
    clean::commit(context,
                  selection::duplicated(context.document.surface(), mapOf(context, complete, Limit::Selection)),
                  "Duplicate");
}

constexpr CommandParameter common[] = {
    {"move", "list", "model units", "[x,y,z] to move by, last", "null", "", 0, 0},
    {"axis", "list", "", "[x,y,z] to turn about", "null", "", 0, 0},
    {"angle", "number", "degrees", "to turn by, right-handed", "null", "", -3600, 3600},
    {"scale", "number", "", "to scale by, first", "null", "", positive, largest},
    {"stretch", "list", "", "[x,y,z] to scale by along each axis; negative numbers mirror", "null", "", 0, 0},
    {"mirror", "list", "model units", "[nx,ny,nz,d]: at the plane nx*x + ny*y + nz*z = d", "null", "", 0, 0},
    {"matrix", "list", "", "16 numbers by row, an affine map of the file's coordinates", "null", "", 0, 0},
    {"about", "list", "model units", "[x,y,z] that turning and scaling leave where it is; the middle unless told",
     "null", "", 0, 0},
};

} // namespace

CommandRow transformCommand() {
    static const auto parameters = [] {
        std::vector<CommandParameter> out(std::begin(common), std::end(common));
        out.push_back({"of", "choice", "", limitTip, limitFallback, limits, 0, 0});
        return out;
    }();
    return {"transform",
            "Transform",
            "Moves, turns, scales and mirrors with numbers; soft selections give way in the measure of the selection.",
            parameters,
            true,
            false,
            transform,
            nullptr};
}

CommandRow duplicateCommand() {
    return {"duplicate",
            "Duplicate",
            "Puts a copy of what is selected elsewhere, moved as by \"transform\"; the copy is then selected.",
            common,
            true,
            false,
            duplicate,
            nullptr};
}

} // namespace session
