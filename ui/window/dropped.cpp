#include "ui/window/dropped.h"

#include "core/io/formats.h"

#include <QString>
#include <QStringList>

namespace ui {

Dropped droppedAs(const std::filesystem::path& path) {
    std::error_code none;
    if (std::filesystem::is_directory(path, none))
        return Dropped::Folder;
    const auto extensionOf = [](const std::filesystem::path& name) {
        return QString::fromStdString(name.extension().string()).mid(1).toLower();
    };
    QString extension = extensionOf(path);
    if (extension == "gz") // whatever is packed in it
        extension = extensionOf(path.stem());
    if (QStringList{"png", "jpg", "jpeg"}.contains(extension))
        return Dropped::Image;
    for (const auto& row : io::formatTable())
        if (row.read && QString(row.extensions).toLower().split(' ', Qt::SkipEmptyParts).contains(extension))
            return Dropped::Model;
    return Dropped::Other;
}

} // namespace ui
