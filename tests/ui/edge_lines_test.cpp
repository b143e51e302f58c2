// Sharp edges over the picture: there where asked for, of the model as it is, gone with the switch.
#include "core/cells/seam_lines.h"

#include "support/registry.h"
#include "window_fixture.h"

#include <QPainter>

using test::WindowFixture;

class EdgeLinesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linesFollowTheModel();
};

static QImage overlayOf(WindowFixture& f) {
    QImage out(f.view().size() * f.view().devicePixelRatioF(), QImage::Format_ARGB32_Premultiplied);
    out.fill(Qt::transparent);
    QPainter painter(&out);
    f.window->sculptView().overlay().paint(painter, f.view().devicePixelRatioF());
    return out;
}

void EdgeLinesTest::linesFollowTheModel() {
    WindowFixture f;
    QVERIFY(f.make("octant", 1500));
    const ui::EdgeLines& lines = f.window->sculptView().edges();
    QCOMPARE(lines.count(), std::size_t(0));
    QAction* edges = nullptr;
    for (QAction* action : f.window->menu("around")->actions())
        edges = action->data().toString() == "edges" ? action : edges;
    QVERIFY(edges && edges->isCheckable() && !edges->isChecked());
    const QImage without = overlayOf(f);
    edges->trigger();
    QVERIFY(QTest::qWaitFor([&] { return lines.count() == 6; }, test::patience));
    QVERIFY(overlayOf(f) != without);
    double seen = 0, all = 0; // what the body hides is not drawn
    const render::Camera camera = f.window->sculptView().motion().shownCamera();
    for (const surface::SectionCurve& part : lines.visible(camera))
        seen += part.length();
    for (const cells::SeamLine& line : cells::seamLines(f.editor().snapshot().surface))
        all += line.length();
    QVERIFY2(seen > 0.3 * all && seen < 0.9 * all, qPrintable(QString("%1 of %2").arg(seen).arg(all)));
    QVERIFY(f.make("sphere", 1500)); // which has none
    QVERIFY(QTest::qWaitFor([&] { return lines.count() == 0; }, test::patience));
    QVERIFY(f.make("icosahedron", 1500));
    QVERIFY(QTest::qWaitFor([&] { return lines.count() == 30; }, test::patience));
    edges->trigger();
    QCOMPARE(lines.count(), std::size_t(0));
}

static const test::Registered<EdgeLinesTest> registered;
#include "edge_lines_test.moc"
