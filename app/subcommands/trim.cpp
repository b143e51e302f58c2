// pointclay trim: a model cut along an outline drawn in a picture of it, by the session's own command.
#include "app/options/model_command.h"

namespace app {

Action addTrim(OptionSet command) {
    return addModelCommand(command, "trim");
}

} // namespace app
