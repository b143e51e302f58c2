// pointclay fill: the holes of a model closed, by the session's own command.
#include "app/options/model_command.h"

namespace app {

Action addFill(OptionSet command) {
    return addModelCommand(command, "fill");
}

} // namespace app
