// The window with OpenGL: needs an X server, for example
//     QT_QPA_PLATFORM=xcb POINTCLAY_RENDERER=gl xvfb-run -a ui_tests GlWindowTest
#include "support/registry.h"
#include "ui/gl_viewport.h"
#include "window_fixture.h"

#include <QGuiApplication>

using test::WindowFixture;

class GlWindowTest : public QObject {
    Q_OBJECT
  private slots:
    void initTestCase();
    void glDrawsWhatTheCpuDraws();
    void strokesReachThePicture();
    void overlayIsLeftOutOfPictures();
    void platformsWithoutGlAreRefused();

  private:
    bool m_usable = false;
};

void GlWindowTest::initTestCase() {
    qputenv("POINTCLAY_RENDERER", "gl");
    QString why;
    m_usable = ui::glUsable(true, why);
    if (!m_usable)
        qInfo("no OpenGL here: %s", qPrintable(why));
}

static bool show(WindowFixture& f) {
    bool painted = false;
    f.window->viewport().framePainted = [&](double) { painted = true; };
    f.window->controller().refresh();
    const bool done = QTest::qWaitFor([&] { return painted; }, 60000);
    f.window->viewport().framePainted = nullptr;
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
    if (!m_usable)
        QSKIP("needs an X server with OpenGL 3.3: QT_QPA_PLATFORM=xcb under xvfb-run");
    WindowFixture f;
    QVERIFY(dynamic_cast<ui::GlViewport*>(&f.window->viewport()));
    QVERIFY(QTest::qWaitForWindowExposed(f.window.get()));
    QVERIFY(f.make("torus", 20000));
    QVERIFY(show(f));
    const QImage gl = f.window->viewport().picture();
    f.window->files().writeImage(f.file("cpu.png").toStdString()); // by the CPU renderer
    QVERIFY(f.settle());
    const QImage cpu(f.file("cpu.png"));
    QCOMPARE(gl.size(), cpu.size());
    const double difference = meanDifference(gl, cpu);
    QVERIFY2(difference < 1, qPrintable(QString::number(difference)));
}

void GlWindowTest::strokesReachThePicture() {
    if (!m_usable)
        QSKIP("needs an X server with OpenGL 3.3: QT_QPA_PLATFORM=xcb under xvfb-run");
    WindowFixture f;
    QVERIFY(QTest::qWaitForWindowExposed(f.window.get()));
    QVERIFY(f.make("sphere", 20000));
    QVERIFY(show(f));
    const QImage before = f.window->viewport().picture();
    f.drag(f.centre(), f.centre() + QPointF(60, 0));
    QVERIFY(f.editor().snapshot().canUndo);
    QVERIFY(show(f));
    QVERIFY(meanDifference(before, f.window->viewport().picture()) > 0.05);
    f.window->undo();
    QVERIFY(f.settle());
    QVERIFY(show(f));
    QCOMPARE(f.window->viewport().picture(), before);
}

void GlWindowTest::overlayIsLeftOutOfPictures() {
    if (!m_usable)
        QSKIP("needs an X server with OpenGL 3.3: QT_QPA_PLATFORM=xcb under xvfb-run");
    WindowFixture f;
    QVERIFY(QTest::qWaitForWindowExposed(f.window.get()));
    QVERIFY(f.make("sphere", 20000));
    QVERIFY(show(f));
    const QImage plain = f.window->viewport().picture();
    test::sendMouse(f.view(), QEvent::MouseMove, f.centre(), Qt::NoButton);
    QVERIFY(f.window->controller().cursor().contact);
    QCOMPARE(f.window->viewport().picture(), plain);
}

void GlWindowTest::platformsWithoutGlAreRefused() {
    if (QGuiApplication::platformName() != "offscreen")
        QSKIP("needs the offscreen platform, which a GL widget would crash");
    QString why;
    QVERIFY(!ui::glUsable(true, why));
    QVERIFY(why.contains("offscreen"));
    WindowFixture f; // POINTCLAY_RENDERER=gl is set
    QVERIFY(!dynamic_cast<ui::GlViewport*>(&f.window->viewport()));
}

static const test::Registered<GlWindowTest> registered;
#include "gl_window_test.moc"
