// The pictures that a model file names for its faces. They must lie in the file's folder or below it: a model from
// elsewhere reads nothing else of the machine.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_model.h"

#include <filesystem>

namespace io {

/// A file that a model in `folder` names: its path, or empty where it would lie outside. Absolute names, which other
/// machines have left, stand for the file of that name in the folder.
std::filesystem::path besideModel(const std::filesystem::path& folder, std::string_view name);

/// What a model says of a picture.
struct PictureName {
    std::string file;
    bool clamped = false;
    std::string_view bytes = {}; ///< of a picture inside of the model's file
    bool inside = false;         ///< it can only be there; then `file` is its name in messages
};

/// Reads the pictures that faces use into model.polygons.pictures, as many as `names`. One that is missing, broken, too
/// large or elsewhere is left out with a message; all together may have 2^28 pixels. Throws base::Cancelled.
void readPictures(FileModel& model, const std::filesystem::path& folder, const std::vector<PictureName>& names,
                  const base::Progress& progress = {});

} // namespace io
