// Faces from links that creases cut (cells/README 7.2): what hangs together over the others. Gaps in a line of cut
// links do not join the faces beside it, and what is too narrow to be told from noise is no face.
#pragma once

#include "core/cells/creases/surfel_links.h"

namespace cells {

struct LinkFaces {
    std::vector<std::uint32_t> faces; ///< of each surfel, from 0
    std::size_t narrow = 0;           ///< faces that were given up, with the creases around them
};

/// Closes gaps: links between two faces that creases part become cut; links within what is no face are uncut.
LinkFaces facesOfLinks(SurfelLinks& links);

} // namespace cells
