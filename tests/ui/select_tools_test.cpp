// Selecting with the pointer: what is drawn or clicked becomes the command that a session would hold.
#include "ui/window/select_tools.h"

#include "core/selection/field.h"
#include "support/patience.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "ui/interaction/select_ways.h"
#include "ui/panels/select_bar.h"
#include "ui/panels/tool_bar.h"
#include "ui/window_fixture.h"
#include "ui/work/measurer.h"

#include <QKeyEvent>
#include <QToolButton>

#include <functional>
#include <utility>

using test::WindowFixture;

class SelectToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aBoxSelectsWhatLiesBehindIt();
    void visibleOnlyLeavesTheBack();
    void keysHeldAddAndSubtract();
    void everyWaySelectsSomething_data();
    void everyWaySelectsSomething();
    void aPolygonIsClosedByEnterAndTakenBackByBackspace();
    void escGoesBackToSculpting();
    void otherButtonsMoveTheView();
    void selectedIsOrangeInEveryShading_data();
    void selectedIsOrangeInEveryShading();
    void aToolTakesThePointerBack();
    void menusHoldWhatTheBarHolds();
    void buttonsChangeWhatIsSelected();
    void framingTakesWhatIsSelected();
    void keysHideAndShowParts();
    void whoAsksForTheBarSelects();
};

namespace {

/// A ball with the bar shown and no way chosen yet.
struct Bar {
    WindowFixture f;
    bool ready = f.make("sphere", 4000);
    ui::SelectBar& bar = *f.window->findChild<ui::SelectBar*>();

    Bar() {
        bar.toggleViewAction()->trigger();
        f.window->escape();
    }
    QToolButton& button(const char* name) { return *bar.findChild<QToolButton*>(QString("select-") + name); }
    void click(const char* name) {
        button(name).click();
        f.settle();
    }
    const tree::SurfelTree& model() { return f.editor().snapshot().surface.tree(); }
    std::size_t selected() {
        f.settle();
        return sizeOf(selection::selectedIn(model()));
    }
    QPointF at(double x, double y) { return {x * f.view().width(), y * f.view().height()}; }
    void tap(const QPointF& place, Qt::KeyboardModifiers modifiers = {}) {
        f.press(place, modifiers);
        f.release(place, modifiers);
    }
};

/// Surfels whose places pass a test, among the model's.
template <class Test>
std::size_t counted(const tree::SurfelTree& model, const Test& test) {
    std::size_t out = 0;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            out += test(block.position(slot)) ? 1 : 0;
    });
    return out;
}

} // namespace

void SelectToolsTest::aBoxSelectsWhatLiesBehindIt() {
    Bar t;
    QVERIFY(t.ready);
    t.click("rectangle");
    const QPointF from = t.at(0.3, 0.2), to = t.at(0.5, 0.7);
    t.f.drag(from, to);
    const render::Camera camera = t.f.window->sculptView().motion().camera();
    const double scale = t.f.view().devicePixelRatioF();
    const std::size_t wanted = counted(t.model(), [&](const base::Vec3f& x) {
        const base::Vec3d seen = camera.project(base::cast<double>(x));
        return seen.x > from.x() * scale && seen.x < to.x() * scale && seen.y > from.y() * scale &&
               seen.y < to.y() * scale;
    });
    QVERIFY(wanted > 100);
    QCOMPARE(t.selected(), wanted);
    QCOMPARE(t.f.editor().snapshot().undoLabel, std::string("Select")); // no stroke
}

void SelectToolsTest::visibleOnlyLeavesTheBack() {
    Bar t;
    t.click("rectangle");
    t.f.drag(t.at(0.05, 0.05), t.at(0.95, 0.95));
    QCOMPARE(t.selected(), t.model().size());
    t.click("visible");
    t.f.drag(t.at(0.05, 0.05), t.at(0.95, 0.95));
    QVERIFY(t.selected() > t.model().size() / 4 && t.selected() < t.model().size() * 6 / 10);
}

void SelectToolsTest::keysHeldAddAndSubtract() {
    Bar t;
    t.click("rectangle");
    t.f.drag(t.at(0.05, 0.05), t.at(0.5, 0.95));
    const std::size_t left = t.selected();
    t.f.drag(t.at(0.5, 0.05), t.at(0.95, 0.95), Qt::ShiftModifier);
    QVERIFY(t.selected() > left + left / 2);
    t.f.drag(t.at(0.5, 0.05), t.at(0.95, 0.95), Qt::ControlModifier);
    QVERIFY(t.selected() <= left && t.selected() + 20 >= left); // what lies on the line itself
}

void SelectToolsTest::everyWaySelectsSomething_data() {
    QTest::addColumn<int>("way");
    for (std::size_t i = 0; i < ui::selectWays().size(); ++i)
        QTest::addRow("%s", ui::selectWays()[i].id) << int(i);
}

void SelectToolsTest::everyWaySelectsSomething() {
    QFETCH(int, way);
    const ui::SelectWay& row = ui::selectWays()[static_cast<std::size_t>(way)];
    Bar t;
    t.click(row.id);
    QCOMPARE(t.bar.way(), way);
    if (row.shape == ui::PickShape::Place) {
        t.tap(t.at(0.5, 0.5));
    } else if (row.shape == ui::PickShape::Polygon) {
        for (const QPointF& corner : {t.at(0.4, 0.4), t.at(0.6, 0.4), t.at(0.5, 0.6)})
            t.tap(corner);
        QTest::keyClick(&t.f.view(), Qt::Key_Return);
    } else {
        t.f.press(t.at(0.4, 0.4));
        for (const QPointF& corner : {t.at(0.6, 0.4), t.at(0.6, 0.6), t.at(0.45, 0.6)})
            t.f.moveTo(corner);
        t.f.release(t.at(0.45, 0.6));
    }
    QVERIFY(t.selected() > 0);
    QCOMPARE(t.f.editor().snapshot().undoLabel, std::string("Select"));
}

void SelectToolsTest::aPolygonIsClosedByEnterAndTakenBackByBackspace() {
    Bar t;
    t.click("polygon");
    const ui::Picker& picker = t.f.window->sculptView().picker();
    for (const QPointF& corner : {t.at(0.4, 0.4), t.at(0.6, 0.4), t.at(0.9, 0.9)})
        t.tap(corner);
    QCOMPARE(picker.outline().size(), std::size_t(4)); // with the pointer
    QTest::keyClick(&t.f.view(), Qt::Key_Backspace);
    QCOMPARE(picker.outline().size(), std::size_t(3));
    QTest::keyClick(&t.f.view(), Qt::Key_Return); // a line encloses nothing
    QVERIFY(picker.outline().empty());
    QCOMPARE(t.selected(), std::size_t(0));
    for (const QPointF& corner : {t.at(0.4, 0.4), t.at(0.6, 0.4), t.at(0.5, 0.6), t.at(0.4, 0.4)})
        t.tap(corner); // the first corner again
    QVERIFY(picker.outline().empty());
    QVERIFY(t.selected() > 0);
}

void SelectToolsTest::escGoesBackToSculpting() {
    Bar t;
    t.click("lasso");
    t.f.press(t.at(0.4, 0.4));
    t.f.moveTo(t.at(0.6, 0.4));
    t.f.window->escape(); // the outline
    QVERIFY(t.f.window->sculptView().picker().on());
    t.f.release(t.at(0.6, 0.4));
    QCOMPARE(t.selected(), std::size_t(0));
    t.f.window->escape(); // the way
    QVERIFY(!t.f.window->sculptView().picker().on());
    QCOMPARE(t.bar.way(), -1);
    t.f.drag(t.at(0.45, 0.5), t.at(0.55, 0.5));
    QCOMPARE(t.f.editor().snapshot().undoLabel, std::string(t.f.window->settings().toolRow().label));
}

void SelectToolsTest::otherButtonsMoveTheView() {
    Bar t;
    t.click("rectangle");
    const base::Vec3d eye = t.f.window->sculptView().motion().camera().eye;
    t.f.drag(t.at(0.4, 0.4), t.at(0.6, 0.5), {}, Qt::RightButton);
    QVERIFY(distance(t.f.window->sculptView().motion().camera().eye, eye) > 0);
    QVERIFY(t.f.window->sculptView().picker().on());
    QCOMPARE(t.selected(), std::size_t(0));
}

void SelectToolsTest::selectedIsOrangeInEveryShading_data() {
    QTest::addColumn<int>("shading");
    QTest::addColumn<bool>("rays");
    for (const render::ShadingRow& row : render::shadingTable())
        if (!test::sanitized || row.shading == render::Shading::Matcap || row.shading == render::Shading::Colour)
            QTest::addRow("%s", row.id) << int(row.shading) << false; // seconds each
    QTest::addRow("matcap by rays") << int(render::Shading::Matcap) << true;
    QTest::addRow("colour by rays") << int(render::Shading::Colour) << true;
}

/// Selecting moves the middle of the picture towards orange, deselecting brings the same pixels back.
void SelectToolsTest::selectedIsOrangeInEveryShading() {
    QFETCH(int, shading);
    QFETCH(bool, rays);
    Bar t;
    t.f.window->showShading(static_cast<render::Shading>(shading));
    t.f.action("view", "True Surface")->setChecked(rays);
    const auto look = [&] {
        t.f.settle();
        if (!QTest::qWaitFor([&] { return !t.f.window->measurer().busy(); }, test::patience))
            qWarning("measuring goes on");
        QTest::qWait(rays ? 900 : 350); // until it rests
        const QImage seen = t.f.view().grab().toImage();
        double red = 0, blue = 0;
        for (int y = -9; y <= 9; ++y)
            for (int x = -9; x <= 9; ++x) {
                const QColor each = seen.pixelColor(seen.width() / 2 + x, seen.height() / 3 + y);
                red += each.redF(), blue += each.blueF();
            }
        return (red - blue) / 361;
    };
    // Pictures are made in the background, where there is no saying when one is the last: what is seen counts once it
    // is as it must be, or stays otherwise.
    const auto lookFor = [&](const std::function<bool(double)>& wanted) {
        double seen = look();
        for (int k = 0; k < 20 && !wanted(seen); ++k)
            seen = look();
        return seen;
    };
    double last = look();
    double before = lookFor([&](double seen) { return std::abs(seen - std::exchange(last, seen)) < 1e-3; });
    QString told;
    bool back = false;
    for (int round = 0; round < 3 && !back; ++round) { // again where the first picture was not the last
        t.click("all");
        const double selected = lookFor([&](double seen) { return seen > before + 0.15 && seen > 0.2; });
        t.click("none");
        const double after = lookFor([&](double seen) { return std::abs(seen - before) < 0.01; });
        back = selected > before + 0.15 && selected > 0.2 && std::abs(after - before) < 0.01;
        told += QString(" %1, selected %2, then %3;").arg(before).arg(selected).arg(after);
        before = after;
    }
    QVERIFY2(back, qPrintable(told));
}

void SelectToolsTest::aToolTakesThePointerBack() {
    Bar t;
    t.click("lasso");
    QVERIFY(t.f.window->sculptView().picker().on());
    Q_EMIT t.f.window->findChild<ui::ToolBar*>()->chosen();
    QVERIFY(!t.f.window->sculptView().picker().on());
    QCOMPARE(t.bar.way(), -1);
}

void SelectToolsTest::menusHoldWhatTheBarHolds() {
    Bar t;
    t.bar.toggleViewAction()->trigger();
    QVERIFY(t.bar.isHidden());
    QAction* lasso = t.f.action("select", "Lasso");
    QVERIFY(lasso);
    lasso->trigger();
    QVERIFY(!t.bar.isHidden() && t.bar.way() == 1 && t.f.window->sculptView().picker().on());
    t.f.action("select", "All")->trigger();
    QCOMPARE(t.selected(), t.model().size());
}

void SelectToolsTest::buttonsChangeWhatIsSelected() {
    Bar t;
    const std::size_t all = t.model().size();
    t.click("all");
    QCOMPARE(t.selected(), all);
    t.click("none");
    QCOMPARE(t.selected(), std::size_t(0));
    t.click("ball");
    t.tap(t.at(0.5, 0.5));
    const std::size_t some = t.selected();
    t.click("grow");
    const std::size_t more = t.selected();
    QVERIFY(more > some);
    t.click("shrink");
    QVERIFY(t.selected() < more);
    t.click("invert");
    const std::size_t rest = t.selected();
    QVERIFY(rest > all / 2 && rest < all);
    t.click("delete");
    QCOMPARE(t.model().size(), all - rest);
}

void SelectToolsTest::framingTakesWhatIsSelected() {
    Bar t;
    t.click("ball");
    t.tap(t.at(0.5, 0.5));
    QVERIFY(t.selected() > 0);
    const double before = t.f.window->sculptView().motion().view().heightAtTarget();
    t.f.window->sculptView().frameSelection();
    QVERIFY(t.f.window->sculptView().motion().view().heightAtTarget() < 0.7 * before);
}

/// What is hidden is not in the picture, and no stroke meets it.
/// A drag after B sculpted, until a way was chosen as well. Del takes out what it selected.
void SelectToolsTest::whoAsksForTheBarSelects() {
    Bar t;
    t.bar.toggleViewAction()->trigger();
    t.bar.toggleViewAction()->trigger();
    t.f.drag(t.at(0.5, 0), t.at(1, 1));
    const std::size_t chosen = t.selected();
    QVERIFY(chosen > 1000 && chosen < 3000);
    auto* action = t.f.window->findChild<QAction*>("select-delete");
    QVERIFY(action && action->shortcut() == QKeySequence("Del"));
    action->trigger();
    t.f.settle();
    QCOMPARE(t.model().size(), 4000 - chosen);
    t.click("lasso");
    t.bar.toggleViewAction()->trigger();
    QVERIFY(t.bar.way() < 0);
    t.bar.toggleViewAction()->trigger(); // begins with the lasso now
    QCOMPARE(ui::selectWays()[static_cast<std::size_t>(t.bar.way())].id, std::string_view("lasso"));
}

void SelectToolsTest::keysHideAndShowParts() {
    Bar t;
    const auto key = [&](const char* name, const char* keys) {
        auto* action = t.f.window->findChild<QAction*>(QString("select-") + name);
        const bool known = action && action->shortcut() == QKeySequence(keys);
        if (known)
            action->trigger();
        t.f.settle();
        return known;
    };
    t.click("rectangle");
    t.f.drag(t.at(0.5, 0), t.at(1, 1));
    const std::size_t chosen = t.selected();
    QVERIFY(chosen > 1000 && chosen < 3000);
    t.f.window->escape();
    QVERIFY(key("hide", "H"));
    QCOMPARE(t.model().size(), 4000 - chosen);
    QCOMPARE(t.f.editor().snapshot().whole.size(), 4000 - chosen);
    QCOMPARE(t.f.editor().snapshot().surfels, std::size_t(4000));
    t.f.drag(t.at(0.4, 0.5), t.at(0.45, 0.55)); // beside it
    QCOMPARE(t.f.editor().snapshot().undoLabel, std::string(t.f.window->settings().toolRow().label));
    QVERIFY(key("show", "Alt+H"));
    QVERIFY(t.model().size() >= 4000);
    t.click("rectangle");
    t.f.drag(t.at(0.5, 0), t.at(1, 1));
    t.f.window->escape();
    QVERIFY(key("hide-rest", "Shift+H"));
    QCOMPARE(t.model().size(), t.selected());
}

static const test::Registered<SelectToolsTest> registered;
#include "select_tools_test.moc"
