// Files for a desktop: they name every subcommand, option and format, and nothing else.
#include "app/desktop/desktop_files.h"

#include "app/desktop/manual.h"
#include "app/desktop/markup.h"
#include "app/subcommands/subcommand.h"
#include "core/io/formats.h"
#include "core/sculpt/tool.h"
#include "core/session/command.h"
#include "support/registry.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

class DesktopFilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theEntryOpensWhatMimeTypesDescribe();
    void typesThatTheDesktopKnowsKeepTheirNames();
    void theManualHasEverySubcommandAndFormat();
    void noLineOfTheManualIsARequestByAccident();
    void completionsAreTheSubcommands();
    void thePageOfTheSoftwareCentreOpensTheSameTypes();
    void theManualHasARowForEveryRow();
    void theManualNamesThePicturesThatAreMadeForIt();
};

void DesktopFilesTest::theEntryOpensWhatMimeTypesDescribe() {
    const QString entry = QString::fromStdString(app::desktopEntry());
    QVERIFY(entry.startsWith("[Desktop Entry]\n") && entry.contains("Exec=pointclay %F"));
    QStringList opened;
    for (const QString& line : entry.split('\n'))
        if (line.startsWith("MimeType="))
            opened = line.mid(9).split(';', Qt::SkipEmptyParts);
    QXmlStreamReader xml(QString::fromStdString(app::mimeTypes()));
    QStringList described, patterns;
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == u"mime-type")
            described << xml.attributes().value("type").toString();
        if (xml.isStartElement() && xml.name() == u"glob")
            patterns << xml.attributes().value("pattern").toString();
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(described, opened);
    QVERIFY(patterns.contains("*.ply") && patterns.contains("*.xyz") && !patterns.contains("*.txt"));
    QCOMPARE(QSet<QString>(patterns.begin(), patterns.end()).size(), patterns.size());
}

/// Of shared-mime-info: beside a second name for it a file of that kind would still be the first.
void DesktopFilesTest::typesThatTheDesktopKnowsKeepTheirNames() {
    const QString types = QString::fromStdString(app::mimeTypes());
    for (const auto& [type, pattern] : {std::pair{"model/gltf-binary", "*.glb"},
                                        {"model/gltf+json", "*.gltf"},
                                        {"model/3mf", "*.3mf"},
                                        {"model/obj", "*.obj"},
                                        {"model/stl", "*.stl"}}) {
        const QString own = types.section(QString("\"%1\"").arg(type), 1).section("</mime-type>", 0, 0);
        QVERIFY2(own.contains(QString("\"%1\"").arg(pattern)), type);
    }
}

void DesktopFilesTest::theManualHasEverySubcommandAndFormat() {
    const QString manual = QString::fromStdString(app::manPage());
    for (const app::SubcommandRow& row : app::subcommandTable())
        QVERIFY2(manual.contains(QString(".SS %1\n").arg(row.name)), row.name);
    for (const io::FormatRow& row : io::formatTable())
        QVERIFY2(manual.contains(QString(row.label).replace('-', "\\-")), row.label);
    QVERIFY(manual.contains("\\-\\-threads"));
}

void DesktopFilesTest::noLineOfTheManualIsARequestByAccident() {
    static const QRegularExpression known(R"(^\.(TH|SH|SS|TP|PP|B|br)( |$))");
    for (const QString& line : QString::fromStdString(app::manPage()).split('\n'))
        if (line.startsWith('.') || line.startsWith('\''))
            QVERIFY2(known.match(line).hasMatch(), qPrintable(line));
}

void DesktopFilesTest::completionsAreTheSubcommands() {
    const QString script = QString::fromStdString(app::bashCompletions());
    for (const app::SubcommandRow& row : app::subcommandTable())
        QVERIFY2(script.contains(QString("        %1) words=\"--").arg(row.name)), row.name);
}

void DesktopFilesTest::thePageOfTheSoftwareCentreOpensTheSameTypes() {
    const QString entry = QString::fromStdString(app::desktopEntry());
    QXmlStreamReader xml(QString::fromStdString(app::softwarePage()));
    int types = 0;
    while (!xml.atEnd())
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"mediatype") {
            const QString type = xml.readElementText();
            QVERIFY2(entry.contains(type + ";"), qPrintable(type));
            QVERIFY2(QString::fromStdString(app::thumbnailer()).contains(type + ";"), qPrintable(type));
            ++types;
        }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(types, int(entry.count("model/")));
}

void DesktopFilesTest::theManualHasARowForEveryRow() {
    std::string page;
    for (const app::ManualPage& each : app::manual(false))
        page += each.text;
    const auto has = [&](const std::string& text) { return page.find(text) != std::string::npos; };
    for (const sculpt::ToolRow& tool : sculpt::toolTable())
        QVERIFY2(has("<h3>" + app::escapedMarkup(tool.label) + "</h3>") && has(app::escapedMarkup(tool.tip)), tool.id);
    for (const session::CommandRow& each : session::commandTable())
        QVERIFY2(has(std::string("<h3><code>") + each.op + "</code></h3>"), each.op);
    for (const app::SubcommandRow& each : app::subcommandTable())
        QVERIFY2(has(std::string("<h3><code>pointclay ") + each.name + "</code></h3>"), each.name);
    for (const io::FormatRow& each : io::formatTable())
        QVERIFY2(has(app::escapedMarkup(each.label)), each.label);
    QVERIFY(!has("<img"));
}

void DesktopFilesTest::theManualNamesThePicturesThatAreMadeForIt() {
    QString page;
    for (const app::ManualPage& each : app::manual(true))
        page += QString::fromStdString(each.text);
    const auto pictures = app::manualPictures();
    QVERIFY(!pictures.empty());
    for (const app::ManualPicture& each : pictures)
        QVERIFY2(page.contains(QString("src=\"%1\"").arg(QString::fromStdString(each.file))), each.file.c_str());
    QCOMPARE(page.count("<img "), int(pictures.size()));
}

static const test::Registered<DesktopFilesTest> registered;
#include "desktop_files_test.moc"
