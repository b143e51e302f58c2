// Several models in one PLY that every other program sees as one cloud: all surfels where they stand in the scene, with
// an attribute `part` that tells whose they are, and a line for each model:
//
//     comment pointclay-part 0 {"name":"bust","surface":"frame=normals...","attributes":{"part":4},...}
//
// Poses are in the points then: what is read back stands where it stood, with coordinates of its own that are the
// scene's. What only one model can have in a file (layers, the cells of a complex) is refused.
#pragma once

#include "core/session/scene/scene.h"

namespace session {

/// One model of a file: its points, and how it stands in the scene.
struct ScenePart {
    io::FileModel file;
    SceneModel model; ///< its name, visibility and lock
    bool active = false;
};

/// All models as one, for a writer. Throws base::Error where it cannot hold them.
io::FileModel togetherAsParts(const Scene& scene);

/// Whether the file has lines of parts.
bool tellsOfParts(const io::FileModel& file);

/// The parts of a file that was written so, in their order, which takes its points; none of any other file, or where
/// its lines do not fit its points.
std::vector<ScenePart> partsOf(io::FileModel& file);

} // namespace session
