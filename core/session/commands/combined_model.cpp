#include "core/session/commands/combined_model.h"

#include "core/base/short_number.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/session/number_text_list.h"
#include "core/session/place_text.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace session {

void take(Context& context, solid::Combined result, const char* label, const std::string& unchanged) {
    constexpr std::size_t few = 100; // bodies of 22 to 90 points were off by 2.5 to 69 % of their volume
    const bool changed = result.removed + result.inserted > 0;
    context.messages.push_back(changed ? std::to_string(result.removed) + " points went, " +
                                             std::to_string(result.inserted) + " came."
                                       : "The model is as it was: " + unchanged + ".");
    context.figures["removed"] = static_cast<double>(result.removed);
    context.figures["inserted"] = static_cast<double>(result.inserted);
    context.figures["at_seam"] = static_cast<double>(result.atSeam);
    if (result.finer > 0)
        context.messages.push_back("One of both is sampled far more coarsely than the other: it got " +
                                   std::to_string(result.finer) + " more points beside the seam.");
    if (result.rounded > 0)
        context.messages.push_back(std::to_string(result.rounded) +
                                   " of the points that came make the seam round or flat.");
    if (const std::size_t left = result.surface.tree().size(); changed && left < few)
        context.messages.push_back("Only " + std::to_string(left) +
                                   " points are left, too few to tell a shape: sample the parts more finely before.");
    if (result.open)
        context.messages.push_back("The model is open where it was cut, at " +
                                   placeText(*result.open + context.document.provenance().origin,
                                             static_cast<double>(result.surface.tree().bounds().diagonal())) +
                                   ": there inside and outside are a guess, and the cap has an end of its own.");
    double length = 0;
    std::size_t pieces = 0, corners = 0;
    for (const solid::SeamCurve& seam : result.seams) {
        length += seam.length();
        pieces += seam.pieces();
        corners += seam.corners.size();
    }
    context.figures["seam_length"] = length;
    context.figures["seams"] = static_cast<double>(pieces);
    context.figures["corners"] = static_cast<double>(corners);
    if (changed)
        context.document.commit(std::move(result.surface), label);
}

void takeBoth(Context& context, solid::Combined result, const char* label) {
    const bool apart = result.removed == 0 && result.inserted > 0;
    const std::size_t gone = result.partsGone, otherGone = result.otherPartsGone;
    context.figures["parts_gone"] = static_cast<double>(gone);
    context.figures["other_parts_gone"] = static_cast<double>(otherGone);
    const bool changed = result.removed + result.inserted > 0;
    take(context, std::move(result), label);
    if (gone > 0)
        context.messages.push_back(gone == 1 ? std::string("A part of the model is gone as a whole.")
                                             : std::to_string(gone) + " parts of the model are gone as a whole.");
    if (otherGone > 0 && changed)
        context.messages.push_back(
            otherGone == 1 ? std::string("A part of the other one left no trace: it does not meet the model's surface.")
                           : std::to_string(otherGone) +
                                 " parts of the other one left no trace: they do not meet the model's surface.");
    if (apart)
        context.messages.push_back("It does not meet the model's surface: what came is a part of its own.");
}

bool tellOfGuess(Context& context, const surface::Surface& surface, const char* name) {
    const bool open = std::isfinite(surface.definition().boundaryLimit);
    if (open)
        context.messages.push_back(std::string("The ") + name +
                                   " has a boundary: where it is open, inside and outside are a guess.");
    return open;
}

CommandParameter creasesParameter() {
    return {"creases", "boolean", "", "label the points on both sides of seams as cells, so that seams are sharp",
            "true",    "",        0,  0};
}

CommandParameter filletParameter() {
    return {"fillet",
            "number",
            "model units",
            "radius of a ball that rolls along the seam and rounds it",
            "null",
            "",
            CommandParameter::positive,
            CommandParameter::largest};
}

CommandParameter chamferParameter() {
    return {"chamfer",
            "number",
            "model units",
            "cuts the seam flat, between where a ball of this radius touches both sides; on planes at right angles it "
            "takes as much of each",
            "null",
            "",
            CommandParameter::positive,
            CommandParameter::largest};
}

solid::CombineOptions combineOptions(const nlohmann::json& complete) {
    solid::CombineOptions out;
    out.parts = true;
    out.creases = complete.at("creases").get<bool>();
    if (const auto fillet = complete.find("fillet"); fillet != complete.end())
        out.fillet = fillet->get<double>();
    if (const auto chamfer = complete.find("chamfer"); chamfer != complete.end())
        out.chamfer = chamfer->get<double>();
    if (out.fillet > 0 && out.chamfer > 0)
        throw base::Error("\"fillet\" and \"chamfer\" exclude each other", {}, "give one of them");
    return out;
}

/// About the axis of that number.
static base::Mat3d turnAbout(std::size_t axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const int i = static_cast<int>((axis + 1) % 3), j = static_cast<int>((axis + 2) % 3);
    base::Mat3d out = base::Mat3d::identity();
    out[i][i] = out[j][j] = c;
    out[i][j] = -s, out[j][i] = s;
    return out;
}

double spacingNear(const surface::Surface& model, const base::Vec3d& place) {
    std::vector<tree::Neighbour> near;
    model.tree().nearest(base::cast<float>(place), 1, near);
    const tree::Neighbour& at = near.front();
    const auto spacing = static_cast<double>(process::spacingAround(model.tree(), at.block->position(at.slot)));
    return spacing > 0 ? spacing : static_cast<double>(at.block->support(at.slot)) * surface::spacingOfUnit;
}

void requireWidth(const surface::Surface& model, const base::Vec3d& place, double radius, const char* what,
                  const char* command) {
    constexpr double narrowest = 1.5; // diameters in spacings: balls drilled at 1.06 stay closed, at 1.66 they are open
    const double spacing = spacingNear(model, place);
    if (2 * radius < narrowest * spacing)
        throw base::Error(std::string("the ") + what + " is too narrow for points that are " +
                              base::shortNumber(spacing) + " apart there",
                          command, "make it wider, or make the points denser there");
}

solid::Pose poseOf(const nlohmann::json& complete, const base::Vec3d& origin) {
    const base::Vec3d degrees = vectorOf(complete.at("rotation").get<std::string>(), "rotation");
    return {turnAbout(2, degrees.z) * turnAbout(1, degrees.y) * turnAbout(0, degrees.x),
            vectorOf(complete.at("position").get<std::string>(), "position") - origin};
}

} // namespace session
