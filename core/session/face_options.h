// What becomes of a file's faces when it is opened, as parameters of `open` and of every subcommand.
#pragma once

#include "core/io/file_model.h"
#include "core/mesh/faces/open_faces.h"
#include "core/session/command.h"

namespace session {

/// `faces`, `sample_spacing`, `sample_count`, `sharp` and `creases`; all may be left out.
std::span<const CommandParameter> faceParameters();

/// Throws base::Error where two parameters exclude each other.
mesh::FaceOptions faceOptions(const nlohmann::json& complete);

/// Throws base::Error, in the name of `where`, for options that ask for samples or creases: of a model that has no
/// faces.
void refuseSamples(const mesh::FaceOptions& options, const std::string& where);

struct FacesOpened {
    bool sampled = false; ///< the points are samples of the faces
    bool closed = false;  ///< the faces have no boundary
    bool apart = false;   ///< the samples resolve all walls
    bool blades = false;  ///< but towards edges of less than 60 degrees, which there are
};

/// The model's points become those of its faces, if it has any; `definition` learns that a closed surface has no
/// boundary, unless a limit was asked for. Messages go to the model's. Throws base::Error where samples are asked for
/// and there are no faces.
FacesOpened openFaces(io::FileModel& model, surface::SurfaceDefinition& definition, const mesh::FaceOptions& options,
                      const base::Progress& progress);

} // namespace session
