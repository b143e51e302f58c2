// The naive loader brings the same points, the naive way to open them about the same supports; the program draws.
#include "app/bench/scan_file.h"
#include "app/bench/start_workload.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/process/estimation/prepare.h"
#include "support/registry.h"

#include <QTemporaryDir>
#include <QTest>

using bench::Scene, bench::ScanFile;
using surfel::Surfel;

class NaiveFileTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void loadedPointsAreOurs();
    void openedSupportsAreOurs();
    void estimatedNormalsAreOurs();
    void filesGoAway();
    void theProgramDrawsAFrame();
};

void NaiveFileTest::loadedPointsAreOurs() {
    Scene scene({3000, 0.02});
    const ScanFile file(scene);
    const std::vector<Surfel> naive = bench::naiveLoad(*file);
    const io::FileModel ours = io::read(file->path);
    QCOMPARE(naive.size(), scene.size());
    QCOMPARE(ours.points.size(), scene.size());
    for (std::size_t i = 0; i < naive.size(); ++i) {
        QVERIFY(naive[i].position == ours.points.items[i].position && naive[i].colour == ours.points.items[i].colour);
        QVERIFY(length(naive[i].normal - ours.points.items[i].normal) < 1e-5f);
    }
}

void NaiveFileTest::openedSupportsAreOurs() {
    Scene scene({3000, 0.02});
    const ScanFile file(scene);
    const std::vector<Surfel> naive = bench::naiveOpen(*file, surface::SurfaceDefinition().neighbours);
    const surface::Surface ours = process::prepare(io::read(file->path).points, {{}, false});
    QCOMPARE(naive.size(), ours.tree().size());
    std::vector<tree::Neighbour> found;
    for (const Surfel& s : naive) {
        ours.tree().nearest(s.position, 1, found);
        QCOMPARE(found[0].distanceSq, 0.0f);
        const float support = found[0].block->support(found[0].slot);
        QVERIFY2(std::abs(s.support - support) < 0.15f * support, // grading evens them out
                 qPrintable(QString("%1 %2").arg(s.support).arg(support)));
    }
}

void NaiveFileTest::estimatedNormalsAreOurs() {
    Scene scene({3000, 0.02});
    const ScanFile file(scene, ScanFile::Normals::Without);
    const std::vector<Surfel> naive = bench::naiveOpenRaw(*file, surface::SurfaceDefinition().neighbours);
    const surface::Surface ours = process::prepare(io::read(file->path).points, {{}, false});
    QCOMPARE(naive.size(), ours.tree().size());
    std::vector<tree::Neighbour> found;
    for (const Surfel& s : naive) {
        ours.tree().nearest(s.position, 1, found);
        QCOMPARE(found[0].distanceSq, 0.0f);
        const base::Vec3f normal = found[0].block->normal(found[0].slot); // of weighted neighbours
        QVERIFY2(dot(s.normal, normal) > 0.99f, qPrintable(QString::number(dot(s.normal, normal))));
    }
}

void NaiveFileTest::filesGoAway() {
    Scene scene({500, 0});
    std::filesystem::path path;
    {
        const ScanFile file(scene);
        path = file->path;
        QVERIFY(std::filesystem::exists(path));
    }
    QVERIFY(!std::filesystem::exists(path));
}

void NaiveFileTest::theProgramDrawsAFrame() {
    const QTemporaryDir folder;
    const std::filesystem::path picture = folder.filePath("frame.png").toStdString();
    bench::startAndDraw(qEnvironmentVariable("POINTCLAY_PROGRAM").toStdString(), picture);
    QVERIFY(std::filesystem::file_size(picture) > 1000);
    QVERIFY_EXCEPTION_THROWN(bench::startAndDraw("/bin/false", picture), base::Error);
}

static const test::Registered<NaiveFileTest> registered;
#include "naive_file_test.moc"
