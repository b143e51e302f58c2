// The way of a file to a model, the same for `open` and for whoever only wants to tell what there is: first its faces
// become points, then what these lack is estimated. Inside this room and the command line.
#pragma once

#include "core/layers/layer_edits.h"
#include "core/session/face_options.h"
#include "core/session/surface_options.h"

namespace session {

/// What the file holds, its faces opened and nothing estimated.
struct OpenedFile {
    std::string name; ///< for errors
    io::FileModel model;
    SurfaceChange surface; ///< as the file or the parameters want it defined
    FacesOpened faces;
    bool ownNormals = false; ///< the file's
    bool ownSides = false;   ///< and they tell which way is outwards
};

/// `parameters`: of faces and surface, checked. Throws base::Error for those that exclude each other or do not fit the
/// file's faces, base::Cancelled.
OpenedFile opened(const std::string& name, io::FileModel model, const nlohmann::json& parameters,
                  const base::Progress& progress);

struct MadeModel {
    surface::Surface surface;
    base::UpAxis up = base::UpAxis::Y; ///< as the file tells, else guessed from the shape
    std::size_t merged = 0;            ///< points that were duplicates of others; the file's messages tell of them
};

/// Takes the file's points. Those whose supports were made for them, by the program that wrote them or by sampling, are
/// all kept; of others duplicates are merged. Throws base::Error where they make no surface, base::Cancelled.
MadeModel made(OpenedFile& file, const base::Progress& progress);

/// The layers that comments tell of, which are taken out. None where the model lacks their attributes, which is said.
/// Surfels that another program has moved since have taken the surface below their layers along.
layers::Stack layersIn(std::vector<std::string>& comments, surface::Surface& surface,
                       std::vector<std::string>& messages);

} // namespace session
