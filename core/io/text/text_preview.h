// What a file of points as text seems to hold, before it is opened, and how it is opened once a person has said what
// its columns are (io/README 2.4).
#pragma once

#include "core/base/progress.h"
#include "core/io/file_model.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace io {

struct TextPreview {
    std::vector<std::string> columns;           ///< what opening would take each of them for; "-": it leaves it out
    std::vector<std::vector<std::string>> rows; ///< the first ones as they stand there; at most 8
    base::Vec3d extent;                         ///< of the points at the file's beginning, along x, y and z
    std::vector<std::string> messages;          ///< that opening would tell of it
    bool sure = true; ///< false: its names do not tell which columns are x, y and z, and the first three are guessed
};

/// Of the first quarter of a megabyte. Nothing for files of other formats, packed ones, and what is no file. Throws
/// base::Error where opening would. `columns`: as for `readColumns`; empty: the file tells.
std::optional<TextPreview> previewText(const std::filesystem::path& path, const std::vector<std::string>& columns = {});

/// Points as text whose columns are told, each by a name ("x", "nx", "red", "intensity", ...), or "-" where it is left
/// out. Throws base::Error for files of other formats, and where the names do not fit the rows; base::Cancelled.
FileModel readColumns(const std::filesystem::path& path, const std::vector<std::string>& columns,
                      const base::Progress& progress = {});

/// Names in a text, parted by blanks, commas or semicolons. Throws base::Error unless x, y and z are among them and no
/// name stands there twice.
std::vector<std::string> columnNames(std::string_view text);

} // namespace io
