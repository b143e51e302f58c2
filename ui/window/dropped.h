// Files that are dropped on the window, and what becomes of them. Free functions, from any thread.
#pragma once

#include <filesystem>
#include <vector>

class QMimeData;

namespace ui {

enum class Dropped {
    Model,  ///< opened
    Image,  ///< pressed in by the brush
    Folder, ///< where the dialog for opening begins
    Other   ///< nothing, and that is said
};

std::vector<std::filesystem::path> localFiles(const QMimeData& data);
/// By what it is and by its extension.
Dropped droppedAs(const std::filesystem::path& path);

} // namespace ui
