// Small pictures of the models that were open lately, as they were seen last: taken a little after a model was opened
// or saved, kept in a folder of the person's cache. A file that others have changed since has none. Interface's thread
// only.
#pragma once

#include "ui/settings/settings.h"

#include <filesystem>
#include <QIcon>
#include <QObject>
#include <QTimer>

namespace ui {

class MainWindow;

class Thumbnails : public QObject {
    Q_OBJECT
  public:
    static constexpr QSize size{144, 96};
    static constexpr int restMs = 1500; ///< until the picture has come to rest

    /// An empty folder: the person's own.
    Thumbnails(MainWindow& window, const QString& folder);
    /// None: a null icon.
    QIcon of(const std::string& file) const;

  private:
    void take();
    QString pictureOf(const std::string& file) const;
    void forgetOthers() const;

    MainWindow& m_window;
    QString m_folder;
    QTimer m_rest;
};

} // namespace ui
