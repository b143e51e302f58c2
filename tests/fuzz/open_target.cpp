// Opening: what a file lacks is estimated, its faces are sampled; what comes of it is saved and opened again. Format
// and parameters follow from the length.
#include "core/io/file_bytes.h"
#include "core/io/formats.h"
#include "core/session/scene/models_read.h"
#include "core/session/scene/scene_ply.h"
#include "fuzz/fuzzed.h"

#include <nlohmann/json.hpp>

namespace {

constexpr std::size_t mostPoints = 300;

const nlohmann::json& parametersOf(std::size_t number) {
    static const auto some = nlohmann::json::parse(R"([
        {}, {"sample_count": 120}, {"faces": "vertices"}, {"frame": "apss"}, {"frame": "covariance"},
        {"manifold": "curve"}, {"neighbours": 12, "boundary": "none"}, {"weight": "gaussian", "frame": "hyperplanes"}])");
    return some[number % some.size()];
}

io::FileModel fileOf(const session::Scene& scene) {
    return scene.models.size() == 1 ? session::fileModel(scene.models.front()) : session::togetherAsParts(scene);
}

void open(io::FileModel read, std::size_t number, const base::Progress& progress) {
    std::vector<std::string> messages;
    const session::Scene fresh = session::modelsOf(std::move(read), "a", parametersOf(number), messages, progress);
    for (const session::SceneModel& each : fresh.models)
        each.surface.tree().validate();
    const std::filesystem::path path = fuzz::folder() / "out.ply";
    io::write(path, fileOf(fresh), {});
    const session::Scene same = session::readModels(path, path, nlohmann::json::object(), messages, {});
    fuzz::require(same.models.size() == fresh.models.size(), "all models come back");
    for (std::size_t k = 0; k < same.models.size(); ++k)
        fuzz::require(same.models[k].up == fresh.models[k].up, "what is upwards comes back");
    fuzz::require(fresh.models.size() > 1 || session::contentHash(same) == session::contentHash(fresh),
                  "what was saved is what is opened");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const io::FileBytes bytes(fuzz::oneOf("a.ply a.xyz a.obj a.off a.stl a", size), std::string(data, data + size));
    const fuzz::Deadline deadline;
    fuzz::tried([&] {
        io::FileModel model = io::read(bytes, deadline.progress(), fuzz::folder());
        if (model.points.size() <= mostPoints)
            open(std::move(model), size / 6, deadline.progress());
    });
    return 0;
}
