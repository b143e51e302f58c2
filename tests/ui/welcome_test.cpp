// What meets a person who has opened nothing, and the tour that they take with their own hands.
#include "ui/window/welcome.h"

#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/start_card.h"
#include "ui/window/tour.h"
#include "ui/window_fixture.h"

#include <QToolButton>

using test::WindowFixture;

class WelcomeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theCardOpensWhatWasOpenedLately();
    void wordsAreWholeInASmallPicture();
    void aPressBesideTheCardSculpts();
    void escClosesTheCardAfterAllElse();
    void theTourGoesOnWhenAStepWasDone();
    void theTourEndsAtItsEnd();
};

static ui::StartCard* cardOf(WindowFixture& f) {
    return f.view().findChild<ui::StartCard*>();
}

static QToolButton* buttonOf(ui::StartCard& card, const QString& name) {
    for (QToolButton* each : card.findChildren<QToolButton*>())
        if (each->property("start") == name)
            return each;
    return nullptr;
}

void WelcomeTest::theCardOpensWhatWasOpenedLately() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1500));
    f.editor().run({{"op", "save"}, {"path", f.file("lately.ply").toStdString()}});
    QVERIFY(f.settle() && f.make("torus", 800));
    f.editor().run({{"op", "save"}, {"path", f.file("other.ply").toStdString()}}); // nothing to lose
    QVERIFY(f.settle());
    f.window->settings().recentFiles = {f.file("gone.ply").toStdString(), f.file("lately.ply").toStdString()};
    ui::showStart(*f.window);
    QToolButton* recent = buttonOf(*cardOf(f), "start-recent");
    QVERIFY(recent && recent->text() == "lately.ply"); // the one that is gone is left out
    recent->click();
    QVERIFY(f.settle());
    QTRY_COMPARE_WITH_TIMEOUT(f.surfels(), std::size_t(1500), test::patience);
    QTRY_VERIFY_WITH_TIMEOUT(!cardOf(f), test::patience);
}

/// 1280 x 720 at scale 1.5 showed "ock of cla" and "osahedr".
void WelcomeTest::wordsAreWholeInASmallPicture() {
    WindowFixture f;
    for (const QSize size : {QSize(1280, 760), QSize(853, 450), QSize(720, 400), QSize(1000, 700)}) {
        f.window->resize(size);
        ui::showStart(*f.window);
        QCoreApplication::processEvents();
        ui::StartCard& card = *cardOf(f);
        int seen = 0;
        for (const QToolButton* each : card.findChildren<QToolButton*>()) {
            if (each->isHidden())
                continue;
            ++seen;
            QVERIFY2(card.rect().contains(each->geometry()) && each->width() >= each->sizeHint().width(),
                     qPrintable(QString("%1 at %2").arg(each->text()).arg(size.width())));
        }
        QVERIFY(seen >= 3);
        card.close();
        QTRY_VERIFY_WITH_TIMEOUT(!cardOf(f), test::patience);
    }
}

void WelcomeTest::aPressBesideTheCardSculpts() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    ui::showStart(*f.window);
    const QRect card = cardOf(f)->geometry();
    QVERIFY(f.view().rect().contains(card));
    // What happens on the card never reaches the picture.
    test::sendMouse(*cardOf(f), QEvent::MouseButtonPress, QPointF(5, 5), Qt::LeftButton);
    QVERIFY(cardOf(f) && cardOf(f)->isVisible());
    f.press(f.centre());
    f.release(f.centre());
    QVERIFY(f.editor().snapshot().canUndo);
    QTRY_VERIFY_WITH_TIMEOUT(!cardOf(f), test::patience);
}

void WelcomeTest::escClosesTheCardAfterAllElse() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    ui::showTour(*f.window);
    f.window->sculptView().picker().begin({ui::PickShape::Lasso, [](const ui::Pick&) {}, [] {}});
    f.window->escape();
    QVERIFY(!f.window->sculptView().picker().on() && f.view().findChild<ui::Tour*>());
    f.window->escape();
    QTRY_VERIFY_WITH_TIMEOUT(!f.view().findChild<ui::Tour*>(), test::patience);
}

void WelcomeTest::theTourGoesOnWhenAStepWasDone() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    ui::showTour(*f.window);
    ui::Tour& tour = *f.view().findChild<ui::Tour*>();
    QTest::qWait(300);
    QCOMPARE(tour.step(), 0); // nothing was done
    f.drag({900, 600}, {850, 560}, {}, Qt::RightButton);
    QTRY_COMPARE_WITH_TIMEOUT(tour.step(), 1, test::patience);
    f.drag(f.centre() - QPointF(20, 0), f.centre() + QPointF(20, 0));
    QTRY_COMPARE_WITH_TIMEOUT(tour.step(), 2, test::patience);
    f.drag(f.centre() - QPointF(20, 0), f.centre() + QPointF(20, 0), Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(tour.step(), 3, test::patience);
    f.window->sculptView().sizing().scaleRadius(1.5);
    QTRY_COMPARE_WITH_TIMEOUT(tour.step(), 4, test::patience);
    f.window->undo();
    QTRY_COMPARE_WITH_TIMEOUT(tour.step(), 5, test::patience);
}

void WelcomeTest::theTourEndsAtItsEnd() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 1000));
    ui::showTour(*f.window);
    ui::Tour& tour = *f.view().findChild<ui::Tour*>();
    for (int step = 0; step < static_cast<int>(ui::tourTable().size()); ++step) {
        QCOMPARE(tour.step(), step);
        QVERIFY(f.view().rect().contains(tour.geometry()));
        tour.go(step + 1);
    }
    QTRY_VERIFY_WITH_TIMEOUT(!f.view().findChild<ui::Tour*>(), test::patience);
}

static const test::Registered<WelcomeTest> registered;
#include "welcome_test.moc"
