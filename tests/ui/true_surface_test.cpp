// The true surface in the window: it replaces the splats where the view rests, and follows strokes.
#include "core/render/cast/raycast_image.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/panels/truth_bar.h"
#include "window_fixture.h"

using test::WindowFixture;

class TrueSurfaceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void viewAtRestBecomesTheRayCast();
    void strokesGoOnAndAreRefined();
    void barAndSwitchAreRemembered();
};

namespace {

/// The window's fixture, and what its viewport tells of refinement.
struct Fixture : WindowFixture {
    std::optional<ui::Refinement> last;
    int levels = 0, complete = 0;

    Fixture() {
        auto inner = window->viewport().refined;
        window->viewport().refined = [this, inner](const std::optional<ui::Refinement>& refinement) {
            inner(refinement);
            last = refinement;
            levels += refinement && refinement->quality > 0;
            complete += refinement && refinement->complete;
        };
    }
    ~Fixture() { window.reset(); }
    QAction* truth() { return action("view", "True Surface"); }
    bool refined() {
        const int before = complete;
        return QTest::qWaitFor([this, before] { return complete > before; }, test::patience);
    }
    double meanDifferenceToRays() {
        auto& scene = window->sculptView();
        render::Image cast;
        render::RayCounts counts;
        render::rayCast(editor().snapshot().surface, scene.motion().camera(), scene.look().options(), cast, counts);
        const QImage shown = window->viewport().picture();
        double sum = 0;
        for (int y = 0; y < cast.height; ++y)
            for (int x = 0; x < cast.width; ++x) {
                const QRgb pixel = shown.pixel(x, y);
                const surfel::Colour c = cast.colour[static_cast<std::size_t>(y * cast.width + x)];
                sum += std::abs(qRed(pixel) - int(c & 255u)) + std::abs(qGreen(pixel) - int(c >> 8 & 255u)) +
                       std::abs(qBlue(pixel) - int(c >> 16 & 255u));
            }
        return sum / (3.0 * cast.width * cast.height);
    }
};

} // namespace

void TrueSurfaceTest::viewAtRestBecomesTheRayCast() {
    Fixture f;
    QVERIFY(f.make("torus", 8000));
    QCOMPARE(f.levels, 0);
    f.truth()->trigger();
    QVERIFY(f.refined());
    QVERIFY(f.levels >= 2 && f.last->quality <= 1);
    const double near = f.meanDifferenceToRays();
    QVERIFY2(near < 0.3, qPrintable(QString::number(near)));
    f.drag({30, 30}, {130, 60}); // another view
    QVERIFY(f.refined());
    const double turned = f.meanDifferenceToRays();
    QVERIFY2(turned < 0.3, qPrintable(QString::number(turned)));
    f.truth()->trigger();
    QVERIFY(QTest::qWaitFor([&] { return !f.last; }, test::patience));
}

void TrueSurfaceTest::strokesGoOnAndAreRefined() {
    Fixture f;
    QVERIFY(f.make("sphere", 6000));
    f.truth()->trigger();
    QVERIFY(f.refined());
    f.drag(f.centre(), f.centre() + QPointF(40, 10));
    QVERIFY(f.editor().snapshot().canUndo);
    QVERIFY(f.refined());
    const double near = f.meanDifferenceToRays();
    QVERIFY2(near < 0.3, qPrintable(QString::number(near)));
}

void TrueSurfaceTest::barAndSwitchAreRemembered() {
    WindowFixture f;
    auto* bar = f.window->findChild<ui::TruthBar*>("true-surface");
    QVERIFY(bar && !bar->isVisibleTo(f.window.get()));
    f.action("view", "True Surface")->trigger();
    QVERIFY(bar->isVisibleTo(f.window.get()) && f.window->settings().truth.on);
    ui::TruthSettings changed = bar->settings();
    changed.quality = 2;
    Q_EMIT bar->edited(changed);
    QCOMPARE(f.window->settings().truth.quality, 2.0);
    f.window->close();
    f.open();
    QVERIFY(f.window->settings().truth == changed);
    QVERIFY(f.window->findChild<ui::TruthBar*>("true-surface")->isVisibleTo(f.window.get()));
    QVERIFY(f.action("view", "True Surface")->isChecked());
}

static const test::Registered<TrueSurfaceTest> registered;
#include "true_surface_test.moc"
