// The list of steps: it says what the document's history is, and a click goes there.
#include "support/registry.h"
#include "ui/panels/history_panel.h"
#include "window_fixture.h"

#include <QComboBox>
#include <QListWidget>

using test::WindowFixture;

class HistoryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aClickOnAStepGoesThere();
    void aNewStepDropsThoseAhead();
    void theBudgetIsKept();
};

namespace {

struct Steps : WindowFixture {
    Steps() {
        run({{"op", "new"}, {"sample", "sphere"}, {"count", 3000}});
        for (const char* axis : {"z", "x", "-y"})
            run({{"op", "up"}, {"axis", axis}});
    }
    void run(nlohmann::json command) {
        editor().run(std::move(command));
        QVERIFY(settle());
    }
    ui::HistoryPanel& panel() { return *window->findChild<ui::HistoryPanel*>(); }
    QListWidget& list() { return *panel().findChild<QListWidget*>(); }
};

} // namespace

void HistoryTest::aClickOnAStepGoesThere() {
    Steps steps;
    QCOMPARE(steps.list().count(), 4);
    QCOMPARE(steps.panel().present(), 3);
    const auto up = [&] { return base::upRow(steps.editor().snapshot().up).id; };
    steps.list().setCurrentRow(1);
    QVERIFY(steps.settle());
    QCOMPARE(up(), "z");
    QCOMPARE(steps.panel().present(), 1);
    QCOMPARE(steps.list().count(), 4);
    steps.list().setCurrentRow(3);
    QVERIFY(steps.settle());
    QCOMPARE(up(), "-y");
    steps.list().setCurrentRow(0);
    QVERIFY(steps.settle());
    QCOMPARE(up(), "y");
    QVERIFY(!steps.editor().snapshot().canUndo);
}

void HistoryTest::aNewStepDropsThoseAhead() {
    Steps steps;
    steps.list().setCurrentRow(1);
    QVERIFY(steps.settle());
    steps.run({{"op", "up"}, {"axis", "-x"}});
    QCOMPARE(steps.list().count(), 3);
    QCOMPARE(steps.panel().present(), 2);
}

void HistoryTest::theBudgetIsKept() {
    constexpr std::size_t most = std::size_t(64) << 20;
    Steps steps;
    steps.run({{"op", "new"}, {"sample", "sphere"}, {"count", 100000}});
    const auto held = [&] { return steps.editor().snapshot().historyBytes; };
    for (int red = 0; red < 100 && held() <= most; ++red)
        steps.run({{"op", "colour"}, {"colour", {red, 0, 0}}});
    QVERIFY(held() > most);
    const int before = steps.list().count();
    auto& budget = *steps.panel().findChild<QComboBox*>();
    budget.setCurrentIndex(budget.findData(64));
    QVERIFY(steps.settle());
    QCOMPARE(steps.window->settings().historyMib, 64);
    QVERIFY(held() <= most && held() > most / 2);
    QVERIFY(steps.list().count() < before && steps.list().count() > before / 2); // the oldest go, and no more than must
}

static const test::Registered<HistoryTest> registered;
#include "history_test.moc"
