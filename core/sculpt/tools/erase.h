// Erase: deletes surfels under the brush.
//
//     a surfel goes where  w(|p - centre| / R) (1 - mask) > 1 - |strength|
//
// At full strength that is all under the brush, whatever the falloff; at half strength the part where the falloff is
// above one half. What stays keeps every bit; there is no inverse. The last surfels of a model stay: an edit that would
// leave fewer than 16 does nothing.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow eraseTool;

} // namespace sculpt
