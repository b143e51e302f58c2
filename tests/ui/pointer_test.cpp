// What the pointer does beside sculpting: it turns the view, shows the exact contact, changes radius and strength.
#include "reach.h"
#include "support/patience.h"
#include "support/registry.h"

using test::reachOf;
using test::WindowFixture;

class PointerTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void dragBesideTheModelTurnsTheView();
    void rightDragTurnsTheViewOnTheModelToo();
    void wheelZoomsTowardsThePointer();
    void cursorLiesAtTheExactContact();
    void symmetryIsShownOverThePictureOnly();
    void bracketsAndFChangeTheRadius();
    void modelRadiusKeepsItsSizeOnTheModel();
    void shiftFChangesTheStrength();
    void aTapOfFLastsUntilAClick();
    void theUnitOfTheRadiusIsConverted();
};

void PointerTest::dragBesideTheModelTurnsTheView() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const base::Hash128 start = f.hash();
    const ui::View before = f.window->sculptView().motion().view();
    f.drag({8, 8}, {108, 58});
    const ui::View after = f.window->sculptView().motion().view();
    const base::Vec3d eye = before.turn.inverse()(after.turn({0, 0, 1}));
    QVERIFY(eye.x < -0.1 && after.turn({0, 0, 1}).y > before.turn({0, 0, 1}).y);
    QCOMPARE(after.distance, before.distance);
    QVERIFY(f.hash() == start);
    QVERIFY(!f.editor().snapshot().canUndo);
}

void PointerTest::rightDragTurnsTheViewOnTheModelToo() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const ui::View before = f.window->sculptView().motion().view();
    const auto eye = [&] { return before.turn.inverse()(f.window->sculptView().motion().view().turn({0, 0, 1})); };
    f.drag(f.centre(), f.centre() + QPointF(50, 0), {}, Qt::RightButton);
    QVERIFY(eye().x < -0.05);
    f.drag(f.centre(), f.centre() + QPointF(-50, 0), Qt::AltModifier);
    QVERIFY(base::distance(eye(), {0, 0, 1}) < 1e-9);
    QVERIFY(!f.editor().snapshot().canUndo);
}

void PointerTest::wheelZoomsTowardsThePointer() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const QPointF at = f.centre() + QPointF(60, 30);
    test::sendMouse(f.view(), QEvent::MouseMove, at, Qt::NoButton);
    const auto contact = f.window->sculptView().cursor().contact;
    QVERIFY(contact);
    const double distance = f.window->sculptView().motion().view().distance;
    QWheelEvent wheel(at, f.view().mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&f.view(), &wheel);
    QVERIFY(f.window->sculptView().motion().view().distance < distance);
    const base::Vec3d place = f.window->sculptView().motion().camera().project(contact->position);
    QVERIFY(std::hypot(place.x - at.x(), place.y - at.y()) < 0.01);
}

void PointerTest::cursorLiesAtTheExactContact() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 20000));
    const float radius = reachOf(f).highest;
    for (const QPointF by : {QPointF(0, 0), QPointF(70, 40), QPointF(-90, 20)}) {
        test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + by, Qt::NoButton);
        const auto& cursor = f.window->sculptView().cursor();
        QVERIFY(cursor.contact);
        const base::Vec3d p = cursor.contact->position;
        QVERIFY(std::abs(base::length(p) / double(radius) - 1) < 2e-3);
        QVERIFY(base::dot(base::normalized(p), cursor.contact->normal) > 0.9999); // tilted to the surface
        const base::Vec3d place = f.window->sculptView().motion().camera().project(p);
        QVERIFY(std::hypot(place.x - f.centre().x() - by.x(), place.y - f.centre().y() - by.y()) < 0.01);
        // The circle has the asked radius in pixels where it is seen from the front.
        const double pixels = cursor.radius * f.window->sculptView().motion().camera().focalPx() / place.z;
        QVERIFY(std::abs(pixels - f.window->settings().radiusPx) < 1e-6);
    }
    test::sendMouse(f.view(), QEvent::MouseMove, {3, 3}, Qt::NoButton);
    QVERIFY(!f.window->sculptView().cursor().contact);
}

void PointerTest::symmetryIsShownOverThePictureOnly() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 4000));
    QTRY_VERIFY_WITH_TIMEOUT(!f.window->viewport().picture().isNull(), test::patience);
    const auto rest = [&] { // the last picture is the one with smooth outlines, which takes its time
        QImage last;
        for (int same = 0, waits = 0; same < 5 && waits < 100; ++waits) {
            QTest::qWait(300);
            const QImage now = f.window->viewport().picture();
            same = now == last ? same + 1 : 0;
            last = now;
        }
    };
    rest();
    const auto seen = [&] {
        f.view().update();
        QCoreApplication::processEvents();
        return f.view().grab().toImage();
    };
    const QImage plain = seen(), picture = f.window->viewport().picture();
    QVERIFY(plain == seen());
    std::vector<QImage> shown{plain};
    for (const sculpt::Symmetry& symmetry :
         {sculpt::Symmetry{{true}}, sculpt::Symmetry{{false, true}}, sculpt::Symmetry{{}, 5, sculpt::Axis::Y}}) {
        f.window->settings().shared.symmetry = symmetry;
        f.window->sculptView().refresh();
        QTRY_VERIFY_WITH_TIMEOUT(seen() != shown.back(), test::patience); // the curve is traced in the background
        rest();
        shown.push_back(seen());
        for (std::size_t i = 0; i + 1 < shown.size(); ++i)
            QVERIFY(shown[i] != shown.back());
    }
    QVERIFY(f.window->viewport().picture() == picture);
    f.window->settings().shared.symmetry = {};
    f.window->sculptView().refresh();
    QTRY_VERIFY_WITH_TIMEOUT(seen() == plain, test::patience);
}

void PointerTest::bracketsAndFChangeTheRadius() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
    f.view().setFocus();
    const double start = f.window->settings().radiusPx;
    QTest::keyClick(&f.view(), Qt::Key_BracketRight);
    QVERIFY(f.window->settings().radiusPx > start);
    QTest::keyClick(&f.view(), Qt::Key_BracketLeft);
    QVERIFY(std::abs(f.window->settings().radiusPx - start) < 1e-9);

    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    QTest::keyPress(&f.view(), Qt::Key_F);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(60, 0), Qt::NoButton);
    QTest::keyRelease(&f.view(), Qt::Key_F);
    const double dragged = f.window->settings().radiusPx;
    QVERIFY(dragged > start);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    QCOMPARE(f.window->settings().radiusPx, dragged); // F is up again

    QTest::keyPress(&f.view(), Qt::Key_F);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(-90, 0), Qt::NoButton);
    QVERIFY(f.window->settings().radiusPx < dragged);
    QTest::keyClick(&f.view(), Qt::Key_Escape);
    QCOMPARE(f.window->settings().radiusPx, dragged);
    QVERIFY(!f.editor().snapshot().canUndo);
}

void PointerTest::modelRadiusKeepsItsSizeOnTheModel() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    f.window->settings().radiusUnit = ui::RadiusUnit::Model;
    f.window->settings().radiusModel = 0.25;
    for (const int steps : {0, 3, -6}) {
        QWheelEvent wheel(f.centre(), f.view().mapToGlobal(f.centre()), {}, {0, 120 * steps}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&f.view(), &wheel);
        test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
        QCOMPARE(f.window->sculptView().cursor().radius, 0.25);
    }
}

void PointerTest::shiftFChangesTheStrength() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const auto strength = [&] { return f.window->settings().choice(f.window->settings().toolRow()).strength; };
    const double radius = f.window->settings().radiusPx;
    f.window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(f.window.get()));
    f.view().setFocus();
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    const float start = strength();
    QTest::keyPress(&f.view(), Qt::Key_F, Qt::ShiftModifier);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(60, 0), Qt::NoButton, Qt::ShiftModifier);
    QVERIFY(!f.window->sculptView().cursor().label.isEmpty());
    QTest::keyRelease(&f.view(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(std::abs(strength() - start - 0.2f) < 1e-5f);
    QTest::keyPress(&f.view(), Qt::Key_F, Qt::ShiftModifier);
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre() + QPointF(600, 0), Qt::NoButton, Qt::ShiftModifier);
    QCOMPARE(strength(), 1.0f);
    QTest::keyClick(&f.view(), Qt::Key_Escape);
    QVERIFY(std::abs(strength() - start - 0.2f) < 1e-5f);
    QCOMPARE(f.window->settings().radiusPx, radius);
    QVERIFY(f.window->sculptView().cursor().label.isEmpty());
}

void PointerTest::aTapOfFLastsUntilAClick() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const double start = f.window->settings().radiusPx;
    const base::Hash128 hash = f.hash();
    const auto moveTo = [&](QPointF at) { test::sendMouse(f.view(), QEvent::MouseMove, at, Qt::NoButton); };
    const ui::BrushCursor& cursor = f.window->sculptView().cursor();
    for (const Qt::MouseButton button : {Qt::LeftButton, Qt::RightButton}) {
        moveTo(f.centre());
        QTest::keyClick(&f.view(), Qt::Key_F);
        moveTo(f.centre() + QPointF(30, 0));
        moveTo(f.centre() + QPointF(60, 0));
        QVERIFY(cursor.pointer == f.centre() * f.view().devicePixelRatioF()); // the ring stays
        QVERIFY(f.window->settings().radiusPx > start);
        const double dragged = f.window->settings().radiusPx;
        test::sendMouse(f.view(), QEvent::MouseButtonPress, f.centre() + QPointF(60, 0), button);
        test::sendMouse(f.view(), QEvent::MouseButtonRelease, f.centre() + QPointF(60, 0), button);
        QCOMPARE(f.window->settings().radiusPx, button == Qt::LeftButton ? dragged : start);
        QVERIFY(!f.window->sculptView().sizing().dragging());
        f.window->settings().radiusPx = start;
        moveTo(f.centre() + QPointF(90, 0)); // free again
        QCOMPARE(f.window->settings().radiusPx, start);
    }
    QVERIFY(f.hash() == hash); // the click was no stroke
    // Strength, as a filled part of the ring.
    moveTo(f.centre());
    QVERIFY(!cursor.strength);
    QTest::keyClick(&f.view(), Qt::Key_F, Qt::ShiftModifier);
    moveTo(f.centre() + QPointF(30, 0));
    const float strength = f.window->settings().choice(f.window->settings().toolRow()).strength;
    QVERIFY(cursor.strength && std::abs(*cursor.strength - double(strength)) < 1e-6);
    QTest::keyClick(&f.view(), Qt::Key_F, Qt::ShiftModifier); // a second tap ends it, too
    QVERIFY(!f.window->sculptView().sizing().dragging() && !cursor.strength);
}

void PointerTest::theUnitOfTheRadiusIsConverted() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    auto& scene = f.window->sculptView();
    const double place = scene.motion().pixelsPerUnitAt(scene.motion().view().turningPoint());
    const double before = f.window->settings().radiusPx;
    scene.sizing().chooseUnit(ui::RadiusUnit::Model);
    QVERIFY(std::abs(f.window->settings().radiusModel * place / f.view().devicePixelRatioF() / before - 1) < 1e-9);
    f.window->settings().radiusModel *= 2;
    scene.sizing().chooseUnit(ui::RadiusUnit::Pixels);
    QVERIFY(std::abs(f.window->settings().radiusPx / before - 2) < 1e-9);
}

static const test::Registered<PointerTest> registered;
#include "pointer_test.moc"
