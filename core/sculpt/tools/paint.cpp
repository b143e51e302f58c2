#include "core/sculpt/tools/paint.h"

#include "core/sculpt/tools/layout_flags.h"
#include "core/sculpt/tools/recolour.h"

namespace sculpt {

constexpr ToolParameter parameters[] = {
    {"colour", "Colour", "rgb", "Colour to paint, as 65536 red + 256 green + blue.", 0xc8553d, 0, 0xffffff,
     ParameterKind::Colour},
    {"colour2", "Second colour", "rgb", "Colour to paint when inverted.", 0xf4efe6, 0, 0xffffff, ParameterKind::Colour},
};

static tree::Edit paint(const surface::Surface& version, const Dab& dab) {
    if (dab.strength == 0)
        return {};
    const surfel::Colour colour = colourOf(dab.parameters.at(dab.strength < 0 ? "colour2" : "colour"));
    tree::Edit edit = recolour(version.tree(), dab, Brush(dab),
                               [&](const surfel::SurfelBlock&, int, surfel::Colour) { return colour; });
    if (!edit.empty())
        edit.layout = withFlag(version.tree().layout(), &surfel::AttributeLayout::colours);
    return edit;
}

const ToolRow paintTool{"paint",
                        "Paint",
                        "icons/tool-paint.svg",
                        "",
                        "Colours the surface; inverted, with the second colour.",
                        Motion::Along,
                        0.5,
                        parameters,
                        paint,
                        Writes::Colour};

} // namespace sculpt
