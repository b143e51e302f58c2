// Materials of an OBJ file: of its libraries (.mtl) what paints faces, `map_Kd`.
#pragma once

#include "core/io/face_pictures.h"

#include <map>

namespace io {

/// The picture of each material that has one, by the material's name. `libraries`: what stands behind `mtllib`. A
/// library that is missing in the model's folder paints nothing, and is told in `messages`.
std::map<std::string, PictureName, std::less<>> readMaterials(const std::filesystem::path& folder,
                                                              const std::vector<std::string>& libraries,
                                                              std::vector<std::string>& messages);

/// Without blanks at either end.
std::string_view trimmed(std::string_view text);

} // namespace io
