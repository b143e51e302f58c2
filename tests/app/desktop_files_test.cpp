// Files for a desktop: they name every subcommand, option and format, and nothing else.
#include "app/desktop_files.h"

#include "app/subcommands/subcommand.h"
#include "core/io/formats.h"
#include "support/registry.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

class DesktopFilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theEntryOpensWhatMimeTypesDescribe();
    void theManualHasEverySubcommandAndFormat();
    void noLineOfTheManualIsARequestByAccident();
    void completionsAreTheSubcommands();
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

static const test::Registered<DesktopFilesTest> registered;
#include "desktop_files_test.moc"
