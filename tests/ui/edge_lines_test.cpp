// Sharp edges over the picture: there where asked for, of the model as it is, gone with the switch.
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
    QVERIFY(lines.curves().empty());
    QAction* edges = nullptr;
    for (QAction* action : f.window->menu("around")->actions())
        edges = action->data().toString() == "edges" ? action : edges;
    QVERIFY(edges && edges->isCheckable() && !edges->isChecked());
    const QImage without = overlayOf(f);
    edges->trigger();
    QVERIFY(QTest::qWaitFor([&] { return lines.curves().size() == 6; }, test::patience));
    QVERIFY(overlayOf(f) != without);
    QVERIFY(f.make("sphere", 1500)); // which has none
    QVERIFY(QTest::qWaitFor([&] { return lines.curves().empty(); }, test::patience));
    QVERIFY(f.make("icosahedron", 1500));
    QVERIFY(QTest::qWaitFor([&] { return lines.curves().size() == 30; }, test::patience));
    edges->trigger();
    QVERIFY(lines.curves().empty());
}

static const test::Registered<EdgeLinesTest> registered;
#include "edge_lines_test.moc"
