// The table of file formats; open and save dialogs, `convert`, help and tests are loops over it.
//
// Reading throws base::Error with one sentence (what, where, what to do) and never trusts a header's counts before the
// bytes are there. Writing goes beside the target and is renamed when complete, so that no partial file is ever seen.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_model.h"

#include <filesystem>
#include <span>
#include <string>

namespace io {

class FileBytes;

struct FormatRow {
    const char* id;         ///< "ply"
    const char* label;      ///< "Polygon File Format"
    const char* extensions; ///< "ply" or "xyz txt csv pts asc pwn", separated by blanks, lower case
    base::UpAxis up;        ///< what is upwards in most files of it
    /// Null: cannot be read. `folder`: where pictures that the file names are looked for.
    FileModel (*read)(const FileBytes& file, const base::Progress&, const std::filesystem::path& folder);
    void (*write)(const std::filesystem::path&, const FileModel&, const base::Progress&); ///< null: cannot be written
    /// What files of that extension hold beside positions, in words: normals, colours, alpha, supports, masks,
    /// definition, elements, names of attributes, or attributes for any. Null where nothing is written.
    const char* (*holds)(std::string_view extension);
};

std::span<const FormatRow> formatTable();

/// By extension first, then by content where the extension lies. The file is read once, so that it may be a pipe.
/// Pictures and materials that the file names are those of `folder`, its own unless another is given.
FileModel read(const std::filesystem::path& path, const base::Progress& progress = {},
               const std::filesystem::path& folder = {});
/// The same for bytes that are there already, under the name that they have. The folder is as given.
FileModel read(const FileBytes& file, const base::Progress& progress, const std::filesystem::path& folder);
void write(const std::filesystem::path& path, const FileModel& model, const base::Progress& progress = {});
/// One sentence with all that the model has and a file of that name cannot hold; empty where it holds everything.
std::string lossOf(const std::filesystem::path& path, const FileModel& model);

} // namespace io
