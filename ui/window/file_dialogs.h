// What file dialogs offer and what becomes of their answers, from the tables of formats.
#pragma once

#include "ui/settings/settings.h"
#include "ui/work/snapshot.h"

#include <filesystem>
#include <QString>

namespace ui {

/// All readable formats in one entry, then each by its label.
QString openFilter();
/// One entry for each writable format; the first is the native one.
QString saveFilter();
/// One entry for each mesh format.
QString meshFilter();

/// The native format keeps everything.
bool isNative(const std::filesystem::path& path);
/// The chosen file, with the extension that the chosen filter names where the person gave none.
std::filesystem::path completed(const QString& file, const QString& filter);

/// In which dialogs start: the model's folder, or that of the newest recent file; else empty.
QString folderFor(const Snapshot& model, const Settings& settings);

QString textOf(const std::filesystem::path& path);
std::filesystem::path pathOf(const QString& text);

} // namespace ui
