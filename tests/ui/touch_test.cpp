// Feeling the model in the window: a simulated hand and the mouse get forces, sculpt where they may, and end at Esc.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/force_plot.h"
#include "ui/panels/touch_bar.h"
#include "window_fixture.h"

#include <fstream>
#include <QCheckBox>
#include <QComboBox>
#include <sstream>

using test::WindowFixture;

class TouchWindowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theSimulatedHandFeelsTheModel();
    void pressingMakesStrokesLikeAnyOther();
    void theMousePressesIn();
    void whatIsNotThereIsWaitedFor();
};

namespace {

struct Fixture : WindowFixture {
    ui::TouchInput& touch() { return window->sculptView().touch(); }
    QCheckBox& on() { return *window->findChild<QCheckBox*>("touch-on"); }
    void choose(const char* device) {
        auto* list = window->findChild<QComboBox*>("touch-device");
        list->setCurrentIndex(list->findData(device));
    }
    bool waitUntil(const std::function<bool(const ui::TouchLook&)>& true_) {
        return QTest::qWaitFor([&] { return true_(touch().look()); }, test::patience);
    }
    ~Fixture() { window.reset(); }
};

} // namespace

void TouchWindowTest::theSimulatedHandFeelsTheModel() {
    Fixture f;
    QVERIFY(f.make("sphere", 8000));
    const base::Hash128 before = f.hash();
    auto* bar = f.window->findChild<ui::TouchBar*>();
    QVERIFY(bar->isHidden());
    f.action("view", "Touch")->trigger();
    QVERIFY(bar->isVisible() && !f.touch().on());
    f.on().setChecked(true);
    QVERIFY(f.touch().on());
    QVERIFY(f.waitUntil([](const ui::TouchLook& look) { return look.contact && length(look.force) > 0.5; }));
    const ui::TouchLook look = f.touch().look();
    QVERIFY2(std::abs(length(look.proxy) - 1 - look.radius) < 0.01, qPrintable(QString::number(length(look.proxy))));
    QVERIFY(dot(look.force, look.proxy) > 0 && !look.works);
    QVERIFY(f.window->findChild<ui::ForcePlot*>()->count() > 0);
    QTest::keyClick(f.window.get(), Qt::Key_Escape);
    f.window->escape(); // whichever way Esc comes
    QVERIFY(!f.touch().on() && !f.on().isChecked() && !f.touch().look().shown);
    QCOMPARE(f.hash(), before);
}

void TouchWindowTest::pressingMakesStrokesLikeAnyOther() {
    Fixture f;
    QVERIFY(f.make("sphere", 8000));
    const base::Hash128 before = f.hash();
    ui::TouchSettings settings;
    settings.on = settings.sculpts = true;
    f.touch().set(settings);
    QVERIFY(f.waitUntil([](const ui::TouchLook& look) { return look.works; }));
    QVERIFY(QTest::qWaitFor([&] { return f.editor().snapshot().input > 0 || f.editor().snapshot().dabSeconds > 0; },
                            test::patience));
    settings.on = false;
    f.touch().set(settings);
    QVERIFY(f.settle());
    QVERIFY(f.hash() != before);
    std::ifstream in(f.journal());
    std::stringstream journal;
    journal << in.rdbuf();
    QVERIFY(journal.str().find("\"op\":\"stroke\"") != std::string::npos);
    while (f.editor().snapshot().canUndo) {
        f.editor().run({{"op", "undo"}});
        QVERIFY(f.settle());
    }
    QCOMPARE(f.hash(), before);
}

void TouchWindowTest::theMousePressesIn() {
    Fixture f;
    QVERIFY(f.make("sphere", 8000));
    f.choose("mouse");
    f.on().setChecked(true);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    QVERIFY(f.waitUntil([](const ui::TouchLook& look) { return look.shown && !look.contact; }));
    test::sendMouse(f.view(), QEvent::MouseButtonPress, f.centre(), Qt::LeftButton);
    QVERIFY(f.waitUntil([](const ui::TouchLook& look) { return look.contact && length(look.force) > 1; }));
    QVERIFY(length(f.touch().look().tool) < length(f.touch().look().proxy));
    test::sendMouse(f.view(), QEvent::MouseButtonRelease, f.centre(), Qt::LeftButton);
    QVERIFY(f.waitUntil([](const ui::TouchLook& look) { return look.shown && !look.contact; }));
    QVERIFY(!f.editor().snapshot().canUndo); // no stroke of the mouse's own
    f.on().setChecked(false);
    f.drag(f.centre() - QPointF(60, 0), f.centre() + QPointF(60, 0));
    QVERIFY(f.editor().snapshot().canUndo); // it sculpts again
}

void TouchWindowTest::whatIsNotThereIsWaitedFor() {
    Fixture f;
    QVERIFY(f.make("sphere", 2000));
    f.choose("inverse3");
    f.on().setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(f.touch().on() && f.touch().state().contains("waiting"), test::patience);
    f.choose("hand"); // and another takes its place
    QVERIFY(f.waitUntil([](const ui::TouchLook& look) { return look.shown; }));
}

static const test::Registered<TouchWindowTest> registered;
#include "touch_test.moc"
