#include "ui/words/catalogue.h"

#include <atomic>
#include <QDir>
#include <string_view>

// Outside of namespaces, as Qt asks.
static void addResource() {
    Q_INIT_RESOURCE(words);
}

namespace ui {

constexpr const char* common = "pointclay";

static std::atomic<const Catalogue*> present = nullptr;

const Catalogue* Catalogue::installed() {
    return present;
}

Catalogue::~Catalogue() {
    const Catalogue* self = this;
    present.compare_exchange_strong(self, nullptr);
}

bool Catalogue::open(const QString& language) {
    addResource();
    if (!load(QString(":/words/pointclay_%1.qm").arg(language)))
        return false;
    present = this;
    return true;
}

/// Qt's own classes have a catalogue of their own.
static bool isQts(std::string_view context) {
    return context.starts_with('Q') && context != "QObject";
}

QString Catalogue::translate(const char* context, const char* source, const char* comment, int n) const {
    if (!source || !*source || (context && isQts(context)))
        return {};
    QString out = context ? QTranslator::translate(context, source, comment, n) : QString();
    if (out.isEmpty())
        out = QTranslator::translate(common, source, comment, n);
    const std::lock_guard lock(m_mutex);
    if (out.isEmpty())
        m_missing.insert(QString::fromUtf8(source));
    else
        m_english.insert(QString(out).remove('&'), QString::fromUtf8(source).remove('&'));
    return out;
}

QString Catalogue::find(const char* source, const char* table) const {
    const QString own = *table ? QTranslator::translate(table, source) : QString();
    return own.isEmpty() ? QTranslator::translate(common, source) : own;
}

QString Catalogue::englishOf(const QString& shown) const {
    const QString words = QString(shown).remove('&'), more = "…";
    const std::lock_guard lock(m_mutex);
    if (const auto found = m_english.find(words); found != m_english.end())
        return *found;
    if (words.endsWith(more))
        if (const auto found = m_english.find(words.chopped(1)); found != m_english.end())
            return *found + more;
    return words;
}

QSet<QString> Catalogue::missing() const {
    const std::lock_guard lock(m_mutex);
    return m_missing;
}

} // namespace ui
