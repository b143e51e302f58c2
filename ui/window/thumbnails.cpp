#include "ui/window/thumbnails.h"

#include "ui/window/main_window.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QPixmap>
#include <QStandardPaths>

namespace ui {

Thumbnails::Thumbnails(MainWindow& window, const QString& folder) : QObject(&window), m_window(window) {
    m_folder = folder.isEmpty()
                   ? QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/pointclay/recent"
                   : folder;
    m_rest.setSingleShot(true);
    m_rest.setInterval(restMs);
    connect(&m_rest, &QTimer::timeout, this, &Thumbnails::take);
    connect(&window.files(), &FileActions::recentChanged, &m_rest, qOverload<>(&QTimer::start));
}

QString Thumbnails::pictureOf(const std::string& file) const {
    const QByteArray name = QCryptographicHash::hash(QByteArray::fromStdString(file), QCryptographicHash::Sha1);
    return m_folder + '/' + name.toHex() + ".png";
}

/// What a camera with that shape would have seen, from the middle of the picture.
static QImage cropped(const QImage& picture, const QSize& size) {
    QRect part({}, size.scaled(picture.size(), Qt::KeepAspectRatio));
    part.moveCenter(picture.rect().center());
    return picture.copy(part).scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void Thumbnails::take() {
    const Snapshot& now = m_window.editor().snapshot();
    const std::vector<std::string>& recent = m_window.settings().recentFiles;
    if (m_window.editor().busy() || m_window.sculptView().look().showsInstead())
        return m_rest.start();
    if (recent.empty() || now.path.string() != recent.front() || now.modified)
        return; // by now something else
    const QImage picture = m_window.viewport().picture();
    if (picture.isNull() || !QDir().mkpath(m_folder))
        return;
    cropped(picture, size).save(pictureOf(recent.front()));
    forgetOthers();
}

void Thumbnails::forgetOthers() const {
    QStringList kept;
    for (const std::string& file : m_window.settings().recentFiles)
        kept << QFileInfo(pictureOf(file)).fileName();
    for (const QString& name : QDir(m_folder).entryList({"*.png"}, QDir::Files))
        if (!kept.contains(name))
            QFile::remove(m_folder + '/' + name);
}

QIcon Thumbnails::of(const std::string& file) const {
    const QFileInfo picture(pictureOf(file)), model(QString::fromStdString(file));
    if (!picture.exists() || picture.lastModified() < model.lastModified())
        return {};
    return QIcon(QPixmap(picture.filePath()));
}

} // namespace ui
