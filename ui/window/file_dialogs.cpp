#include "ui/window/file_dialogs.h"

#include "core/io/formats.h"
#include "core/io/mesh_formats.h"
#include "core/session/scene/scene_file.h"

#include <QFileInfo>
#include <QObject>
#include <QStringList>

namespace ui {

namespace fs = std::filesystem;

QString textOf(const fs::path& path) {
    return QString::fromStdString(path.string());
}

fs::path pathOf(const QString& text) {
    return fs::path(text.toStdString());
}

static constexpr const char* sceneFiles = "*.scene.json";

/// "*.ply *.PLY" of "ply PLY".
static QString patterns(const char* extensions) {
    QStringList out;
    for (const QString& extension : QString(extensions).split(' ', Qt::SkipEmptyParts))
        out << "*." + extension;
    return out.join(' ');
}

static QString entry(const char* label, const char* extensions) {
    return QString("%1 (%2)").arg(QObject::tr(label), patterns(extensions));
}

QString openFilter() {
    QStringList all, each;
    for (const auto& row : io::formatTable())
        if (row.read) {
            all << patterns(row.extensions);
            each << entry(row.label, row.extensions);
        }
    all << "*.gz" << sceneFiles << "*.conf"; // any of them, packed; several of them
    each.prepend(QObject::tr("Models (%1)").arg(all.join(' ')));
    each << QObject::tr("All files (*)");
    return each.join(";;");
}

QString saveFilter() {
    QStringList each;
    for (const auto& row : io::formatTable())
        if (row.write)
            each << entry(row.label, row.extensions);
    each << QObject::tr("Scene, a file for each model (%1)").arg(sceneFiles);
    return each.join(";;");
}

QString meshFilter() {
    QStringList each;
    for (const auto& row : io::meshFormatTable())
        each << entry(row.label, row.extensions);
    return each.join(";;");
}

bool isNative(const fs::path& path) {
    return textOf(path.extension()).toLower() == ".ply" || session::isSceneFile(path);
}

fs::path completed(const QString& file, const QString& filter) {
    if (!QFileInfo(file).suffix().isEmpty())
        return pathOf(file);
    const QString first = filter.section("*.", 1, 1).section(' ', 0, 0).section(')', 0, 0);
    return pathOf(first.isEmpty() ? file : file + "." + first);
}

QString folderFor(const Snapshot& model, const Settings& settings) {
    if (!model.path.empty())
        return textOf(model.path.parent_path());
    return settings.recentFiles.empty() ? QString() : textOf(fs::path(settings.recentFiles.front()).parent_path());
}

} // namespace ui
