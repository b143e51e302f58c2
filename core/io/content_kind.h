// What the first bytes of a file say it is, whatever its name says (io/README 2.1).
#pragma once

#include "core/io/file_bytes.h"

namespace io {

/// Id of the format ("ply", "off", "stl") that the content proves, "" where it proves nothing. Throws base::Error for
/// contents that no reader can use and that have a name: git-lfs pointers, LAS, E57, PCD, compressed files...
std::string contentKind(const FileBytes& file);

/// Throws the sentence for a format that is known but cannot be read, named by its extension (lower case, no dot).
void refuseUnreadable(const FileBytes& file, const std::string& extension);

} // namespace io
