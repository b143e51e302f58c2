#include "ui/words/language.h"

#include "ui/words/catalogue.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace ui {

std::span<const LanguageRow> languageTable() {
    static const LanguageRow rows[] = {
        {"system", QT_TRANSLATE_NOOP("ui", "As the Desktop"), QT_TRANSLATE_NOOP("ui", "English where it is neither")},
        {"en", "English", QT_TRANSLATE_NOOP("ui", "From the next start on")},
        {"de", "Deutsch", QT_TRANSLATE_NOOP("ui", "From the next start on")},
    };
    return rows;
}

QString languageFor(std::string_view id, const QStringList& desktop) {
    if (id == "en" || id == "de")
        return QString::fromLatin1(id.data(), static_cast<qsizetype>(id.size()));
    for (const QString& each : desktop)
        for (const char* known : {"en", "de"})
            if (each.section('-', 0, 0).section('_', 0, 0) == known)
                return known;
    return "en";
}

void speak(QCoreApplication& application, const QString& language) {
    if (language == "en")
        return;
    auto* ours = new Catalogue(&application);
    if (!ours->open(language))
        return;
    auto* qts = new QTranslator(&application);
    if (qts->load("qtbase_" + language, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(qts);
    QCoreApplication::installTranslator(ours);
}

} // namespace ui
