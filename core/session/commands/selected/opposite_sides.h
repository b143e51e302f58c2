// What must not come of moving a surface inwards: that both sides of what is thin pass through each other. Inside this
// room.
#pragma once

#include "core/session/command.h"

namespace session {

/// `after` has the surfels of the document's surface in their order, moved. Throws base::Error that tells where the two
/// sides would meet first. Of what has nothing opposite nothing is known. REQUIRES: normals with sides.
void requireApart(const Context& context, const tree::SurfelTree& after);

} // namespace session
