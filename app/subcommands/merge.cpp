// pointclay merge: parts of a model that were pushed into each other, made one solid, by the session's own command.
#include "app/options/model_command.h"

namespace app {

Action addMerge(OptionSet command) {
    return addModelCommand(command, "merge");
}

} // namespace app
