// Reduced scans: figures of reduce/README 8 with slack, and models of every other kind.
#include "core/io/formats.h"
#include "core/reduce/reduce.h"
#include "reduce/reduced_models.h"
#include "support/registry.h"

#include <QTest>

using namespace reduce;

class ScansTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aTenthIsNearlyTheSameSurface_data();
    void aTenthIsNearlyTheSameSurface();
};

void ScansTest::aTenthIsNearlyTheSameSurface_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("surf"); // % of the diagonal, rms between the two surfaces
    QTest::newRow("kitten") << "kitten.xyz" << 0.012;
    QTest::newRow("bunny") << "bunny/bun_zipper.ply" << 0.007;
}

void ScansTest::aTenthIsNearlyTheSameSurface() {
    QFETCH(QString, file);
    QFETCH(double, surf);
    const std::string folder = test::dataFolder();
    if (folder.empty())
        QSKIP("POINTCLAY_DATA is not set");
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("minutes under a sanitizer");
#endif
    const io::FileModel model = io::read(folder + "/" + file.toStdString());
    const surface::Surface dense = process::prepare(model.points, {});
    const Reduced result = reduceByRatio(dense, 0.1);
    const double percent = 100 / double(dense.tree().bounds().diagonal());
    const QByteArray told = QString("%1 surf %2 %, raw %3 % (itself %4 %), normals %5, least %6, holes %7")
                                .arg(file)
                                .arg(percent * result.report.surfaceRms)
                                .arg(percent * result.report.rms)
                                .arg(percent * result.report.denseRms)
                                .arg(result.report.normalsDeg)
                                .arg(result.report.leastSupports)
                                .arg(result.report.holes)
                                .toUtf8();
    qInfo("%s", told.constData());
    QVERIFY2(percent * result.report.surfaceRms < surf, told);
    QVERIFY2(result.report.holes == 0 && result.report.leastSupports >= 3, told);
    QVERIFY2(result.report.rms < 1.15 * result.report.denseRms, told);
}

static const test::Registered<ScansTest> registered;
#include "scans_test.moc"
