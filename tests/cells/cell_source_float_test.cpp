// The cells around a place in float32: what float64 says, whatever was asked before.
#include "core/cells/cell_source_float.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using base::Random, base::Vec3d;
using cells::CellSource, cells::CellSourcef, cells::CellSurface;
using surface::Need;

class CellSourceFloatTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void saysWhatDoubleSays_data();
    void saysWhatDoubleSays();
    void forgetsThePlacesBefore();
};

namespace {

constexpr double spacing = 0.1, support = 3.5 * spacing;

/// A solid of planes. Faded: its creases are of any sharpness, and its cells of one face or of two.
CellSurface solidOf(Random& random, bool faded, bool shaped = false) {
    plane_solids::SampledSolid s = plane_solids::sampled(plane_solids::polyhedron(random), 2.4, spacing, random);
    if (faded) {
        const cells::LabelLayout layout = *cells::LabelLayout::of(*s.surfels.layout);
        std::vector<cells::Label> labels;
        for (std::size_t i = 0; i < s.surfels.size(); ++i) {
            labels.push_back(layout.at(s.surfels.extraOf(i)));
            labels.back().sharpness = static_cast<std::uint8_t>(random.below(256));
            labels.back().face = labels.back().cell % 2;
        }
        cells::setLabels(s.surfels, labels, true);
    }
    return plane_solids::cellsOf(shaped ? shapes::ellipsoids(s.surfels, 2, test::seed()) : s.surfels);
}

Vec3d placeNear(const CellSurface& surface, Random& random) {
    const surfel::SurfelList all = surface.surface().tree().surfels();
    const surfel::Surfel& any = all.items[random.below(all.size())];
    return base::cast<double>(any.position) + random.unitVector() * (spacing * random.uniform(0, 2));
}

} // namespace

void CellSourceFloatTest::saysWhatDoubleSays_data() {
    QTest::addColumn<bool>("faded");
    QTest::addColumn<bool>("shaped");
    QTest::newRow("sharp") << false << false;
    QTest::newRow("faded") << true << false;
    QTest::newRow("sharp ellipsoids") << false << true;
    QTest::newRow("faded ellipsoids") << true << true;
}

void CellSourceFloatTest::saysWhatDoubleSays() {
    QFETCH(bool, faded);
    QFETCH(bool, shaped);
    Random random(test::seed());
    const CellSurface surface = solidOf(random, faded, shaped);
    CellSource exact(surface);
    CellSourcef quick(surface);
    quick.setScale(support);
    // Shares of creases that fade are quotients: where next to nothing of their surfels is in support, float32 has
    // none.
    int compared = 0, meetings = 0, differing = 0;
    const auto alike = [&](bool close) {
        differing += close ? 0 : 1;
        return close || faded;
    };
    for (int k = 0; k < 400; ++k) {
        const Vec3d x = base::cast<double>(base::cast<float>(placeNear(surface, random)));
        exact.moveTo(x);
        quick.moveTo(x);
        const QByteArray where = QString("seed %1, place %2").arg(test::seed()).arg(k).toUtf8();
        QVERIFY2(exact.alone() == quick.alone(), where);
        for (std::size_t i = 0; i < exact.count(); ++i) {
            const std::size_t j = quick.find(exact.cell(i));
            QVERIFY2(j != CellSourcef::none, where);
            const surface::Evaluationd& a = exact.at(i, Need::Gradient);
            const cells::CellField b = quick.at(j, Need::Gradient);
            if (a.samples > 6 && cells::valid(a) && a.weight > 0.01) { // both decide alike where little is known
                ++compared;
                QVERIFY2(alike(cells::valid(b) && std::abs(a.value - b.value) < 2e-5 * support &&
                               length(a.gradient - b.gradient) < 1e-2 &&
                               std::abs(a.offCentre - b.offCentre) < 1e-4 * support),
                         where);
            }
            for (std::size_t l = 0; l < exact.count(); ++l) {
                const std::size_t m = quick.find(exact.cell(l));
                if (l == i)
                    continue;
                QVERIFY2(exact.meeting(i, l) == quick.meeting(j, m), where);
                QVERIFY2(alike(std::abs(exact.sharpness(i, l) - quick.sharpness(j, m)) < 1e-3), where);
                QVERIFY2(exact.reaches(l) == quick.reaches(m), where);
                meetings += exact.meeting(i, l) != cells::Meeting::None ? 1 : 0;
            }
        }
    }
    QVERIFY(compared > 300 && meetings > 100);
    QVERIFY2(20 * differing <= compared, qPrintable(QString("%1 of %2").arg(differing).arg(compared)));
}

void CellSourceFloatTest::forgetsThePlacesBefore() {
    Random random(test::seed());
    const CellSurface surface = solidOf(random, true);
    CellSourcef used(surface);
    for (int k = 0; k < 600; ++k) { // more places than are kept
        const Vec3d x = placeNear(surface, random);
        const double scale = support * random.uniform(0.3, 3);
        CellSourcef fresh(surface);
        for (CellSourcef* source : {&fresh, &used}) {
            source->setScale(scale);
            source->moveTo(x);
        }
        QCOMPARE(fresh.count(), used.count());
        for (std::size_t i = 0; i < fresh.count(); ++i) {
            const cells::CellField a = fresh.at(i, Need::Gradient), b = used.at(i, Need::Gradient);
            QVERIFY2(cells::valid(a) == cells::valid(b) &&
                         (!cells::valid(a) || (a.value == b.value && a.gradient == b.gradient)),
                     QString("seed %1, place %2").arg(test::seed()).arg(k).toUtf8());
        }
    }
}

static const test::Registered<CellSourceFloatTest> registered;
#include "cell_source_float_test.moc"
#include "surface/ellipsoids.h"
