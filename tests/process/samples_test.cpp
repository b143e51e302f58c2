#include "core/process/samples/samples.h"

#include "core/base/box.h"
#include "core/base/error.h"
#include "core/process/estimation/spacing.h"
#include "support/registry.h"

#include <QTest>

using namespace process;

class SamplesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everySampleHasTheCountAskedForAndUnitSize_data();
    void everySampleHasTheCountAskedForAndUnitSize();
    void sameParametersGiveTheSameBits();
    void evenSamplesKeepTheirSpacing_data();
    void evenSamplesKeepTheirSpacing();
    void normalsAreExact();
    void normalsPointOutward();
    void unknownNamesAreRefusedWithTheKnownOnes();
};

void SamplesTest::everySampleHasTheCountAskedForAndUnitSize_data() {
    QTest::addColumn<QString>("id");
    for (const SampleRow& row : sampleTable())
        QTest::newRow(row.id) << row.id;
}

void SamplesTest::everySampleHasTheCountAskedForAndUnitSize() {
    QFETCH(QString, id);
    const SampleRow& row = sample(id.toStdString());
    for (const std::size_t count : {std::size_t{1000}, std::size_t{7777}, row.count}) {
        const surfel::SurfelList list = row.make(count, 1);
        if (row.manifold == surface::Manifold::Complex) { // whole rows of points across whole faces
            QVERIFY2(list.size() > count * 3 / 4 && list.size() < count * 4 / 3,
                     qPrintable(QString("%1 for %2").arg(list.size()).arg(count)));
            continue;
        }
        QCOMPARE(list.size(), count);
        base::Box3f box;
        for (const auto& s : list.items) {
            QVERIFY(base::isFinite(s.position));
            box.extend(s.position);
        }
        QVERIFY2(length(box.centre()) < 0.2f, qPrintable(QString::number(length(box.centre()))));
        const float longest = std::max({box.size().x, box.size().y, box.size().z});
        QVERIFY2(longest > 1.5f && longest < 2.1f, qPrintable(QString::number(longest)));
    }
}

void SamplesTest::sameParametersGiveTheSameBits() {
    for (const SampleRow& row : sampleTable()) {
        const auto a = row.make(3000, 7), b = row.make(3000, 7);
        QVERIFY2(a.items == b.items, row.id);
    }
}

void SamplesTest::evenSamplesKeepTheirSpacing_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<int>("count");
    for (const SampleRow& row : sampleTable())
        if (std::string_view(row.id) != "scan" && std::string_view(row.id) != "moebius" && // layers, a rim
            row.manifold != surface::Manifold::Complex)
            for (const int count : {1000, 5000, 40000, 200000})
                QTest::addRow("%s %d", row.id, count) << QString(row.id) << count;
}

void SamplesTest::evenSamplesKeepTheirSpacing() {
    QFETCH(QString, id);
    QFETCH(int, count);
    const auto list = sample(id.toStdString()).make(static_cast<std::size_t>(count), 1);
    std::vector<float> s = spacings(list.items);
    const Summary all = summarise(s);
    std::sort(s.begin(), s.end());
    const auto text =
        qPrintable(QString("%1: %2 %3 of median").arg(id).arg(all.min / all.median).arg(all.max / all.median));
    QVERIFY2(all.min > 0.7f * all.median && all.max < 1.3f * all.median, text);
    QVERIFY2(s[s.size() / 50] > 0.9f * all.median && s[s.size() * 49 / 50] < 1.1f * all.median, text);
}

void SamplesTest::normalsAreExact() {
    for (const auto& s : sample("sphere").make(5000, 1).items) {
        QVERIFY(std::abs(length(s.position) - 1) < 1e-6f);
        QVERIFY(distance(s.normal, normalized(s.position)) < 1e-6f);
    }
    for (const auto& s : sample("torus").make(5000, 1).items) {
        const base::Vec3d p = base::cast<double>(s.position);
        const base::Vec3d ring = base::normalized(base::Vec3d{p.x, 0, p.z}) * 0.7, out = p - ring;
        QVERIFY(std::abs(base::length(out) - 0.3) < 1e-6);
        QVERIFY(base::distance(base::normalized(out), base::cast<double>(s.normal)) < 1e-6);
    }
    for (const SampleRow& row : sampleTable())
        if (const auto list = row.make(2000, 1); list.layout->normals)
            for (const auto& s : list.items) // points of curves and corners have none
                QVERIFY2(std::abs(length(s.normal) - 1) < 1e-6f ||
                             (row.manifold == surface::Manifold::Complex && s.normal == base::Vec3f{}),
                         row.id);
}

/// The flux of the position through a closed surface is three times its volume: positive for outward normals, and
/// the flux of a constant field is zero when normals and areas belong together.
void SamplesTest::normalsPointOutward() {
    for (const SampleRow& row : sampleTable()) {
        if (row.manifold == surface::Manifold::Complex)
            continue; // open, or in unlike parts
        const auto list = row.make(20000, 1);
        if (!list.layout->normals)
            continue;
        QVERIFY(list.layout->oriented);
        double volume = 0;
        base::Vec3d sum;
        for (const auto& s : list.items) {
            volume += static_cast<double>(dot(s.position, s.normal));
            sum += base::cast<double>(s.normal);
        }
        const double n = static_cast<double>(list.size());
        QVERIFY2(volume > 0.05 * n, row.id);
        QVERIFY2(length(sum) < 0.01 * n, qPrintable(QString("%1 %2").arg(row.id).arg(length(sum) / n)));
    }
}

void SamplesTest::unknownNamesAreRefusedWithTheKnownOnes() {
    try {
        sample("teapot");
        QFAIL("no error");
    } catch (const base::Error& e) {
        QVERIFY(e.message().find("teapot") != std::string::npos && e.message().find("sphere") != std::string::npos);
    }
}

static const test::Registered<SamplesTest> registered;
#include "samples_test.moc"
