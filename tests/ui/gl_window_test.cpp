// The window with OpenGL: needs an X server, for example
//     QT_QPA_PLATFORM=xcb POINTCLAY_RENDERER=gl xvfb-run -a ui_tests GlWindowTest
#include "support/patience.h"
#include "support/registry.h"
#include "ui/viewport/gl_viewport.h"
#include "window_fixture.h"

#include <QGuiApplication>

using test::WindowFixture;

/// POINTCLAY_RENDERER=gl for as long as it lives.
class AskedForGl {
  public:
    AskedForGl() { qputenv("POINTCLAY_RENDERER", "gl"); }
    ~AskedForGl() { qunsetenv("POINTCLAY_RENDERER"); }
};

/// Every function has a fresh window that is on the screen, or is skipped.
class GlWindowTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void init();
    void cleanup();
    void glDrawsWhatTheCpuDraws();
    void strokesReachThePicture();
    void overlayIsLeftOutOfPictures();

  private:
    bool show();
    QImage picture() { return m_fixture->window->viewport().picture(); }

    AskedForGl m_asked;
    std::unique_ptr<WindowFixture> m_fixture;
};

class GlRefusalTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void platformsWithoutGlAreRefused();
};

void GlWindowTest::init() {
    QString why;
    if (!ui::glUsable(true, why))
        QSKIP(qPrintable("needs an X server with OpenGL 3.3, QT_QPA_PLATFORM=xcb under xvfb-run: " + why));
    m_fixture = std::make_unique<WindowFixture>();
    QVERIFY(dynamic_cast<ui::GlViewport*>(&m_fixture->window->viewport()));
    QVERIFY(QTest::qWaitForWindowExposed(m_fixture->window.get()));
}

void GlWindowTest::cleanup() {
    m_fixture.reset();
}

/// Waits for a frame.
bool GlWindowTest::show() {
    ui::Viewport& viewport = m_fixture->window->viewport();
    bool painted = false;
    viewport.framePainted = [&](double) { painted = true; };
    m_fixture->window->sculptView().refresh();
    const bool done = QTest::qWaitFor([&] { return painted; }, test::patience);
    viewport.framePainted = nullptr;
    return done;
}

static double meanDifference(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
        }
    return sum / (3.0 * a.width() * a.height());
}

void GlWindowTest::glDrawsWhatTheCpuDraws() {
    QVERIFY(m_fixture->make("torus", 20000));
    QVERIFY(show());
    const QImage gl = picture();
    m_fixture->window->images().write(m_fixture->file("cpu.png").toStdString()); // by the CPU renderer
    QVERIFY(m_fixture->settle());
    const QImage cpu(m_fixture->file("cpu.png"));
    QCOMPARE(gl.size(), cpu.size());
    const double difference = meanDifference(gl, cpu);
    QVERIFY2(difference < 1, qPrintable(QString::number(difference)));
}

void GlWindowTest::strokesReachThePicture() {
    WindowFixture& f = *m_fixture;
    QVERIFY(f.make("sphere", 20000));
    QVERIFY(show());
    const QImage before = picture();
    f.drag(f.centre(), f.centre() + QPointF(60, 0));
    QVERIFY(f.editor().snapshot().canUndo);
    QVERIFY(show());
    QVERIFY(meanDifference(before, picture()) > 0.05);
    f.window->undo();
    QVERIFY(f.settle());
    QVERIFY(show());
    QCOMPARE(picture(), before);
}

void GlWindowTest::overlayIsLeftOutOfPictures() {
    WindowFixture& f = *m_fixture;
    QVERIFY(f.make("sphere", 20000));
    QVERIFY(show());
    const QImage plain = picture();
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    QVERIFY(f.window->sculptView().cursor().contact);
    QCOMPARE(picture(), plain);
}

void GlRefusalTest::platformsWithoutGlAreRefused() {
    if (QGuiApplication::platformName() != "offscreen")
        QSKIP("needs the offscreen platform, which a GL widget would crash");
    const AskedForGl asked;
    QString why;
    QVERIFY(!ui::glUsable(true, why));
    QVERIFY(why.contains("offscreen"));
    WindowFixture f;
    QVERIFY(!dynamic_cast<ui::GlViewport*>(&f.window->viewport()));
}

static const test::Registered<GlWindowTest> registered;
static const test::Registered<GlRefusalTest> registeredRefusal;
#include "gl_window_test.moc"
