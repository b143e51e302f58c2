// The steps of cleaning, each from a surface to the next one: what the commands `duplicates`, `mixed`, `outliers`,
// `denoise`, `thin`, `normals` and `orient` do, and `clean` one after the other. Inside this room.
//
// Each step tells the person one sentence with its numbers (Context::messages) and puts these under their names into
// Context::figures. None commits by itself.
#pragma once

#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// The parameters that the steps share: way of finding outliers, "auto" or a level of noise, and so on.
namespace clean {

constexpr const char* outlierWays = "statistical radius islands surface";
constexpr const char* normalWays = "plane jet grid viewpoint";
constexpr const char* orientWays = "tree viewpoint global";

constexpr const char* outlierTip =
    "statistical: farther from their neighbours than these are from theirs; radius: with too few others around; "
    "islands: in small pieces apart; surface: off the surface that their neighbours make";
constexpr const char* limitTip =
    "what is still no outlier; statistical and surface: standard deviations (4), radius: others around (6), islands: "
    "points of a piece (the square root of the largest piece's)";
constexpr const char* sigmaTip =
    "noise to take out, as its standard deviation across the surface; auto: as found at each place";
constexpr const char* spacingTip = "thin to points that are no closer than this to each other";
constexpr const char* normalTip =
    "plane: of the nearest points; jet: of a curved fit to them; grid: from the rows and columns of a range scan; "
    "viewpoint: plane, looking to the scanner";
constexpr const char* orientTip = "tree: neighbours agree, the outermost look outwards; viewpoint: to the scanner; "
                                  "global: each piece in agreement with all others";
constexpr const char* viewpointTip = "where the scanner stood: [x,y,z] in the file's coordinates; the origin unless "
                                     "told, for mixed pixels what the file tells";
constexpr const char* eyeTip = "where the scanner stood: [x,y,z] in the file's coordinates; what the file tells unless "
                               "told";
constexpr const char* stepTip = "steps in depth count from so many distances between neighbouring beams on";

surface::Surface duplicates(Context& context, const surface::Surface& surface);
/// `viewpoint`: three numbers, or null for what the file tells. Throws base::Error where nobody does.
surface::Surface mixed(Context& context, const surface::Surface& surface, const nlohmann::json& viewpoint,
                       double limit);
/// `limit`: null for the way's own.
surface::Surface outliers(Context& context, const surface::Surface& surface, const std::string& way,
                          const nlohmann::json& limit);
/// What strays may have turned: where sides of normals are still as opening guessed them, among strays, and some points
/// have gone since, they are guessed again; no guess where the viewpoint was told.
surface::Surface guessedAgain(Context& context, const surface::Surface& surface, const nlohmann::json& viewpoint = {});
/// `sigma`: "auto" or a length.
surface::Surface denoise(Context& context, const surface::Surface& surface, const nlohmann::json& sigma);
surface::Surface thin(Context& context, const surface::Surface& surface, float spacing);
/// `viewpoint`: three numbers, or null for the origin. Throws base::Error where these are not such.
surface::Surface normals(Context& context, const surface::Surface& surface, const std::string& way,
                         const nlohmann::json& viewpoint);
surface::Surface orient(Context& context, const surface::Surface& surface, const std::string& way,
                        const nlohmann::json& viewpoint);

/// One step of history, unless nothing changed.
void commit(Context& context, surface::Surface next, const std::string& label, layers::How how = layers::How::Carry);

} // namespace clean
} // namespace session
