// The picture at rest: smooth outlines, which nothing that goes on has to wait for.
#include "support/patience.h"
#include "support/registry.h"
#include "ui/window_fixture.h"
#include "ui/work/render_thread.h"

#include <mutex>

using test::WindowFixture;

class RestTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void outlinesAreSmoothAtRest();
    void strokesGoOnFromTheRoughPicture();
};

/// Colours along the outline that are neither the model's nor the background's: pixels beside which both are.
static int between(const QImage& picture) {
    int out = 0;
    const auto far = [](QRgb a, QRgb b) {
        return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
    };
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 1; x + 1 < picture.width(); ++x) {
            const QRgb a = picture.pixel(x - 1, y), b = picture.pixel(x, y), c = picture.pixel(x + 1, y);
            out += far(a, c) > 90 && far(a, b) > 20 && far(b, c) > 20 ? 1 : 0;
        }
    return out;
}

void RestTest::outlinesAreSmoothAtRest() {
    WindowFixture f;
    QVERIFY(f.make("sphere", 5000));
    QTRY_VERIFY_WITH_TIMEOUT(!f.window->viewport().picture().isNull(), test::patience);
    QTRY_VERIFY_WITH_TIMEOUT(between(f.window->viewport().picture()) > 200, test::patience);
    // And again after a picture of something that moves.
    f.window->sculptView().refresh(true);
    QTRY_VERIFY_WITH_TIMEOUT(between(f.window->viewport().picture()) > 200, test::patience);
}

void RestTest::strokesGoOnFromTheRoughPicture() {
    // Two threads draw the same stroke, one of them asked for smooth outlines in between: the same bits.
    const auto picturesOf = [](bool smooth) -> std::vector<QImage> {
        std::mutex mutex;
        std::vector<QImage> out;
        int smoothed = 0;
        ui::RenderThread thread(std::make_unique<render::CpuSplatter>(), [&](ui::RenderThread::Result result) {
            const std::lock_guard lock(mutex);
            if (result.smooth)
                ++smoothed;
            else
                out.push_back(result.picture);
        });
        ui::Editor editor({.keepJournal = false, .journal = {}, .historyBytes = 1 << 20});
        editor.run({{"op", "new"}, {"sample", "sphere"}, {"count", 3000}});
        (void)QTest::qWaitFor([&] { return !editor.busy(); }, test::patience);
        ui::Frame frame;
        frame.model = editor.snapshot().surface.tree();
        frame.camera = render::Camera::looking(frame.model.bounds(), 200, 150);
        frame.smooth = smooth;
        for (std::size_t k = 0; k < 3; ++k) {
            frame.camera.fovDeg = 35 + double(k);
            thread.request(frame);
            (void)QTest::qWaitFor(
                [&] {
                    const std::lock_guard lock(mutex);
                    return out.size() == k + 1 && (!smooth || smoothed == int(k) + 1);
                },
                test::patience);
        }
        const std::lock_guard lock(mutex);
        return out;
    };
    const auto plain = picturesOf(false), smooth = picturesOf(true);
    QCOMPARE(plain.size(), std::size_t(3));
    QVERIFY(plain == smooth);
}

static const test::Registered<RestTest> registered;
#include "rest_test.moc"
