#include "ui/window/keys.h"

#include <algorithm>
#include <QAction>
#include <QVariant>

namespace ui {

std::string keyIdOf(const PaletteEntry& entry) {
    const QString name = entry.action->objectName();
    return (entry.way + " > " + (name.isEmpty() ? entry.label : name)).toStdString();
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
