// The View menus' switches: each is in the picture, in the settings and in the next window.
#include "core/render/effects/effect_rows.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/window_fixture.h"

using namespace ui;

class LookMenuTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everySwitchIsKeptAndRefreshesThePicture();
    void outlinesBackgroundsAndTheGridAreInThePicture();
};

static QAction* switchOf(test::WindowFixture& f, const char* menu, const char* id) {
    for (QAction* action : f.window->menu(menu)->actions())
        if (action->data().toString() == id)
            return action;
    return nullptr;
}

void LookMenuTest::everySwitchIsKeptAndRefreshesThePicture() {
    test::WindowFixture f;
    QVERIFY(f.make("knot", 3000));
    for (const char* menu : {"effects", "around"})
        for (QAction* action : f.window->menu(menu)->actions()) {
            QVERIFY(action->isCheckable() && !action->toolTip().isEmpty());
            const Settings before = f.window->settings();
            action->toggle();
            QVERIFY2(!(f.window->settings() == before), qPrintable(action->text()));
            action->toggle();
            QVERIFY(f.window->settings() == before);
        }
    QCOMPARE(f.window->menu("effects")->actions().size(), qsizetype(render::effectTable().size()));
    QCOMPARE(f.window->menu("around")->actions().size(), qsizetype(render::annotationTable().size() + 3));
    switchOf(f, "effects", "outline")->toggle();
    switchOf(f, "around", "grid")->toggle();
    f.window->close();
    f.open();
    QVERIFY(f.window->settings().grid && f.window->settings().effects == render::Outline);
    QVERIFY(switchOf(f, "effects", "outline")->isChecked());
}

void LookMenuTest::outlinesBackgroundsAndTheGridAreInThePicture() {
    test::WindowFixture f;
    QVERIFY(f.make("knot", 3000));
    QImage last;
    const auto another = [&] {
        return QTest::qWaitFor(
            [&] {
                const QImage now = f.window->viewport().picture();
                if (now.isNull() || now == last)
                    return false;
                last = now;
                return true;
            },
            test::patience);
    };
    QVERIFY(another());
    for (const auto& [menu, id] : {std::pair("effects", "outline"), std::pair("around", "grid"),
                                   std::pair("background", "paper"), std::pair("effects", "ambient-occlusion")}) {
        QTest::qWait(200); // until the picture is at rest
        last = f.window->viewport().picture();
        switchOf(f, menu, id)->trigger();
        QVERIFY2(another(), id);
    }
}

static const test::Registered<LookMenuTest> registered;
#include "look_menu_test.moc"
