#include "ui/window/dropped.h"

#include "core/io/formats.h"

#include <QString>
#include <QStringList>

namespace ui {

Dropped droppedAs(const std::filesystem::path& path) {
    std::error_code none;
    if (std::filesystem::is_directory(path, none))
        return Dropped::Folder;
    const QString extension = QString::fromStdString(path.extension().string()).mid(1).toLower();
    if (QStringList{"png", "jpg", "jpeg"}.contains(extension))
        return Dropped::Image;
    for (const auto& row : io::formatTable())
        if (row.read && QString(row.extensions).toLower().split(' ', Qt::SkipEmptyParts).contains(extension))
            return Dropped::Model;
    return Dropped::Other;
}

} // namespace ui
