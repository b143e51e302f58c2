// pointclay tube: a tube along a curve joined to a model, or taken away from it, by the session's own command.
#include "app/options/model_command.h"

namespace app {

Action addTube(OptionSet command) {
    return addModelCommand(command, "tube");
}

} // namespace app
