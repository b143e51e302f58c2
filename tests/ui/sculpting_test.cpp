// The hand on the clay, through the window: strokes, their undo, their record, and what the keys change.
#include "core/session/journal.h"
#include "core/session/recover.h"
#include "core/session/session_file.h"
#include "reach.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "ui/panels/tool_bar.h"
#include "ui/window/status_line.h"
#include "window_fixture.h"

#include <QPointingDevice>
#include <QTabletEvent>

using test::Reach;
using test::reachOf;
using test::WindowFixture;

class SculptingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyToolMovesPointsAndUndoBringsTheHashBack();
    void recordedSessionReplaysToTheSameHashWithoutAWindow();
    void strokesRecordWhichAxisIsUpright();
    void escapeTakesAStrokeBackWithoutATrace();
    void undoDuringAStrokeTakesItBack();
    void symmetricStrokeWorksOnBothSides();
    void controlInverts();
    void shiftUsesTheSmoothingTool();
    void penPressureChangesStrength();
    void floodOfInputNeverQueues();
    void escapeEndsAStrokeThatWaits();
    void cloneCopiesFromWhereControlClicked();
    void killedSessionsAreRecovered();
    void paintingIsSeen();
};

void SculptingTest::everyToolMovesPointsAndUndoBringsTheHashBack() {
    WindowFixture f;
    QVERIFY(f.make("knot", 8000));
    f.window->sculptView().motion().frameAll();
    const base::Hash128 start = f.hash();
    // Some place on the model.
    QPointF place = f.centre();
    for (int k = 0; k < 200 && !f.window->sculptView().cursor().contact; ++k) {
        place = f.centre() + QPointF(k, k / 3.0);
        test::sendMouse(f.view(), QEvent::MouseMove, place, Qt::NoButton);
    }
    QVERIFY(f.window->sculptView().cursor().contact);
    for (QAction* tool : f.window->toolBar().toolActions()) {
        const QString name = tool->text().remove('&');
        tool->trigger();
        f.drag(place, place + QPointF(30, 20));
        // no source, no colours, no stored shape: nothing to carry, and nothing to go back to; even samples are at rest
        if (name == "Clone" || name == "Smear" || name == "Morph" || name == "Relax") {
            QVERIFY(!f.editor().snapshot().canUndo);
            continue;
        }
        QVERIFY2(f.editor().snapshot().canUndo, qPrintable(tool->text()));
        const base::Hash128 sculpted = f.hash();
        QVERIFY2(!(sculpted == start), qPrintable(tool->text()));
        QVERIFY(f.action("edit", "Undo " + name) != nullptr);
        f.window->undo();
        QVERIFY(f.settle());
        QVERIFY2(f.hash() == start, qPrintable(tool->text()));
        f.window->redo();
        QVERIFY(f.settle());
        QVERIFY(f.hash() == sculpted);
        f.window->undo();
        QVERIFY(f.settle());
    }
}

void SculptingTest::recordedSessionReplaysToTheSameHashWithoutAWindow() {
    WindowFixture f;
    QVERIFY(f.make("sphere", test::sanitized ? 2500 : 6000));
    f.window->settings().shared.symmetry.planes = {true, false, false};
    int k = 0;
    for (QAction* tool : f.window->toolBar().toolActions()) {
        tool->trigger();
        f.drag(f.centre() + QPointF(30 - 10 * k, 15 * k), f.centre() + QPointF(80, -60 + 20 * k));
        f.drag(f.centre() + QPointF(-40, 5), f.centre() + QPointF(-60, 50), Qt::ControlModifier);
        ++k;
    }
    f.window->undo();
    f.window->undo();
    f.window->redo();
    f.editor().run({{"op", "resample"}});
    f.drag(f.centre(), f.centre() + QPointF(5, 60), Qt::ShiftModifier);
    QVERIFY(f.settle());
    const base::Hash128 live = f.hash();

    session::Document document;
    session::Context context{document, {}, {}, {}, 0, {}, nullptr};
    const int lines = session::replay(f.journal(), context);
    QVERIFY2(lines >= 10, qPrintable(QString::number(lines)));
    QCOMPARE(QString::fromStdString(document.hash().text()), QString::fromStdString(live.text()));
    QCOMPARE(document.surface().tree().size(), f.surfels());
}

static QByteArray contentOf(const std::filesystem::path& path) {
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void SculptingTest::strokesRecordWhichAxisIsUpright() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    f.editor().run({{"op", "up"}, {"axis", "-z"}});
    QVERIFY(f.settle());
    f.drag(f.centre(), f.centre() + QPointF(30, 0));
    QVERIFY(f.editor().snapshot().canUndo);
    QVERIFY(contentOf(f.journal()).contains("\"stamp-upright\":\"-z\""));
}

void SculptingTest::escapeTakesAStrokeBackWithoutATrace() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 6000));
    const base::Hash128 start = f.hash();
    const QByteArray journal = contentOf(f.journal());
    f.press(f.centre());
    f.moveTo(f.centre() + QPointF(40, 0));
    f.moveTo(f.centre() + QPointF(80, 0));
    QVERIFY(!(f.editor().snapshot().surface.tree().contentHash() == base::Hash128{}));
    QVERIFY(reachOf(f).highest > 1.001f * reachOf(f).lowest); // seen while it lasts
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
    QTest::keyClick(&f.view(), Qt::Key_Escape);
    f.moveTo(f.centre() + QPointF(120, 0));
    f.release(f.centre() + QPointF(120, 0));
    QVERIFY(f.settle());
    QVERIFY(f.hash() == start);
    QVERIFY(!f.editor().snapshot().canUndo);
    QVERIFY(!f.window->isWindowModified());
    QCOMPARE(contentOf(f.journal()), journal);
    QVERIFY(reachOf(f).highest < 1.001f * reachOf(f).lowest); // and the picture's model went back too
}

void SculptingTest::undoDuringAStrokeTakesItBack() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    f.drag(f.centre(), f.centre() + QPointF(30, 0));
    const base::Hash128 one = f.hash();
    f.press(f.centre());
    f.moveTo(f.centre() + QPointF(0, 40));
    f.window->undo();
    f.release(f.centre() + QPointF(0, 40));
    QVERIFY(f.hash() == one);
    QVERIFY(f.editor().snapshot().canUndo);
}

void SculptingTest::symmetricStrokeWorksOnBothSides() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 8000));
    f.window->sculptView().motion().turnTo(render::namedViews()[0]);
    f.window->settings().shared.symmetry.planes = {true, false, false};
    const float radius = reachOf(f).highest;
    f.drag(f.centre() + QPointF(90, -10), f.centre() + QPointF(90, 30));
    float left = 0, right = 0;
    for (const auto& s : f.editor().snapshot().surface.tree().surfels().items)
        (s.position.x < 0 ? left : right) = std::max(s.position.x < 0 ? left : right, length(s.position));
    QVERIFY(right > radius * 1.005f);
    QVERIFY(std::abs((left - radius) / (right - radius) - 1) < 0.05f);
}

void SculptingTest::controlInverts() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 6000));
    const Reach start = reachOf(f);
    f.drag(f.centre(), f.centre() + QPointF(40, 0));
    const Reach out = reachOf(f);
    QVERIFY(out.highest > start.highest * 1.005f && out.lowest > start.lowest * 0.999f);
    f.window->undo();
    f.drag(f.centre(), f.centre() + QPointF(40, 0), Qt::ControlModifier);
    const Reach in = reachOf(f);
    QVERIFY(in.lowest < start.lowest * 0.995f && in.highest < start.highest * 1.001f);
}

void SculptingTest::shiftUsesTheSmoothingTool() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 6000));
    f.drag(f.centre(), f.centre() + QPointF(10, 0));
    const float bump = reachOf(f).highest;
    f.drag(f.centre(), f.centre() + QPointF(10, 0), Qt::ShiftModifier);
    QCOMPARE(f.editor().snapshot().undoLabel, std::string(sculpt::tool(f.window->settings().shiftTool).label));
    QVERIFY(reachOf(f).highest < bump);
    QCOMPARE(f.window->settings().toolRow().id, sculpt::toolTable().front().id);
}

static void sendPen(QWidget& widget, QEvent::Type type, QPointF at, double pressure) {
    static const QPointingDevice pen("pen", 7, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                                     QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 3);
    const bool moving = type == QEvent::TabletMove, up = type == QEvent::TabletRelease;
    QTabletEvent event(type, &pen, at, widget.mapToGlobal(at), up ? 0 : pressure, 0, 0, 0, 0, 0, Qt::NoModifier,
                       moving ? Qt::NoButton : Qt::LeftButton, up ? Qt::NoButton : Qt::LeftButton);
    QApplication::sendEvent(&widget, &event);
}

void SculptingTest::penPressureChangesStrength() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 6000));
    const float start = reachOf(f).highest;
    float before = start;
    for (const double pressure : {0.15, 0.5, 1.0}) {
        sendPen(f.view(), QEvent::TabletPress, f.centre(), pressure);
        f.settle();
        for (int k = 1; k <= 4; ++k) {
            sendPen(f.view(), QEvent::TabletMove, f.centre() + QPointF(10 * k, 0), pressure);
            f.settle();
        }
        sendPen(f.view(), QEvent::TabletRelease, f.centre() + QPointF(40, 0), pressure);
        QVERIFY(f.settle());
        const float height = reachOf(f).highest;
        QVERIFY2(height > before, qPrintable(QString("pressure %1").arg(pressure)));
        before = height;
        f.window->undo();
        QVERIFY(f.settle());
    }
}

void SculptingTest::floodOfInputNeverQueues() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 20000));
    f.window->settings().radiusPx = 100;
    constexpr int flood = 3000;
    f.press(f.centre());
    for (int k = 0; k < flood; ++k) { // no event loop between: faster than any hand
        test::sendMouse(f.view(), QEvent::MouseMove,
                        f.centre() + QPointF(60 * std::sin(k * 0.01), 60 * std::cos(k * 0.01)), Qt::LeftButton);
        if (k % 50 == 0) { // what is done is counted off
            QCoreApplication::processEvents();
            QVERIFY2(f.editor().waiting() <= 3, qPrintable(QString::number(f.editor().waiting())));
        }
    }
    f.release(f.centre() + QPointF(0, 60));
    QVERIFY(f.settle());

    session::Document document; // how much was merged depends on the machine; what was kept is what was sculpted
    session::Context context{document, {}, {}, {}, 0, {}, nullptr};
    session::replay(f.journal(), context);
    QVERIFY(document.hash() == f.hash());
}

void SculptingTest::escapeEndsAStrokeThatWaits() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 60000));
    const base::Hash128 start = f.hash();
    const QByteArray journal = contentOf(f.journal());
    f.window->settings().radiusPx = 300;
    f.press(f.centre());
    for (int k = 0; k < 1000; ++k)
        test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(100 * std::sin(k * 0.1), k * 0.1),
                        Qt::LeftButton);
    f.window->sculptView().pointer().cancel();
    f.press(f.centre()); // another one right behind it is none of its business
    f.moveTo(f.centre() + QPointF(50, 0));
    QVERIFY(reachOf(f).highest > 1.001f * reachOf(f).lowest);
    f.window->sculptView().pointer().cancel();
    QVERIFY(f.settle());
    QVERIFY(f.hash() == start);
    QCOMPARE(contentOf(f.journal()), journal);
    QVERIFY(reachOf(f).highest < 1.001f * reachOf(f).lowest);
}

void SculptingTest::cloneCopiesFromWhereControlClicked() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 30000));
    const QPointF bump = f.centre() + QPointF(-90, 0), other = f.centre() + QPointF(90, 0);
    f.window->settings().radiusPx = 25;
    for (int k = 0; k < 8; ++k)
        f.drag(bump, bump + QPointF(2, 0));
    const auto heightAt = [&](QPointF at) {
        test::sendMouse(f.view(), QEvent::MouseMove, at, Qt::NoButton);
        return base::length(f.window->sculptView().cursor().contact->position);
    };
    const double bare = heightAt(other), bumped = heightAt(bump);
    QVERIFY(bumped > bare * 1.002);
    for (QAction* tool : f.window->toolBar().toolActions())
        if (tool->text() == "Clone")
            tool->trigger();
    f.window->settings().radiusPx = 60;
    const base::Hash128 before = f.hash();
    f.drag(other, other + QPointF(1, 0)); // nothing chosen yet: nothing done, and the person is told
    QVERIFY(f.hash() == before);
    QVERIFY(f.window->statusLine().message().contains("Ctrl"));
    f.press(bump, Qt::ControlModifier);
    f.release(bump, Qt::ControlModifier);
    QVERIFY(f.hash() == before);
    QVERIFY(f.window->sculptView().source().place());
    f.drag(other, other + QPointF(1, 0));
    QVERIFY2(heightAt(other) - bare > 0.4 * (bumped - bare), qPrintable(QString::number(heightAt(other) - bare)));
    QVERIFY(f.make("sphere", 3000));
    QVERIFY(!f.window->sculptView().source().place()); // another model, another place
}

void SculptingTest::paintingIsSeen() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    QVERIFY(f.window->settings().shading == render::Shading::Matcap);
    f.window->settings().tool = "draw";
    f.drag(f.centre(), f.centre() + QPointF(30, 0));
    QVERIFY(f.window->settings().shading == render::Shading::Matcap);
    f.window->settings().tool = "paint";
    f.drag(f.centre(), f.centre() + QPointF(60, 0));
    QVERIFY(f.window->settings().shading == render::Shading::Colour);
    // Whoever likes them without light keeps that.
    for (QAction* action : f.window->menu("shading")->actions())
        if (action->data().toString() == "unlit")
            action->trigger();
    f.drag(f.centre(), f.centre() + QPointF(60, 20));
    QVERIFY(f.window->settings().shading == render::Shading::Unlit);
    f.window->settings().shading = render::Shading::Spacing;
    f.window->settings().tool = "mask";
    f.drag(f.centre(), f.centre() + QPointF(60, 20));
    QVERIFY(f.window->settings().shading == render::Shading::Mask);
}

void SculptingTest::killedSessionsAreRecovered() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    f.drag(f.centre(), f.centre() + QPointF(50, 0));
    f.drag(f.centre(), f.centre() + QPointF(0, 50));
    const base::Hash128 lost = f.hash();
    f.press(f.centre());
    f.moveTo(f.centre() + QPointF(-50, 0)); // in progress: this much may be lost
    f.window.reset();                       // no closing: as if killed, the lock is gone and the file stays

    const std::filesystem::path left = f.file("journal-left.jsonl").toStdString();
    std::filesystem::rename(f.journal(), left);
    const auto journals = session::findLeftJournals(f.folder.path().toStdString());
    QCOMPARE(journals.size(), std::size_t(1));
    QCOMPARE(journals.front().commands, 2);
    f.open();
    bool recovered = false;
    f.editor().recover(left, [&](bool done, const session::Recovery&) { recovered = done; });
    QVERIFY(f.settle());
    QVERIFY(recovered);
    QVERIFY(f.hash() == lost);
    QVERIFY(f.editor().snapshot().modified && f.editor().snapshot().canUndo);
    // The new journal holds it all again.
    session::Document document;
    session::Context context{document, {}, {}, {}, 0, {}, nullptr};
    session::replay(f.journal(), context);
    QVERIFY(document.hash() == lost);
}

static const test::Registered<SculptingTest> registered;
#include "sculpting_test.moc"
