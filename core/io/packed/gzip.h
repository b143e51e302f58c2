// Files packed with gzip (RFC 1952), of any format: told by their first bytes.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_bytes.h"

namespace io {

bool isGzip(const FileBytes& file);

/// All members of the file, one behind the other, under its name without `.gz`; messages go on naming the file itself.
/// Throws base::Error where it is damaged, cut off, or becomes longer than mostInflated(); base::Cancelled.
FileBytes unpackedGzip(const FileBytes& file, const base::Progress& progress);

} // namespace io
