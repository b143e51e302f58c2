// Icons: whatever is named has a drawing, and whatever is drawn is named.
#include "ui/theme/icon.h"

#include "core/sculpt/tool.h"
#include "core/session/command.h"
#include "support/registry.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

class IconTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFileIsInTheProgram();
    void everyToolHasItsIcon();
    void namesInTheSourcesHaveADrawing();
    void noDrawingIsOrphaned();
};

static const QString sources = POINTCLAY_SOURCES;

static QStringList drawings() {
    return QDir(":/icons").entryList({"*.svg"});
}

/// All text of the window's sources: names of icons stand there as literals.
static QString windowSources() {
    QString out;
    QDirIterator files(sources + "/ui", {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (file.open(QIODevice::ReadOnly))
            out += QString::fromUtf8(file.readAll());
    }
    return out;
}

void IconTest::everyFileIsInTheProgram() {
    QVERIFY(!ui::icon("open").isNull()); // loads the resources
    QCOMPARE(drawings(), QDir(sources + "/icons").entryList({"*.svg"}));
}

void IconTest::everyToolHasItsIcon() {
    for (const sculpt::ToolRow& row : sculpt::toolTable()) {
        QVERIFY2(!ui::icon(row.icon).isNull(), row.id);
        QVERIFY2(QFile::exists(sources + "/" + row.icon), row.id);
    }
}

/// Those that the window asks for by a literal.
static QStringList namedInSources() {
    static const QRegularExpression named(
        R"re(\bicon\("([^"]+)"\)|addEntry\([^;"]*?,\s*"([^"]+)"|icons/([^"./%]+)\.svg)re");
    const QString text = windowSources();
    QStringList out;
    for (auto match = named.globalMatch(text); match.hasNext();) {
        const QRegularExpressionMatch one = match.next();
        out << one.captured(1) + one.captured(2) + one.captured(3);
    }
    return out;
}

void IconTest::namesInTheSourcesHaveADrawing() {
    QVERIFY(namedInSources().size() > 10);
    for (const QString& name : namedInSources())
        QVERIFY2(!ui::icon(name.toStdString()).isNull(), qPrintable(name));
}

void IconTest::noDrawingIsOrphaned() {
    QStringList known = namedInSources();
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        known << QString(row.icon).section('/', -1).section('.', 0, 0);
    for (const session::CommandRow& row : session::commandTable())
        known << row.op;
    for (const QString& file : drawings())
        QVERIFY2(known.contains(file.section('.', 0, 0)), qPrintable(file));
}

static const test::Registered<IconTest> registered;
#include "icon_test.moc"
