#include "app/options/face_options.h"

#include "core/session/face_options.h"
#include "core/session/read_options.h"

namespace app {

void addFaceOptions(OptionSet command, GivenParameters& given, std::optional<Option> model) {
    std::map<std::string, Option> added;
    for (const session::CommandParameter& p : session::readParameters())
        added.emplace(p.id, addParameter(command, "open", p, helpOf(p), given).group("Reading"));
    for (const session::CommandParameter& p : session::faceParameters())
        added.emplace(p.id, addParameter(command, "open", p, helpOf(p), given).group("Faces"));
    for (auto& [id, option] : added)
        if (model)
            option.needs(*model);
    added.at("sample_count").excludes(added.at("sample_spacing"));
}

} // namespace app
