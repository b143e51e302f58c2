// The console: it shows what changed the model as sessions write it, takes such lines, and what a window did can be
// saved as a session and run again to the same bits.
#include "core/base/error.h"
#include "support/registry.h"
#include "ui/panels/console_panel.h"
#include "window_fixture.h"

#include <nlohmann/json.hpp>
#include <QLineEdit>

using nlohmann::json;
using test::WindowFixture;

class ConsoleTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void shortLinesAndJsonMeanTheSame();
    void whatIsNeitherIsRefused();
    void typedCommandsAreExecutedAndShown();
    void strokesAreShownShortened();
    void aSavedSessionRunsToTheSameBits();
};

namespace {

struct Typing : WindowFixture {
    ui::ConsolePanel& panel() { return *window->findChild<ui::ConsolePanel*>(); }
    void type(const QString& line) {
        auto& field = *panel().findChild<QLineEdit*>();
        field.setText(line);
        QTest::keyClick(&field, Qt::Key_Return);
        QVERIFY(settle());
    }
};

} // namespace

void ConsoleTest::shortLinesAndJsonMeanTheSame() {
    const json wanted = {{"op", "new"}, {"sample", "sphere"}, {"count", 3000}};
    QVERIFY(ui::commandOf("new sample=sphere count=3000") == wanted);
    QVERIFY(ui::commandOf(wanted.dump()) == wanted);
    QVERIFY(ui::commandOf("cut plane=[0,1,0,0.5] cap=true") ==
            json({{"op", "cut"}, {"plane", {0, 1, 0, 0.5}}, {"cap", true}}));
}

void ConsoleTest::whatIsNeitherIsRefused() {
    for (const char* line : {"resample 0.01", "resample =3", "{\"op\":", "", "{}", "{\"op\":5}"})
        QVERIFY_THROWS_EXCEPTION(base::Error, ui::commandOf(line));
}

void ConsoleTest::typedCommandsAreExecutedAndShown() {
    Typing f;
    f.type("new sample=sphere count=3000");
    const std::size_t before = f.surfels();
    f.type("resample count=1500");
    QVERIFY(f.surfels() < before * 3 / 4);
    QVERIFY2(f.panel().text().contains("\"op\":\"resample\""), qPrintable(f.panel().text()));
    f.type("resample cuont=1500");
    QVERIFY2(f.panel().text().contains("cuont"), qPrintable(f.panel().text()));
    QTest::keyClick(f.panel().findChild<QLineEdit*>(), Qt::Key_Up);
    QCOMPARE(f.panel().findChild<QLineEdit*>()->text(), "resample cuont=1500");
}

void ConsoleTest::strokesAreShownShortened() {
    Typing f;
    QVERIFY(f.make("sphere", 3000));
    f.drag(f.centre(), f.centre() + QPointF(60, 0));
    QVERIFY2(f.panel().text().contains("\"op\":\"stroke\""), qPrintable(f.panel().text()));
    for (const QString& line : f.panel().text().split('\n'))
        QVERIFY(line.size() <= 410);
}

void ConsoleTest::aSavedSessionRunsToTheSameBits() {
    Typing f;
    QVERIFY(f.make("sphere", 3000));
    f.drag(f.centre(), f.centre() + QPointF(60, 0));
    f.type("resample count=2500");
    const auto hash = f.editor().hashWhenDone();
    const std::filesystem::path session = f.file("did.jsonl").toStdString();
    f.editor().saveSession(session);
    QVERIFY(f.settle());
    f.open();
    f.window->files().runSession(session);
    QVERIFY(f.settle());
    QVERIFY(f.editor().hashWhenDone() == hash);
}

static const test::Registered<ConsoleTest> registered;
#include "console_test.moc"
