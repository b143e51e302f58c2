#include "app/options/face_options.h"

#include "core/session/face_options.h"

namespace app {

void addFaceOptions(CLI::App& command, GivenParameters& given, CLI::Option* model) {
    std::map<std::string, CLI::Option*> added;
    for (const session::CommandParameter& p : session::faceParameters())
        added[p.id] = addParameter(command, "open", p, helpOf(p), given)->group("Faces");
    for (const auto& [id, option] : added)
        if (model)
            option->needs(model);
    added.at("sample_count")->excludes(added.at("sample_spacing"));
}

} // namespace app
