// What becomes of a file that is dropped on the window. Free functions, from any thread.
#pragma once

#include <filesystem>

namespace ui {

enum class Dropped {
    Model,  ///< opened
    Image,  ///< pressed in by the brush
    Folder, ///< where the dialog for opening begins
    Other   ///< nothing, and that is said
};

/// By what it is and by its extension.
Dropped droppedAs(const std::filesystem::path& path);

} // namespace ui
