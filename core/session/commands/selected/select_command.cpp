#include "core/selection/field.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/field_steps.h"
#include "core/session/commands/selected/select_ways.h"
#include "core/session/drawn_outline.h"

#include <nlohmann/json.hpp>

namespace session {

static void select(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    using selection::Mode;
    const auto mode = complete.at("mode").get<std::string>();
    const tree::Selection chosen = found(context, complete);
    commitSelection(context,
                    selection::combined(context.document.surface().tree(), chosen,
                                        mode == "add"        ? Mode::Add
                                        : mode == "subtract" ? Mode::Subtract
                                        : mode == "replace"  ? Mode::Replace
                                                             : Mode::Intersect),
                    "Select", complete.at("hidden"));
}

CommandRow selectCommand() {
    static const std::string ways = idsOf(selectWays());
    static const std::vector<CommandParameter> parameters = [] {
        std::vector<CommandParameter> out{
            {"by", "choice", "",
             "ball, box, plane: parts of space; view: an outline in a picture; range: what they carry; piece: what "
             "hangs "
             "together; rim: boundaries",
             "", ways.c_str(), 0, 0},
            {"hidden", "boolean", "", "takes what is hidden, too", "false", "", 0, 0},
            {"mode", "choice", "", "how this joins what was selected", "\"replace\"", "replace add subtract intersect",
             0, 0},
            {"at", "list", "model units",
             "[x,y,z]: the ball's centre; where a piece begins, else from what is selected; the loop nearest to it",
             "null", "", 0, 0},
            {"radius", "number", "model units", "of the ball", "null", "", positive, largest},
            {"least", "list", "model units", "[x,y,z], the box's lower corner", "null", "", 0, 0},
            {"most", "list", "model units", "[x,y,z], its upper corner", "null", "", 0, 0},
            {"plane", "list", "model units", "[nx,ny,nz,d]: what lies where nx*x + ny*y + nz*z >= d", "null", "", 0, 0},
        };
        const auto add = [&](const std::vector<CommandParameter>& more) {
            out.insert(out.end(), more.begin(), more.end());
        };
        add(pictureParameters("null"));
        add(outlineParameters());
        add({
            {"depth", "list", "model units", "[from,to] along the view from the eye; all unless told", "null", "", 0,
             0},
            {"visible", "boolean", "", "only what the camera sees, by the exact surface; else through everything",
             "null", "", 0, 0},
            {"of", "text", "",
             "x, y, z, normal-x, ..., support, mask, red, ..., hue, saturation, brightness, curvature-most, -least, "
             "-mean, "
             "-gauss, or an attribute's name",
             "null", "", 0, 0},
            {"from", "number", "", "least value of it", "null", "", -largest, largest},
            {"to", "number", "", "greatest value of it", "null", "", -largest, largest},
            {"colour", "list", "", "[red,green,blue] from 0 to 255", "null", "", 0, 0},
            {"tolerance", "number", "", "distance from the colour that still counts; 32 unless told", "null", "", 0,
             442},
            {"direction", "list", "", "[x,y,z] that normals point in", "null", "", 0, 0},
            {"angle", "number", "degrees",
             "normals: from the direction, 30 unless told; piece: between neighbours, where it ends at creases", "null",
             "", 0, 180},
            {"curvature", "number", "1 / model units",
             "a piece ends where the larger principal curvature is above this", "null", "", 0, largest},
            {"longest", "number", "model units", "loops up to this length", "null", "", positive, largest},
            {"width", "number", "model units", "how far from a rim; the last rows of surfels unless told", "null", "",
             positive, largest},
        });
        return out;
    }();
    return {"select",
            "Select",
            "Chooses surfels for other commands to work on; what is selected is saved with the model.",
            parameters,
            true,
            false,
            select,
            nullptr,
            HiddenParts::Spared};
}

} // namespace session
