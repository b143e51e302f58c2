// Bars over the viewport: they come and go without the picture changing its size, act at once, and keep clicks to
// themselves.
#include "support/registry.h"
#include "ui/panels/cut_bar.h"
#include "ui/panels/mesh_bar.h"
#include "ui/panels/truth_bar.h"
#include "ui/window/mesh_export.h"
#include "ui/window_fixture.h"

#include <QSlider>
#include <QToolBar>
#include <QToolButton>

using test::WindowFixture;

class FloatingBarsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void barsLeaveThePictureItsSize();
    void barsStandAboveEachOtherInsideTheViewport();
    void everySliderIsThereInASmallPicture();
    void clicksBesideTheirButtonsStayThere();
    void movingASliderCutsAtOnce();
};

/// All three shown.
static std::vector<QWidget*> showBars(WindowFixture& f) {
    f.action("view", "True Surface")->trigger();
    f.action("view", "Clipping")->trigger();
    f.action("file", "Export Mesh…")->trigger();
    QCoreApplication::processEvents();
    return {f.window->findChild<ui::TruthBar*>(), f.window->findChild<ui::CutBar*>(),
            f.window->findChild<ui::MeshBar*>()};
}

void FloatingBarsTest::barsLeaveThePictureItsSize() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const QSize size = f.view().size();
    const render::Camera camera = f.window->sculptView().motion().camera();
    for (QWidget* bar : showBars(f))
        QVERIFY(bar && bar->isVisible() && bar->height() > 10);
    QVERIFY(f.view().size() == size && f.window->sculptView().motion().camera() == camera);
}

void FloatingBarsTest::barsStandAboveEachOtherInsideTheViewport() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    for (const QSize size : {QSize(1400, 900), QSize(1000, 700), QSize(700, 480)}) {
        f.window->resize(size);
        const std::vector<QWidget*> bars = showBars(f);
        for (const QWidget* bar : bars) {
            QVERIFY2(f.view().rect().contains(bar->geometry()), qPrintable(bar->objectName()));
            for (const QWidget* other : bars)
                QVERIFY(bar == other || !bar->geometry().intersects(other->geometry()));
        }
        showBars(f); // hidden again
    }
}

/// 1280 x 720 at scale 1.5 had sliders for two planes, and half of the words of other bars.
void FloatingBarsTest::everySliderIsThereInASmallPicture() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    f.action("view", "Clipping")->trigger();
    f.action("view", "Layers")->trigger();
    f.action("select", "Show the Bar")->trigger();
    f.action("measure", "Show the Bar")->trigger();
    for (const QSize size : {QSize(1280, 700), QSize(853, 700), QSize(1280, 700)}) {
        f.window->resize(size);
        QCoreApplication::processEvents();
        for (const char* name : {"clipping", "layers", "select", "measure"}) {
            const QWidget& bar = *f.window->findChild<QToolBar*>(name);
            QVERIFY2(f.view().rect().contains(bar.geometry()), name);
            for (const QWidget* each : bar.findChildren<QWidget*>()) {
                if (each->isHidden() || each->objectName().startsWith("qt_") ||
                    !(qobject_cast<const QToolButton*>(each) || qobject_cast<const QSlider*>(each)))
                    continue;
                const QRect place(each->mapTo(&bar, QPoint(0, 0)), each->size());
                QVERIFY2(each->isVisible() && bar.rect().contains(place) &&
                             (qobject_cast<const QSlider*>(each) || each->width() >= each->sizeHint().width()),
                         qPrintable(QString("%1 of %2 at %3: %4 of %5")
                                        .arg(each->objectName(), QString(name))
                                        .arg(size.width())
                                        .arg(each->width())
                                        .arg(each->sizeHint().width())));
            }
        }
    }
    for (const QToolButton* more : f.view().findChildren<QToolButton*>("qt_toolbar_ext_button"))
        QVERIFY(!more->icon().isNull() && !more->toolTip().isEmpty());
}

void FloatingBarsTest::clicksBesideTheirButtonsStayThere() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 3000));
    const base::Hash128 hash = f.hash();
    const render::Camera camera = f.window->sculptView().motion().camera();
    for (QWidget* bar : showBars(f)) {
        const QPointF at(3, 3); // the bar's margin
        test::sendMouse(*bar, QEvent::MouseButtonPress, at, Qt::LeftButton);
        test::sendMouse(*bar, QEvent::MouseMove, at + QPointF(40, 0), Qt::LeftButton);
        test::sendMouse(*bar, QEvent::MouseButtonRelease, at + QPointF(40, 0), Qt::LeftButton);
    }
    QVERIFY(f.window->sculptView().pointer().gesture() == ui::PointerRouter::Gesture::None);
    QVERIFY(f.hash() == hash && f.window->sculptView().motion().camera() == camera);
}

void FloatingBarsTest::movingASliderCutsAtOnce() {
    WindowFixture f;
    QVERIFY(f.make("torus", 4000));
    ui::CutPlanes& cuts = f.window->sculptView().cuts();
    auto& bar = *f.window->findChild<ui::CutBar*>();
    for (std::size_t k = 0; k < cuts.cuts().each.size(); ++k) {
        auto* slider = bar.findChild<QSlider*>(QString("cut-%1-place").arg(k));
        QVERIFY(slider->isEnabled() && !cuts.cuts().each[k].on);
        slider->setValue(1400);
        QVERIFY(cuts.cuts().each[k].on);
        QCOMPARE(f.window->sculptView().motion().camera().clips.all().size(), k + 1);
        QVERIFY(bar.findChild<QToolButton*>(QString("cut-%1").arg(k))->isChecked());
        QCOMPARE(slider->value(), 1400);
    }
    // The free one looks the way the view does.
    QVERIFY(distance(cuts.cuts().each[3].normal, -f.window->sculptView().motion().camera().forward()) < 1e-9);
}

static const test::Registered<FloatingBarsTest> registered;
#include "floating_bars_test.moc"
