// The settings on disk, which all windows of a person share, in one program or several.
//
// They are written when they change, so that a crash loses nothing, and only what this window has changed: what another
// has written meanwhile stays. Lists (recent files, saved views) are merged entry by entry. Interface's thread only.
#pragma once

#include "ui/settings/settings.h"

#include <memory>
#include <QSettings>

namespace ui {

class SettingsFile {
  public:
    /// Empty: the person's own.
    explicit SettingsFile(const QString& file = {});

    /// What stands there now; from here on only what becomes different is written.
    Settings read();
    /// Writes what has changed since it was last read or written, if anything has.
    void write(const Settings& now);

  private:
    std::unique_ptr<QSettings> m_store;
    Settings m_last;
};

/// Entries of a list that this window has, `mine`, and had, with what others have added to `stored` and taken from it.
QStringList merged(const QStringList& had, const QStringList& mine, const QStringList& stored);

} // namespace ui
