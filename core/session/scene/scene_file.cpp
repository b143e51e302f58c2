#include "core/session/scene/scene_file.h"

#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/io/before_writing.h"
#include "core/io/file_bytes.h"
#include "core/session/json_text.h"
#include "core/session/path_text.h"
#include "core/session/scene/pose_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace session {

namespace fs = std::filesystem;
using nlohmann::json;

static constexpr std::string_view extension = ".scene.json";
static constexpr const char* version = "pointclay-scene";
static constexpr const char* advice =
    R"(save the scene anew; a least one is {"pointclay-scene":1,"models":[{"name":"a","file":"a.ply"}]})";

bool isSceneFile(const fs::path& path) {
    std::string name = path.filename().string();
    std::ranges::transform(name, name.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return name.size() > extension.size() && name.ends_with(extension);
}

bool opensAsScene(const fs::path& path) {
    return isSceneFile(path) || isPoseFile(path);
}

void requireSavable(const fs::path& path) {
    if (!isSceneFile(path))
        io::requireModelFormat(path);
}

/// One value of a model, of the type of `fallback`, which stands where it may be left out and is.
template <class Value>
static Value valueOf(const json& model, const char* key, const Value* fallback, const fs::path& file) {
    try {
        return fallback && !model.contains(key) ? *fallback : model.at(key).get<Value>();
    } catch (const json::exception&) {
        throw base::Error(std::string("a model's \"") + key + "\" is missing or not what it should be", file.string(),
                          advice);
    }
}

static std::string nameIn(const json& model, const fs::path& file) {
    const auto out = valueOf<std::string>(model, "name", nullptr, file);
    if (!isModelName(out))
        throw base::Error("\"" + out + "\" is no name for a model", file.string(), advice);
    return out;
}

static json step(const char* what, const std::string& name) {
    return {{"op", "scene"}, {"do", what}, {"name", name}};
}

/// What is left to do once the model is there under its name.
static void addState(std::vector<json>& out, const json& model, const fs::path& file, const std::string& name) {
    const bool yes = true, no = false;
    if (!valueOf(model, "visible", &yes, file))
        out.push_back(step("hide", name));
    if (valueOf(model, "locked", &no, file))
        out.push_back(step("lock", name));
}

static std::vector<double> matrixIn(const json& model, const fs::path& file) {
    const std::vector<double> none = matrixOf({});
    const auto out = valueOf(model, "matrix", &none, file);
    try {
        poseOf(out);
    } catch (const base::Error& error) {
        throw base::Error(error.message(), file.string(), advice);
    }
    return out;
}

static json modelsIn(const fs::path& file) {
    const io::FileBytes bytes(file);
    json out;
    try {
        out = jsonOf(bytes.bytes());
    } catch (const base::Error& error) {
        throw base::Error(error.message(), file.string(), advice);
    }
    if (!out.is_object() || out.value(version, json()) != 1)
        throw base::Error("is no scene that this version reads", file.string(), advice);
    const auto models = out.find("models");
    if (models == out.end() || !models->is_array() || models->empty() ||
        !std::ranges::all_of(*models, [](const json& each) { return each.is_object(); }))
        throw base::Error("holds no models", file.string(), advice);
    return out;
}

static json addCommand(const std::string& path, const std::string& name, const std::vector<double>& matrix) {
    return {{"op", "scene"}, {"do", "add"}, {"path", path}, {"name", name}, {"matrix", matrix}};
}

/// The commands of the first model, which is opened.
static std::vector<json> openCommands(const std::string& path, const std::string& name,
                                      const std::vector<double>& matrix) {
    std::vector<json> out{{{"op", "open"}, {"path", path}}, {{"op", "scene"}, {"do", "rename"}, {"to", name}}};
    if (matrix != matrixOf({}))
        out.push_back({{"op", "scene"}, {"do", "place"}, {"name", name}, {"matrix", matrix}});
    return out;
}

/// Scans by the names of their files.
static std::vector<json> scanCommands(const fs::path& file, std::vector<std::string>& messages) {
    std::vector<json> out;
    Scene names;
    std::vector<std::string> missing;
    for (const PosedFile& each : posesIn(file)) {
        std::error_code none;
        if (!fs::exists(each.file, none)) {
            missing.push_back(each.file.filename().string());
            continue;
        }
        SceneModel model;
        model.name = names.freshName(nameOf(each.file));
        names.models.push_back(model);
        if (out.empty())
            out = openCommands(each.file.string(), model.name, matrixOf(each.pose));
        else
            out.push_back(addCommand(each.file.string(), model.name, matrixOf(each.pose)));
    }
    if (out.empty())
        throw base::Error("none of its scans is there", file.string(), "put it beside the scans that it names");
    if (!missing.empty())
        messages.push_back("Not there and left out: " + base::listed(missing) + ".");
    out.push_back(step("activate", names.models[1].name));
    return out;
}

std::vector<json> sceneCommands(const fs::path& file, std::vector<std::string>& messages) {
    if (isPoseFile(file))
        return scanCommands(file, messages);
    const json scene = modelsIn(file);
    std::vector<json> out, states;
    std::set<std::string> names;
    for (const json& model : scene.at("models")) {
        const std::string name = nameIn(model, file);
        if (!names.insert(name).second)
            throw base::Error("two models are called \"" + name + "\"", file.string(), advice);
        const std::string path =
            (file.parent_path() / pathOf(valueOf<std::string>(model, "file", nullptr, file))).string();
        if (opensAsScene(path))
            throw base::Error("\"" + name + "\" is a scene itself", file.string(), "name its models");
        const std::vector<double> matrix = matrixIn(model, file);
        if (out.empty())
            out = openCommands(path, name, matrix);
        else
            out.push_back(addCommand(path, name, matrix));
        addState(states, model, file, name);
    }
    out.insert(out.end(), states.begin(), states.end());
    const std::string first = nameIn(scene.at("models").front(), file);
    const auto active = valueOf(scene, "active", &first, file);
    if (!names.contains(active))
        throw base::Error("the active model \"" + active + "\" is none of its models", file.string(), advice);
    out.push_back(step("activate", active));
    return out;
}

/// A part of a file's name in every file system.
static std::string fileWord(const std::string& name) {
    std::string out = name;
    for (char& c : out)
        if (std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos)
            c = '_';
    return out;
}

/// Those of an earlier save under the same name, which may be written over.
static std::set<fs::path> ownFiles(const fs::path& file) {
    std::set<fs::path> out;
    std::error_code none;
    if (!fs::exists(file, none))
        return out;
    try {
        const json scene = modelsIn(file);
        for (const json& model : scene.at("models"))
            out.insert(file.parent_path() / pathOf(valueOf<std::string>(model, "file", nullptr, file)));
    } catch (const base::Error&) { // something else has that name: whatever lies beside it is not ours
    }
    return out;
}

std::vector<fs::path> modelFiles(const Scene& scene, const fs::path& file) {
    const std::string whole = file.filename().string(), stem = whole.substr(0, whole.size() - extension.size());
    const std::set<fs::path> own = ownFiles(file);
    std::vector<fs::path> out;
    std::error_code none;
    for (const SceneModel& model : scene.models) {
        const std::string name = stem + "." + fileWord(model.name);
        fs::path path = file.parent_path() / (name + ".ply");
        const auto taken = [&] {
            return std::ranges::find(out, path) != out.end() || (fs::exists(path, none) && !own.contains(path));
        };
        for (int k = 2; taken(); ++k)
            path = file.parent_path() / (name + "-" + std::to_string(k) + ".ply");
        out.push_back(std::move(path));
    }
    return out;
}

std::string sceneText(const Scene& scene, const std::vector<fs::path>& files) {
    nlohmann::ordered_json models = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < scene.models.size(); ++k) {
        const SceneModel& model = scene.models[k];
        models.push_back({{"name", model.name},
                          {"file", pathText(files[k].filename().string())},
                          {"matrix", matrixOf(model.pose)},
                          {"visible", model.visible},
                          {"locked", model.locked}});
    }
    const nlohmann::ordered_json out{{version, 1}, {"active", scene.models[scene.active].name}, {"models", models}};
    return out.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

} // namespace session
