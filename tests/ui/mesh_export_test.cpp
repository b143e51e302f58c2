// Mesh export in the window: an estimate at once, a preview that follows model and view, files that can be read back.
#include "core/io/formats.h"
#include "core/io/mesh_formats.h"
#include "support/patience.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "ui/window/mesh_export.h"
#include "window_fixture.h"

using test::WindowFixture;

class MeshExportTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void previewShowsTheMeshOfTheModel();
    void estimateIsNearTheMesh_data();
    void estimateIsNearTheMesh();
    void everyFormatIsWritten();
    void newerWishReplacesTheOlder();
    void previewWaitsForAFile();
};

namespace {

struct Fixture : WindowFixture {
    ui::MeshExport& mesh() { return window->meshExport(); }
    void open() { action("file", "Export Mesh…")->trigger(); }
    bool made() {
        return QTest::qWaitFor(
            [this] {
                const auto& made = mesh().mesher().made();
                return made && made->model == editor().snapshot().surface.tree() &&
                       made->choice.sameMesh(mesh().bar().choice()) && !mesh().mesher().busy();
            },
            test::patience);
    }
    QImage picture() { return view().grab().toImage(); }
};

int differing(const QImage& a, const QImage& b) {
    int out = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            out += a.pixel(x, y) != b.pixel(x, y);
    return out;
}

} // namespace

void MeshExportTest::previewShowsTheMeshOfTheModel() {
    Fixture f;
    QVERIFY(f.make("sphere", 3000));
    f.open();
    QVERIFY(f.mesh().bar().text().startsWith("about "));
    QVERIFY(f.made());
    QVERIFY(QTest::qWaitFor(
        [&] { return f.mesh().bar().text().contains(" triangles") && !f.mesh().bar().text().contains("about"); },
        test::patience));
    QTest::qWait(300); // the lines have their own thread
    const QImage with = f.picture();
    f.mesh().bar().findChild<QWidget*>("mesh-preview")->setProperty("checked", false);
    QTest::qWait(50);
    QVERIFY(differing(with, f.picture()) > 5000);
    f.mesh().bar().findChild<QWidget*>("mesh-preview")->setProperty("checked", true);
    f.drag(f.centre(), f.centre() + QPointF(30, 0)); // another model
    QVERIFY(f.made());
}

void MeshExportTest::estimateIsNearTheMesh_data() {
    QTest::addColumn<QString>("sample");
    QTest::addColumn<double>("cell");
    QTest::addColumn<bool>("delaunay");
    QTest::newRow("sphere, Delaunay") << "sphere" << 1.5 << true;
    QTest::newRow("torus, Delaunay") << "torus" << 1.0 << true;
    for (const char* sample : {"sphere", "torus", "knot"})
        for (const double cell : {0.7, 1.0, 2.0})
            QTest::newRow(qPrintable(QString("%1 %2").arg(sample).arg(cell))) << sample << cell << false;
}

void MeshExportTest::estimateIsNearTheMesh() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    QFETCH(const QString, sample);
    QFETCH(const double, cell);
    QFETCH(const bool, delaunay);
    Fixture f;
    QVERIFY(f.make(sample.toUtf8(), 6000));
    const ui::Snapshot& now = f.editor().snapshot();
    ui::MeshChoice choice;
    choice.cell = cell;
    choice.delaunay = delaunay;
    const auto spacing = static_cast<double>(now.spacing);
    const double estimate =
        static_cast<double>(ui::estimatedTriangles(ui::estimatedArea(now.surface.tree(), spacing), spacing, choice));
    f.mesh().mesher().want(choice, now);
    QVERIFY(QTest::qWaitFor([&] { return f.mesh().mesher().made() != nullptr; }, test::patience));
    const double ratio = estimate / static_cast<double>(f.mesh().mesher().made()->mesh->triangles.size());
    QVERIFY2(ratio > 0.75 && ratio < 1.33, qPrintable(QString::number(ratio)));
}

void MeshExportTest::everyFormatIsWritten() {
    Fixture f;
    QVERIFY(f.make("sphere", 2000));
    f.open();
    for (const io::MeshFormatRow& row : io::meshFormatTable()) {
        const QString path = f.file(qPrintable(QString("ball.%1").arg(row.id)));
        QString written;
        connect(&f.mesh().mesher(), &ui::Mesher::saved, this, [&](const QString& name) { written = name; });
        f.mesh().save(path.toStdString());
        QVERIFY(QTest::qWaitFor([&] { return written == path && !f.mesh().mesher().busy(); }, test::patience));
        const io::FileModel back = io::read(path.toStdString());
        QCOMPARE(back.points.items.size(), f.mesh().mesher().made()->mesh->positions.size());
        f.mesh().mesher().disconnect(this);
    }
}

void MeshExportTest::newerWishReplacesTheOlder() {
    Fixture f;
    QVERIFY(f.make("sphere", 20000));
    ui::MeshChoice fine, coarse;
    fine.cell = 0.5, coarse.cell = 4;
    f.mesh().mesher().want(fine, f.editor().snapshot());
    f.mesh().mesher().want(coarse, f.editor().snapshot());
    QVERIFY(QTest::qWaitFor([&] { return !f.mesh().mesher().busy() && f.mesh().mesher().made(); }, test::patience));
    QVERIFY(QTest::qWaitFor([&] { return f.mesh().mesher().made()->choice.sameMesh(coarse); }, test::patience));
}

void MeshExportTest::previewWaitsForAFile() {
    Fixture f;
    QVERIFY(f.make("sphere", 20000));
    ui::Mesher& mesher = f.mesh().mesher();
    QString written, failure;
    connect(&mesher, &ui::Mesher::saved, this, [&](const QString& name) { written = name; });
    connect(&mesher, &ui::Mesher::failed, this, [&](const QString& why) { failure = why; });
    ui::MeshChoice fine, coarse;
    fine.cell = 0.5, coarse.cell = 4;
    const QString path = f.file("fine.ply");
    mesher.save(fine, f.editor().snapshot(), path.toStdString());
    mesher.want(coarse, f.editor().snapshot());
    mesher.save(coarse, f.editor().snapshot(), f.file("other.ply").toStdString());
    QVERIFY(failure.contains("being written"));
    QVERIFY(QTest::qWaitFor([&] { return written == path; }, test::patience));
    QVERIFY(QTest::qWaitFor([&] { return mesher.made()->choice.sameMesh(coarse); }, test::patience));
    mesher.disconnect(this);
}

static const test::Registered<MeshExportTest> registered;
#include "mesh_export_test.moc"
