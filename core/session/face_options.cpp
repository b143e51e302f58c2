#include "core/session/face_options.h"

#include "core/base/error.h"
#include "core/session/commands/commands.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

std::span<const CommandParameter> faceParameters() {
    static const CommandParameter rows[] = {
        {"faces", "choice", "",
         "what to do with a file's faces: sample their surface, or keep the vertices; "
         "auto (the default) keeps the vertices of dense, even meshes and samples all others",
         "null", "auto sample vertices", 0, 0},
        {"sample_spacing", "number", "model units",
         "spacing of samples on the faces, of all bodies alike; by default it follows from sample_count and from what "
         "each body needs",
         "null", "", positive, largest},
        {"sample_count", "integer", "",
         "number of samples on the faces, within a percent, small bodies denser than large ones; by default what the "
         "shapes need, at least 100,000",
         "null", "", 4, 200'000'000},
        {"sharp", "number or choice", "degrees",
         "edges of the faces stay sharp where the normals on both sides differ by more than this, in pictures, meshes, "
         "measures, queries and strokes; off rounds them all; 40 by default",
         "null", "off", 0, 180},
        {"creases", "boolean", "",
         "samples of the faces get labels of cells that meet in the sharp edges; off only keeps their normals apart, "
         "and edges are rounded over about a support; by default as far as there are edges to keep",
         "null", "", 0, 0},
    };
    return rows;
}

mesh::FaceOptions faceOptions(const json& complete) {
    mesh::FaceOptions out;
    const bool spacing = complete.contains("sample_spacing"), count = complete.contains("sample_count");
    if (spacing && count)
        throw base::Error("a spacing and a count of samples exclude each other", {}, "give one of them");
    const std::string use = complete.value("faces", "auto");
    out.use = use == "sample"     ? mesh::FaceUse::Sample
              : use == "vertices" ? mesh::FaceUse::Vertices
                                  : mesh::FaceUse::Auto;
    if ((spacing || count) && out.use == mesh::FaceUse::Vertices)
        throw base::Error("the vertices are kept, so that nothing is sampled", {},
                          "leave out the spacing or count of samples, or sample the faces");
    out.spacing = complete.value("sample_spacing", 0.0);
    out.count = complete.value("sample_count", std::size_t(0));
    if (complete.contains("sharp"))
        out.sharpRad = complete["sharp"].is_string() ? std::numeric_limits<double>::infinity()
                                                     : complete["sharp"].get<double>() * std::numbers::pi / 180;
    if (const auto creases = complete.find("creases"); creases != complete.end())
        out.creases = *creases == true || *creases == "on"; // before a command is completed it may say either
    if (out.asksForCreases() && out.use == mesh::FaceUse::Vertices)
        throw base::Error("the vertices are kept, and have no creases", {},
                          "leave out the creases, or sample the faces");
    if (out.asksForCreases() && !std::isfinite(out.sharpRad))
        throw base::Error("creases are where edges of the faces are sharp, and no edge is", {},
                          "leave out 'sharp off' or the creases");
    return out;
}

void refuseSamples(const mesh::FaceOptions& options, const std::string& where) {
    if (options.asksForSamples())
        throw base::Error("there are no faces to sample", where, "leave out what is said of samples");
    if (options.asksForCreases())
        throw base::Error("there are no faces with sharp edges", where, "leave out the creases");
}

FacesOpened openFaces(io::FileModel& model, surface::SurfaceDefinition& definition, const mesh::FaceOptions& options,
                      const base::Progress& progress) {
    if (model.polygons.size() == 0 || definition.manifold != surface::Manifold::Surface) {
        refuseSamples(options, {});
        return {};
    }
    std::vector<base::Vec3f> positions(model.points.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = model.points.items[i].position;
    const mesh::CutPolygons cut = mesh::cut(model.polygons, positions);
    const mesh::FacePaint paint(model.polygons, cut);
    mesh::OpenedFaces opened = mesh::openFaces(std::move(model.points), cut.triangles, definition, options, progress,
                                               model.polygons.painted() ? &paint : nullptr);
    model.points = std::move(opened.points);
    model.polygons = {};
    model.messages.insert(model.messages.end(), opened.messages.begin(), opened.messages.end());
    if (opened.closed && definition.boundary == surface::Boundary::Auto)
        definition.boundary = surface::Boundary::None;
    definition.knownRims = opened.rims;
    return {opened.sampled, opened.closed, opened.apart, opened.blades};
}

} // namespace session
