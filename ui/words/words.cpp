#include "ui/words/words.h"

#include "ui/words/catalogue.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace ui {

QString spoken(const char* text, const char* table) {
    return *text ? QCoreApplication::translate(table, text) : QString();
}

QString spoken(std::string_view text, const char* table) {
    return spoken(std::string(text).c_str(), table);
}

QString spokenMessage(std::string_view text) {
    const QString whole = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
    const Catalogue* catalogue = Catalogue::installed();
    if (!catalogue)
        return whole;
    static const QRegularExpression given(R"("[^"]*"|[^\s"]*\.[a-z]{2,5}\b|-?\d[\d,]*(\.\d+)?(e[-+]?\d+)?)");
    QString words;
    QStringList values;
    qsizetype from = 0;
    for (auto all = given.globalMatch(whole); all.hasNext();) {
        const QRegularExpressionMatch each = all.next();
        words += whole.mid(from, each.capturedStart() - from) + '%' + QString::number(values.size() + 1);
        values << each.captured();
        from = each.capturedEnd();
    }
    words += whole.mid(from);
    QString out = catalogue->find(words.toUtf8().constData(), "message");
    if (out.isEmpty())
        return whole;
    for (qsizetype i = values.size(); i > 0; --i) // %12 before %1
        out.replace('%' + QString::number(i), values[i - 1]);
    return out;
}

QString englishOf(const QString& shown) {
    const Catalogue* catalogue = Catalogue::installed();
    return catalogue ? catalogue->englishOf(shown) : QString(shown).remove('&');
}

} // namespace ui
