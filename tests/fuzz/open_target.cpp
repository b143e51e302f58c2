// Opening: what a file lacks is estimated, its faces are sampled; what comes of it is saved and opened again. Format
// and parameters follow from the length.
#include "core/io/file_bytes.h"
#include "core/io/formats.h"
#include "core/session/document.h"
#include "core/session/opened_file.h"
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

void open(io::FileModel read, std::size_t number, const base::Progress& progress) {
    session::OpenedFile file = session::opened("a", std::move(read), parametersOf(number), progress);
    const session::MadeModel fresh = session::made(file, progress);
    fresh.surface.tree().validate();
    session::Document document;
    session::Provenance provenance;
    provenance.origin = file.model.origin;
    provenance.comments = file.model.comments;
    provenance.elements = file.model.elements;
    document.reset(fresh.surface, provenance, fresh.up);

    const std::filesystem::path path = fuzz::folder() / "out.ply";
    io::write(path, document.fileModel(), {});
    session::OpenedFile again = session::opened("b", io::read(path), nlohmann::json::object(), {});
    const session::MadeModel same = session::made(again, {});
    fuzz::require(same.up == fresh.up, "what is upwards comes back");
    fuzz::require(session::contentHash(same.surface.tree(), again.model.origin) == document.hash(),
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
