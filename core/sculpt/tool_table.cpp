#include "core/base/row_of_id.h"
#include "core/sculpt/tool.h"
#include "core/sculpt/tools/blob.h"
#include "core/sculpt/tools/clay.h"
#include "core/sculpt/tools/clay_strips.h"
#include "core/sculpt/tools/clone.h"
#include "core/sculpt/tools/crease.h"
#include "core/sculpt/tools/density.h"
#include "core/sculpt/tools/draw.h"
#include "core/sculpt/tools/draw_sharp.h"
#include "core/sculpt/tools/elastic_grab.h"
#include "core/sculpt/tools/erase.h"
#include "core/sculpt/tools/fill.h"
#include "core/sculpt/tools/flatten.h"
#include "core/sculpt/tools/grab.h"
#include "core/sculpt/tools/inflate.h"
#include "core/sculpt/tools/layer.h"
#include "core/sculpt/tools/mask.h"
#include "core/sculpt/tools/morph.h"
#include "core/sculpt/tools/nudge.h"
#include "core/sculpt/tools/paint.h"
#include "core/sculpt/tools/pinch.h"
#include "core/sculpt/tools/relax.h"
#include "core/sculpt/tools/scrape.h"
#include "core/sculpt/tools/smear.h"
#include "core/sculpt/tools/smooth.h"
#include "core/sculpt/tools/snake_hook.h"
#include "core/sculpt/tools/twist.h"

namespace sculpt {

/// In the order of the tool bar: adding, drawing together, evening, pulling, then what does not move the surface.
/// Copied at the first call, when the rows of the other files exist.
std::span<const ToolRow> toolTable() {
    static const ToolRow rows[] = {
        drawTool,    drawSharpTool, clayTool,        clayStripsTool, inflateTool, layerTool,  blobTool,
        creaseTool,  pinchTool,     smoothTool,      flattenTool,    fillTool,    scrapeTool, relaxTool,
        morphTool,   grabTool,      elasticGrabTool, snakeHookTool,  twistTool,   nudgeTool,  cloneTool,
        densityTool, eraseTool,     maskTool,        paintTool,      smearTool,
    };
    return rows;
}

const ToolRow& tool(std::string_view id) {
    return base::rowOf(toolTable(), id, {"there is no tool '%'", "tool", "choose one of %"});
}

} // namespace sculpt
