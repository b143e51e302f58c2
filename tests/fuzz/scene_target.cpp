// Scene files and files of poses: whatever they say becomes commands that are complete, or one sentence.
#include "core/session/command.h"
#include "core/session/scene/scene_file.h"
#include "fuzz/fuzzed.h"

#include <nlohmann/json.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto file = fuzz::put(fuzz::oneOf("s.scene.json s.conf", size), {reinterpret_cast<const char*>(data), size});
    std::vector<std::string> messages;
    fuzz::tried([&] {
        const std::vector<nlohmann::json> commands = session::sceneCommands(file, messages);
        fuzz::require(commands.size() >= 3 && commands.front().at("op") == "open", "a scene begins with a model");
        for (const nlohmann::json& each : commands)
            session::complete(each, file.parent_path());
    });
    return 0;
}
