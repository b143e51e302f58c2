#include "ui/window/keys.h"

#include "ui/words/words.h"

#include <algorithm>
#include <QAction>
#include <QVariant>

namespace ui {

/// In English whatever the window speaks, and as it was at first: words of undo change with what would be undone.
std::string keyIdOf(const PaletteEntry& entry) {
    constexpr const char* id = "key-id";
    if (!entry.action->property(id).isValid()) {
        QStringList way = entry.way.split(" > ");
        for (QString& each : way)
            each = englishOf(each);
        const QString name = entry.action->objectName(), said = entry.action->property(inEnglish).toString();
        way << (!name.isEmpty() ? name : !said.isEmpty() ? said : englishOf(entry.label));
        entry.action->setProperty(id, way.join(" > "));
    }
    return entry.action->property(id).toString().toStdString();
}

QList<QKeySequence> ownKeysOf(QAction& action) {
    constexpr const char* own = "own-keys";
    if (!action.property(own).isValid()) {
        QStringList texts;
        for (const QKeySequence& key : action.shortcuts())
            texts << key.toString(QKeySequence::PortableText);
        action.setProperty(own, texts);
    }
    QList<QKeySequence> out;
    for (const QString& text : action.property(own).toStringList())
        out << QKeySequence(text, QKeySequence::PortableText);
    return out;
}

void applyKeys(const std::vector<PaletteEntry>& entries, const Keys& chosen) {
    for (const PaletteEntry& entry : entries) {
        if (!entry.action)
            continue;
        const QList<QKeySequence> own = ownKeysOf(*entry.action);
        const auto found = chosen.find(keyIdOf(entry));
        if (found == chosen.end())
            entry.action->setShortcuts(own);
        else
            entry.action->setShortcut(QKeySequence(QString::fromStdString(found->second), QKeySequence::PortableText));
    }
}

bool disturb(const QKeySequence& one, const QKeySequence& other) {
    return !one.isEmpty() && !other.isEmpty() &&
           (one.matches(other) != QKeySequence::NoMatch || other.matches(one) != QKeySequence::NoMatch);
}

static bool disturbs(const QKeySequence& key, const QAction& action) {
    return std::ranges::any_of(action.shortcuts(), [&](const QKeySequence& each) { return disturb(key, each); });
}

QStringList conflictsOf(const std::vector<PaletteEntry>& entries, const QAction& action, const QKeySequence& key) {
    QStringList out;
    for (const PaletteEntry& entry : entries)
        if (entry.action && entry.action != &action && disturbs(key, *entry.action))
            out << entry.label;
    return out;
}

} // namespace ui
