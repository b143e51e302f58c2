// Trimming with the pointer: what is drawn becomes the command that a session would hold, once.
#include "support/registry.h"
#include "ui/window_fixture.h"

#include <QAction>
#include <QMenu>

using test::WindowFixture;

class TrimToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatLiesBehindAnOutlineGoes_data();
    void whatLiesBehindAnOutlineGoes();
    void afterOneOutlineThePointerSculptsAgain();
    void anEmptyWindowSaysWhy();
};

namespace {

struct Trims {
    WindowFixture f;
    bool ready = f.make("sphere", 4000);

    QAction* action(const QString& id) {
        for (QAction* each : f.window->findChild<QMenu*>("trim")->actions())
            if (each->data() == "trim-" + id)
                return each;
        return nullptr;
    }
    QPointF at(double x, double y) { return {x * f.view().width(), y * f.view().height()}; }
    std::size_t size() {
        f.settle();
        return f.editor().snapshot().surface.tree().size();
    }
    bool picking() { return f.window->sculptView().picker().on(); }
};

} // namespace

void TrimToolsTest::whatLiesBehindAnOutlineGoes_data() {
    QTest::addColumn<bool>("inside");
    QTest::newRow("away") << false;
    QTest::newRow("Shift keeps it") << true;
}

void TrimToolsTest::whatLiesBehindAnOutlineGoes() {
    QFETCH(bool, inside);
    Trims t;
    const std::size_t before = t.size();
    t.action("rectangle")->trigger();
    QVERIFY(t.picking());
    t.f.press(t.at(0.5, 0.01), inside ? Qt::ShiftModifier : Qt::NoModifier);
    t.f.moveTo(t.at(0.7, 0.5));
    t.f.moveTo(t.at(0.95, 0.99));
    t.f.release(t.at(0.95, 0.99), inside ? Qt::ShiftModifier : Qt::NoModifier);
    const std::size_t after = t.size();
    QVERIFY2(after > before / 3 && after < before, QByteArray::number(after)); // half of the ball, and the cut
    const render::Camera camera = t.f.window->sculptView().motion().camera();
    const double edge = t.at(0.5, 0).x() * t.f.view().devicePixelRatioF();
    t.f.editor().snapshot().surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const double x = camera.project(base::cast<double>(block.position(slot))).x;
            QVERIFY(inside ? x > edge - 2 : x < edge + 2);
        }
    });
    QCOMPARE(t.f.editor().snapshot().undoLabel, std::string("Trim"));
}

void TrimToolsTest::afterOneOutlineThePointerSculptsAgain() {
    Trims t;
    t.action("lasso")->trigger();
    t.f.window->escape();
    QVERIFY(!t.picking());
    t.action("lasso")->trigger();
    t.f.press(t.at(0.4, 0.4));
    for (const auto& [x, y] : {std::pair{0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}})
        t.f.moveTo(t.at(x, y));
    t.f.release(t.at(0.4, 0.6));
    t.size();
    QVERIFY(!t.picking());
    QCOMPARE(t.f.editor().snapshot().undoLabel, std::string("Trim"));
}

void TrimToolsTest::anEmptyWindowSaysWhy() {
    WindowFixture f;
    f.window->findChild<QMenu*>("trim")->actions().front()->trigger();
    QVERIFY(!f.window->sculptView().picker().on());
}

static const test::Registered<TrimToolsTest> registered;
#include "trim_tools_test.moc"
