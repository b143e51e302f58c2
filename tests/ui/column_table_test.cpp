// What a text's columns are, chosen above its first lines; and what the window asks where a file does not tell.
#include "core/base/random.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/window/column_table.h"
#include "ui/window/command_dialog.h"
#include "ui/window/file_actions.h"
#include "ui/window_fixture.h"

#include <fstream>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>

using test::WindowFixture;

class ColumnTableTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void listsShowWhatOpeningWouldTake();
    void twoColumnsExchangeWhatTheyAre();
    void whatDoesNotFitIsSaidAndMended();
    void textsThatDoNotTellAreAskedAbout();
    void filesThatTellOpenAtOnce();
    void fieldsAreNeverCut();
};

/// A ball whose columns are a number, z, y, x; the number does not count the rows, or nobody would take it for x.
static std::string ball(const char* names) {
    base::Random random(test::seed());
    std::ostringstream out;
    out << names;
    for (int i = 0; i < 900; ++i) {
        const base::Vec3d p = random.unitVector();
        out << 641 * i % 900 << ' ' << 3 * p.z << ' ' << 2 * p.y << ' ' << p.x << '\n';
    }
    return out.str();
}

static QString written(const WindowFixture& f, const char* name, const std::string& text) {
    std::ofstream(f.file(name).toStdString()) << text;
    return f.file(name);
}

static QComboBox& list(QWidget& parent, int column) {
    return *parent.findChild<QComboBox*>(QString("column%1").arg(column));
}

static void choose(QComboBox& list, const char* role) {
    list.setCurrentIndex(list.findData(role));
}

void ColumnTableTest::listsShowWhatOpeningWouldTake() {
    const WindowFixture f;
    ui::ColumnTable table;
    table.showFile(written(f, "a.xyz", "1 2 3 10 20 30\n4 5 6 10 20 30\n"), {});
    QVERIFY(!table.isHidden());
    const char* const expected[] = {"x", "y", "z", "red", "green", "blue"};
    for (int c = 0; c < 6; ++c)
        QCOMPARE(list(table, c).currentData().toString(), QString(expected[c]));
    QCOMPARE(table.findChild<QTableWidget*>()->item(2, 1)->text(), QString("5"));
    table.showFile(written(f, "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), {});
    QVERIFY(table.isHidden());
    table.showFile({}, {});
    QVERIFY(table.isHidden());
}

void ColumnTableTest::twoColumnsExchangeWhatTheyAre() {
    const WindowFixture f;
    ui::ColumnTable table;
    QString said;
    connect(&table, &ui::ColumnTable::chosen, &table, [&](const QString& columns) { said = columns; });
    table.showFile(written(f, "a.xyz", ball("")), {});
    QCOMPARE(table.columns(), QString("x,y,z,intensity"));
    choose(list(table, 3), "x");
    QCOMPARE(said, QString("intensity,y,z,x"));
    choose(list(table, 1), "z");
    QCOMPARE(said, QString("intensity,z,y,x"));
    choose(list(table, 0), "-");
    QCOMPARE(said, QString("-,z,y,x"));
    table.showFile(f.file("a.xyz"), said);
    QCOMPARE(table.columns(), said);
}

void ColumnTableTest::whatDoesNotFitIsSaidAndMended() {
    const WindowFixture f;
    ui::ColumnTable table;
    auto& said = *table.findChild<QLabel*>("columnsSaid");
    table.showFile(written(f, "a.xyz", ball("")), {});
    choose(list(table, 0), "-");
    QVERIFY2(said.text().contains("no column is called x"), qPrintable(said.text()));
    QVERIFY(!table.isHidden());
    choose(list(table, 3), "x");
    QVERIFY2(said.text().startsWith("The first points span"), qPrintable(said.text()));
    table.showFile(f.file("a.xyz"), "x,y,z"); // typed
    QVERIFY2(said.text().contains("4 columns") && !table.isHidden(), qPrintable(said.text()));
}

/// By what is chosen there the file opens.
void ColumnTableTest::textsThatDoNotTellAreAskedAbout() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 500));
    f.window->files().open(written(f, "odd.txt", ball("a b c d\n")).toStdString());
    auto* dialog = f.window->findChild<ui::CommandDialog*>();
    QVERIFY(dialog);
    QCOMPARE(dialog->findChild<QLineEdit*>("path")->text(), f.file("odd.txt"));
    choose(list(*dialog, 3), "x");
    choose(list(*dialog, 1), "z");
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    QVERIFY(f.settle());
    QCOMPARE(f.surfels(), std::size_t(900));
    const base::Box3f box = f.editor().snapshot().surface.tree().bounds();
    const base::Vec3f size = box.hi - box.lo;
    QVERIFY(size.z > 5.5f && size.y > 3.6f && size.y < 4.1f && size.x < 2.1f);
}

void ColumnTableTest::filesThatTellOpenAtOnce() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 500));
    f.window->files().open(written(f, "named.txt", ball("id height north east\n")).toStdString());
    QVERIFY(!f.window->findChild<ui::CommandDialog*>());
    QVERIFY(f.settle());
    QCOMPARE(f.surfels(), std::size_t(900));
    QCOMPARE(f.editor().snapshot().up, base::UpAxis::Z);
}

/// Beside the table, too, which comes once there is a file.
void ColumnTableTest::fieldsAreNeverCut() {
    WindowFixture f;
    f.window->files().openWith();
    auto* dialog = f.window->findChild<ui::CommandDialog*>();
    QVERIFY(dialog);
    dialog->enter("path", written(f, "odd.txt", ball("a b c d\n")));
    QApplication::processEvents();
    auto* fields = dialog->findChild<QScrollArea*>();
    QTRY_VERIFY_WITH_TIMEOUT(fields->viewport()->width() >= fields->widget()->minimumSizeHint().width(),
                             test::patience);
    dialog->reject();
}

static const test::Registered<ColumnTableTest> registered;
#include "column_table_test.moc"
