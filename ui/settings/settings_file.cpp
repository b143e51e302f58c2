#include "ui/settings/settings_file.h"

namespace ui {

SettingsFile::SettingsFile(const QString& file)
    : m_store(file.isEmpty() ? std::make_unique<QSettings>("pointclay", "pointclay")
                             : std::make_unique<QSettings>(file, QSettings::IniFormat)) {}

Settings SettingsFile::read() {
    m_store->sync();
    m_last = readSettings(*m_store);
    return m_last;
}

QStringList merged(const QStringList& had, const QStringList& mine, const QStringList& stored) {
    QStringList out;
    for (const QString& each : mine)
        if (stored.contains(each) || !had.contains(each))
            out << each;
    for (const QString& each : stored)
        if (!had.contains(each) && !out.contains(each))
            out << each;
    return out;
}

void SettingsFile::write(const Settings& now) {
    if (now == m_last)
        return;
    const Entries had = entriesOf(m_last), mine = entriesOf(now);
    m_store->sync(); // reads what others have written
    for (auto it = had.begin(); it != had.end(); ++it)
        if (!mine.contains(it.key()))
            m_store->remove(it.key());
    for (auto it = mine.begin(); it != mine.end(); ++it) {
        const QVariant before = had.value(it.key());
        if (before == it.value())
            continue;
        const bool list = it.value().typeId() == QMetaType::QStringList;
        m_store->setValue(it.key(), list ? QVariant(merged(before.toStringList(), it.value().toStringList(),
                                                           m_store->value(it.key()).toStringList()))
                                         : it.value());
    }
    m_store->sync();
    m_last = now;
}

} // namespace ui
