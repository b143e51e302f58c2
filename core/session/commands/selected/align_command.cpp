#include "core/base/error.h"
#include "core/base/up_axis.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/number_lists.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace session {

using base::Mat3d, base::Vec3d;
using nlohmann::json;
using selection::Affine, selection::Limit;

/// The smallest turn that brings the model's principal axes, each surfel with the area it stands for, onto x, y and z.
static Affine ontoAxes(const surface::Surface& surface) {
    const Vec3d middle = base::cast<double>(surface.tree().bounds().centre());
    Vec3d sum;
    double weight = 0;
    Mat3d spread;
    const auto each = [&](const auto& fn) {
        surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const auto h = static_cast<double>(block.support(slot));
                fn(base::cast<double>(block.position(slot)) - middle, h * h);
            }
        });
    };
    each([&](const Vec3d& p, double area) { sum += p * area, weight += area; });
    const Vec3d mean = sum / weight;
    each([&](const Vec3d& p, double area) { spread += base::outer(p - mean, p - mean) * (area / weight); });
    const auto eigen = base::symmetricEigen(spread);
    static constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    Mat3d best;
    for (const auto& order : orders)
        for (int signs = 0; signs < 8; ++signs) {
            Mat3d turn; // rows are the axes that become x, y and z
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 3; ++c)
                    turn[r][c] = eigen.vector[order[r]][static_cast<std::size_t>(c)] * (signs >> r & 1 ? -1 : 1);
            if (base::determinant(turn) > 0 && base::trace(turn) > base::trace(best))
                best = turn;
        }
    return Affine{best, {}}.about(middle + mean);
}

static void align(Context& context, const json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    const auto what = complete.at("do").get<std::string>();
    if (what == "axes") {
        commitMoved(context, ontoAxes(now), Limit::Everything, "Align");
        return;
    }
    const base::Box3f box = now.tree().bounds();
    const Vec3d origin = context.document.provenance().origin, up = base::upRow(context.document.up()).up;
    const Vec3d lowest = base::cast<double>(dot(up, Vec3d{1, 1, 1}) > 0 ? box.lo : box.hi) + origin;
    const Vec3d centre = base::cast<double>(box.centre()) + origin;
    const Vec3d by = what == "ground" ? up * -dot(up, lowest) : up * dot(up, centre) - centre;
    commitMoved(context, Affine::moving(by), Limit::Everything, "Align");
}

CommandRow alignCommand() {
    static const CommandParameter parameters[] = {
        {"do", "choice", "",
         "axes: turn its principal axes onto x, y and z, by as little as that takes; ground: its lowest point to "
         "height "
         "0; centre: its middle above the origin",
         "", "axes ground centre", 0, 0},
    };
    return {"align",    "Align", "Turns the whole model onto the axes, or moves it onto the ground or the origin.",
            parameters, true,    false,
            align,      nullptr};
}

static void setUnit(Context& context, const json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    const double is = distance(*vectorOf(complete, "from"), *vectorOf(complete, "to"));
    if (!(is > 0))
        throw base::Error("\"from\" and \"to\" are the same place", {}, "give two places whose distance is known");
    const double factor = complete.at("length").get<double>() / is;
    std::ostringstream said;
    said.precision(9);
    said << "Scaled by " << factor << '.';
    context.messages.push_back(said.str());
    context.figures["scale"] = factor;
    const Affine map =
        Affine::stretching(Vec3d{1, 1, 1} * factor).about(base::cast<double>(now.tree().bounds().centre()));
    commitMoved(context, map, Limit::Everything, "Set unit");
}

CommandRow unitCommand() {
    static const CommandParameter parameters[] = {
        {"from", "list", "model units", "[x,y,z], a place on the model", "", "", 0, 0},
        {"to", "list", "model units", "[x,y,z], another", "", "", 0, 0},
        {"length", "number", "new units", "what their distance is known to be", "", "", positive, largest},
    };
    return {"unit",     "Set unit", "Scales the whole model about its middle so that a known distance is right.",
            parameters, true,       false,
            setUnit,    nullptr};
}

} // namespace session
