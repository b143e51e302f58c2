// What commands tell: all of it, in the line at the bottom and behind its button; and what a dialog proposes.
#include "core/base/error.h"
#include "support/registry.h"
#include "ui/window/command_dialog.h"
#include "ui/window/status_line.h"
#include "ui/window_fixture.h"

#include <fstream>
#include <QLineEdit>
#include <QToolButton>

using test::WindowFixture;

class MessagesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void openingTellsAllThatItFound();
    void manyAreSummedUp();
    void reduceProposesAPart();
    void severalChoicesAreAList();
};

static ui::StatusLine& statusOf(WindowFixture& f) {
    return *f.window->findChild<ui::StatusLine*>();
}

/// Two sentences: of commas, and of columns.
void MessagesTest::openingTellsAllThatItFound() {
    WindowFixture f;
    std::ofstream out(f.file("a.csv").toStdString());
    out << "East;North;Height\n";
    for (int i = 0; i < 400; ++i)
        out << i % 20 << ",5;" << i / 20 << ",25;" << (i % 7) << ",125\n";
    out.close();
    f.window->files().open(f.file("a.csv").toStdString());
    QVERIFY(f.settle());
    const QStringList told = statusOf(f).allTold().split('\n');
    QVERIFY2(told.size() >= 2 && told[0].contains("decimal commas") && told[1].contains("were taken for x, y and z"),
             qPrintable(told.join(" | ")));
    QVERIFY(statusOf(f).message().contains(told[0]) && statusOf(f).message().contains(told[1]));
    statusOf(f).tell("one");
    QCOMPARE(statusOf(f).allTold(), QString("One."));
}

void MessagesTest::manyAreSummedUp() {
    ui::StatusLine line;
    line.tell("first\nsecond\nthird\nfourth\nfifth");
    QCOMPARE(line.message(), QString("Fifth."));
    QCOMPARE(line.allTold(), QString("First.\nSecond.\nThird.\nFourth.\nFifth."));
    line.tell("first\nsecond");
    QCOMPARE(line.message(), QString("First. Second."));
}

void MessagesTest::reduceProposesAPart() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    ui::CommandDialog dialog(session::command("reduce"), f.editor().snapshot());
    QVERIFY(dialog.command()["ratio"] == 0.1);
    QTest::keyClicks(dialog.findChild<QLineEdit*>("count"), "500");
    const nlohmann::json command = dialog.command();
    QVERIFY(command["count"] == 500 && !command.contains("ratio"));
}

void MessagesTest::severalChoicesAreAList() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    const ui::CommandDialog dialog(session::command("shapes"), f.editor().snapshot());
    QVERIFY(dialog.command()["kinds"].dump() == R"(["plane","sphere","cylinder"])");
}

static const test::Registered<MessagesTest> registered;
#include "messages_test.moc"
