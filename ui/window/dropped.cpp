#include "ui/window/dropped.h"

#include "core/io/formats.h"

#include <QMimeData>
#include <QString>
#include <QStringList>
#include <QUrl>

namespace ui {

std::vector<std::filesystem::path> localFiles(const QMimeData& data) {
    std::vector<std::filesystem::path> out;
    for (const QUrl& url : data.urls())
        if (url.isLocalFile())
            out.emplace_back(url.toLocalFile().toStdString());
    return out;
}

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
