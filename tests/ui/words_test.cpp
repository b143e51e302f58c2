// The window in German: nothing of it lacks a translation, and none says something else than the English.
#include "support/patience.h"
#include "support/registry.h"
#include "table_texts.h"
#include "ui/window/command_desk.h"
#include "ui/window/keys.h"
#include "ui/window_fixture.h"
#include "ui/words/catalogue.h"
#include "ui/words/language.h"
#include "ui/words/words.h"

#include <algorithm>
#include <QFile>
#include <QLabel>
#include <QLibraryInfo>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QToolButton>
#include <QXmlStreamReader>

using test::WindowFixture;

class WordsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyTextOfTheTablesIsTranslated();
    void everyLiteralOfTheWindowIsTranslated();
    void translationsKeepPlaceholdersAndEnds();
    void noTranslationIsLeftOver();
    void keysAreTheSameInEveryLanguage();
    void thePaletteKnowsOtherWordsInGermanToo();
    void entriesOfAMenuHaveLettersOfTheirOwn();
    void aGermanWindowLacksNoWord();
    void commandsTellInGermanWithTheirNumbers();
    void theDesktopsLanguageIsTakenWhereThereIsIt();
    void numbersAndSessionsAreTheSame();
    void barsHaveRoomInASmallWindow();
};

static const QString sources = POINTCLAY_SOURCES;

/// The window speaks German while it lives.
struct German {
    ui::Catalogue catalogue;
    German() {
        if (catalogue.open("de"))
            QCoreApplication::installTranslator(&catalogue);
    }
    ~German() { QCoreApplication::removeTranslator(&catalogue); }
};

struct Message {
    QString context, source;
    QStringList shown; ///< several where a number decides
};

static std::vector<Message> messagesOf(const QString& path) {
    QFile file(path);
    std::vector<Message> out;
    if (!file.open(QIODevice::ReadOnly))
        return out;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == u"name")
            context = xml.readElementText();
        else if (xml.name() == u"source")
            out.push_back({context, xml.readElementText(), {}});
        else if (xml.name() == u"numerusform" && !out.empty())
            out.back().shown << xml.readElementText();
        else if (xml.name() == u"translation" && !out.empty() && !out.back().source.contains("%n"))
            out.back().shown << xml.readElementText();
    }
    return out;
}

static std::vector<Message> catalogueMessages() {
    return messagesOf(sources + "/ui/words/pointclay_de.ts");
}

/// All texts of tr() and its like, by Qt's own tool; empty where it is not installed.
static QStringList literals() {
    const QTemporaryDir folder;
    const QString out = folder.filePath("literals.ts");
    QProcess::execute(QLibraryInfo::path(QLibraryInfo::BinariesPath) + "/lupdate",
                      {"-silent", "-no-obsolete", sources + "/ui", "-ts", out});
    QStringList texts;
    for (const Message& each : messagesOf(out))
        texts << each.source;
    return texts;
}

using Lacking = std::vector<std::pair<QString, QString>>; // table, text

/// The first of them, and all of them as the catalogue has them, in the file that POINTCLAY_LACKING names.
static QString told(const Lacking& texts) {
    QFile file(qEnvironmentVariable("POINTCLAY_LACKING"));
    QString out = QString("%1 texts (ui/words/README.md says what to do): ").arg(texts.size());
    const bool open = !texts.empty() && !file.fileName().isEmpty() && file.open(QIODevice::Append);
    for (const auto& [table, text] : texts) {
        if (open)
            file.write(QString("<message><!--%1--><source>%2</source><translation></translation></message>\n")
                           .arg(table, text.toHtmlEscaped())
                           .toUtf8());
        if (out.size() < 500)
            out += '"' + text + "\" ";
    }
    return out;
}

void WordsTest::everyTextOfTheTablesIsTranslated() {
    const test::Texts texts = test::tableTexts(); // in English
    const German german;
    Lacking without;
    for (const auto& [table, text] : texts)
        if (german.catalogue.find(text.c_str(), table.c_str()).isEmpty())
            without.emplace_back(QString::fromStdString(table), QString::fromStdString(text));
    QVERIFY2(without.empty(), qPrintable(told(without)));
}

void WordsTest::everyLiteralOfTheWindowIsTranslated() {
    const QStringList texts = literals();
    if (texts.isEmpty())
        QSKIP("lupdate is not there (qt6-l10n-tools)");
    German german;
    Lacking without;
    for (const QString& text : texts)
        if (german.catalogue.find(text.toUtf8().constData()).isEmpty() &&
            german.catalogue.translate("pointclay", text.toUtf8().constData(), nullptr, 1).isEmpty())
            without.emplace_back(QString(), text);
    QVERIFY2(without.empty(), qPrintable(told(without)));
}

static QStringList placeholders(const QString& text) {
    static const QRegularExpression each("%(\\d|n|L\\d)|<[^>]+>|\\(\\*\\.[^)]*\\)|\\[\\*\\]");
    QStringList out;
    for (auto all = each.globalMatch(text); all.hasNext();)
        out << all.next().captured();
    out.sort();
    return out;
}

void WordsTest::translationsKeepPlaceholdersAndEnds() {
    const std::vector<Message> all = catalogueMessages();
    QVERIFY(all.size() > 1000);
    for (const Message& each : all)
        for (const QString& text : each.shown) {
            const QString said = each.source + " -> " + text;
            QVERIFY2(!text.isEmpty() && placeholders(text) == placeholders(each.source), qPrintable(said));
            QVERIFY2(text.endsWith("…") == each.source.endsWith("…"), qPrintable(said));
            QVERIFY2(text.count('&') <= 1 && !text.contains("  ") == !each.source.contains("  "), qPrintable(said));
        }
}

/// Of what the tables and the window do not say any more.
void WordsTest::noTranslationIsLeftOver() {
    const QStringList texts = literals();
    if (texts.isEmpty())
        QSKIP("lupdate is not there (qt6-l10n-tools)");
    std::set<std::string> known;
    for (const QString& each : texts)
        known.insert(each.toStdString());
    for (const auto& [table, text] : test::tableTexts())
        known.insert(text);
    for (const Message& each : catalogueMessages())
        if (each.context == "pointclay" || each.context == "tool" || each.context == "falloff")
            QVERIFY2(known.contains(each.source.toStdString()), qPrintable(each.source));
}

static QStringList keyIds() {
    WindowFixture f;
    QStringList out;
    for (const ui::PaletteEntry& entry : ui::paletteEntries(*f.window->menuBar()))
        if (!entry.label.contains("CPU") && !entry.label.contains("OpenGL")) // no action
            out << QString::fromStdString(ui::keyIdOf(entry));
    return out;
}

void WordsTest::keysAreTheSameInEveryLanguage() {
    const QStringList english = keyIds();
    const German german;
    QCOMPARE(keyIds(), english);
}

void WordsTest::thePaletteKnowsOtherWordsInGermanToo() {
    const German german;
    WindowFixture f;
    const auto found = [entries = ui::paletteEntries(*f.window->menuBar())](const char* typed) {
        QStringList out;
        for (const ui::PaletteEntry& each : entries)
            if (ui::fitOf(each, typed) > 0)
                out << QString::fromStdString(ui::keyIdOf(each));
        return out;
    };
    for (const char* typed : {"abziehen", "subtract", "Boolesch", "primitive"})
        QVERIFY2(found(typed).contains("Model > Solids > Add a shape…"), typed);
    for (const char* typed : {"neue ebene", "new layer"})
        QVERIFY2(!found(typed).filter("View > ").isEmpty(), typed);
}

static void checkLetters(const QList<QAction*>& actions) {
    QMap<QString, QString> taken;
    for (const QAction* each : actions) {
        if (each->menu())
            checkLetters(each->menu()->actions());
        const QString letter = QKeySequence::mnemonic(each->text()).toString();
        if (each->isSeparator() || letter.isEmpty())
            continue;
        QVERIFY2(!taken.contains(letter), qPrintable(each->text() + " and " + taken[letter]));
        taken[letter] = each->text();
    }
}

void WordsTest::entriesOfAMenuHaveLettersOfTheirOwn() {
    for (const bool translated : {false, true}) {
        const auto german = translated ? std::make_unique<German>() : nullptr;
        WindowFixture f;
        checkLetters(f.window->menuBar()->actions());
        for (const QAction* menu : f.window->menuBar()->actions())
            QVERIFY2(!QKeySequence::mnemonic(menu->text()).isEmpty(), qPrintable(menu->text()));
    }
}

void WordsTest::aGermanWindowLacksNoWord() {
    const German german;
    WindowFixture f;
    QCOMPARE(f.window->menuBar()->actions().front()->text().remove('&'), QString("Datei"));
    QVERIFY(f.make("sphere", 800));
    auto& desk = *f.window->findChild<ui::CommandDesk*>();
    for (const session::CommandRow& row : session::commandTable())
        if (ui::hasDialog(row)) {
            desk.open(row);
            desk.dialog()->reject();
        }
    for (const sculpt::ToolRow& tool : sculpt::toolTable()) {
        f.window->settings().tool = tool.id;
        f.window->showHint();
    }
    f.drag(f.centre(), f.centre() + QPointF(30, 0));
    for (const nlohmann::json& command :
         {nlohmann::json{{"op", "outliers"}}, {{"op", "fill"}}, {{"op", "layer"}, {"do", "add"}}, {{"op", "undo"}}}) {
        f.editor().run(command);
        QVERIFY(f.settle());
    }
    Lacking missing;
    for (const QString& each : german.catalogue.missing())
        if (each.contains(QRegularExpression("[a-zA-Z]{2}"))) // else a number, or an axis
            missing.emplace_back("seen", each);
    QVERIFY2(missing.empty(), qPrintable(told(missing)));
}

void WordsTest::commandsTellInGermanWithTheirNumbers() {
    const char* said = "5 of 23 boundary loops filled with 22,987 points";
    QCOMPARE(ui::spokenMessage(said), QString(said));
    const German german;
    QCOMPARE(ui::spokenMessage(said), QString("5 von 23 Randschleifen mit 22,987 Punkten gefüllt"));
    const char* unknown = "nobody has ever said this of 3 points";
    QCOMPARE(ui::spokenMessage(unknown), QString(unknown));
}

void WordsTest::theDesktopsLanguageIsTakenWhereThereIsIt() {
    QCOMPARE(ui::languageFor("system", {"de-AT", "en"}), QString("de"));
    QCOMPARE(ui::languageFor("system", {"fr-FR", "de_DE"}), QString("de"));
    QCOMPARE(ui::languageFor("system", {"en-GB", "de"}), QString("en"));
    QCOMPARE(ui::languageFor("system", {"C"}), QString("en"));
    QCOMPARE(ui::languageFor("de", {"en"}), QString("de"));
    QCOMPARE(ui::languageFor("en", {"de"}), QString("en"));
    QCOMPARE(ui::languageFor("not a language", {"de"}), QString("de"));
}

/// What a German window records is what an English one does.
void WordsTest::numbersAndSessionsAreTheSame() {
    std::vector<QStringList> lines;
    std::vector<base::Hash128> hashes;
    for (const bool translated : {false, true}) {
        const auto german = translated ? std::make_unique<German>() : nullptr;
        WindowFixture f;
        QStringList recorded;
        QObject::connect(&f.editor(), &ui::Editor::recorded, f.window.get(),
                         [&](const QString& line) { recorded << line; });
        QVERIFY(f.make("torus", 2000));
        auto& desk = *f.window->findChild<ui::CommandDesk*>();
        for (const char* op : {"resample", "fill", "surface"}) {
            desk.open(session::command(op));
            desk.dialog()->accept();
            QVERIFY(f.settle());
        }
        lines.push_back(recorded);
        hashes.push_back(f.hash());
    }
    QCOMPARE(lines[1], lines[0]);
    QVERIFY(hashes[1] == hashes[0]);
}

/// As people see it, while it lives.
struct Themed {
    const QPalette palette = qApp->palette();
    Themed() { ui::applyTheme(*qApp); }
    ~Themed() {
        qApp->setStyleSheet({});
        qApp->setPalette(palette);
    }
};

void WordsTest::barsHaveRoomInASmallWindow() {
    const Themed themed;
    for (const bool translated : {false, true}) {
        const auto german = translated ? std::make_unique<German>() : nullptr;
        WindowFixture f;
        f.window->resize(1240, 680); // 1280 x 720 less the desktop's frames
        QVERIFY(f.make("sphere", 500));
        QCoreApplication::processEvents();
        for (QWidget* bar : f.view().findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
            if (bar->property("floating").toBool()) {
                bar->show();
                QCoreApplication::processEvents();
                for (const QToolButton* each : bar->findChildren<QToolButton*>())
                    QVERIFY2(!each->isVisible() || each->width() >= each->sizeHint().width(), qPrintable(each->text()));
                QVERIFY2(bar->sizeHint().width() <= f.view().width() - 20,
                         qPrintable(QString("%1: %2").arg(bar->objectName()).arg(bar->sizeHint().width())));
                bar->hide();
            }
    }
}

static const test::Registered<WordsTest> registered;
#include "words_test.moc"
