// pointclay shapes: planes, spheres, cylinders and the like found in a model, by the session's own command.
#include "app/options/model_command.h"

namespace app {

Action addShapes(OptionSet command) {
    return addModelCommand(command, "shapes");
}

} // namespace app
