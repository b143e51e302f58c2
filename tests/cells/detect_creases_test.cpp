// Creases in raw points: of solids of planes every face is a cell, with and without noise, whatever the normals beside
// the edges; smooth surfaces have none, and what nobody can tell is refused or left smooth.
#include "core/cells/creases/detect_creases.h"

#include "cells/solids.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cells/seams.h"
#include "support/registry.h"

#include <map>
#include <QTest>
#include <set>

using namespace plane_solids;
using base::Random;
using cells::Label;
using cells::LabelLayout;
using cells::Meeting;

class DetectCreasesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void facesOfSolidsAreCells_data();
    void facesOfSolidsAreCells();
    void smoothSurfacesStay_data();
    void smoothSurfacesStay();
    void grainIsRefused();
    void sidesAreNeeded();
    void narrowStripsStaySmooth();
    void stripsOfThreeSpacingsAreCells();
    void bitsAreThoseOfOneThread();
    void cleanup() { base::setThreadCount(0); }
};

namespace {

constexpr double spacing = 0.1;

/// Without labels, moved by noise (spacings), normals turned at random by up to so many degrees.
surface::Surface rawPoints(const surfel::SurfelList& from, double noise, double degrees, Random& random) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    for (surfel::Surfel s : from.items) {
        const Vec3d off{random.normal(), random.normal(), random.normal()};
        s.position += base::cast<float>(off * (noise * spacing));
        const double turn = std::tan(degrees * pi / 180);
        s.normal = base::cast<float>(
            base::normalized(base::cast<double>(s.normal) + random.unitVector() * (turn * random.uniform())));
        out.append(s, {});
    }
    return surfaceOf(out);
}

surfel::SurfelList ball(double radius) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    const auto count = static_cast<int>(4 * pi * radius * radius / (spacing * spacing));
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2.0 * i + 1) / count, r = std::sqrt(1 - z * z), angle = i * pi * (3 - std::sqrt(5.0));
        const Vec3d n{r * std::cos(angle), r * std::sin(angle), z};
        surfel::Surfel s;
        s.position = base::cast<float>(n * radius);
        s.normal = base::cast<float>(n);
        s.support = static_cast<float>(3.5 * spacing);
        out.append(s, {});
    }
    return out;
}

template <class Fn>
void forLabels(const surface::Surface& surface, const Fn& fn) {
    const auto labels = LabelLayout::of(*surface.tree().layout());
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            fn(base::cast<double>(block.position(slot)), base::cast<double>(block.normal(slot)),
               labels ? labels->at(block, slot) : Label());
    });
}

} // namespace

void DetectCreasesTest::facesOfSolidsAreCells_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("noise");
    for (const double noise : {0.0, 0.1})
        for (const int kind : {0, 1, 2})
            QTest::addRow("%s, noise %g",
                          kind == 0   ? "cube"
                          : kind == 1 ? "L-block"
                                      : "pyramid",
                          noise)
                << kind << noise;
}

void DetectCreasesTest::facesOfSolidsAreCells() {
    QFETCH(int, kind);
    QFETCH(double, noise);
    Random random(test::seed());
    const Solid solid = kind == 0 ? cube(0.9) : kind == 1 ? lBlock(1) : pyramid(5, 1.2, 1.2);
    const SampledSolid s = sampled(solid, 3, spacing, random);
    const surface::Surface raw = rawPoints(s.surfels, noise, 30, random);
    const cells::DetectedCreases found = cells::detectCreases(raw);
    QVERIFY(found.found);
    QVERIFY(std::abs(found.noise - noise) < 0.04);
    QCOMPARE(found.surface.tree().size(), raw.tree().size());
    // of each surfel the face whose plane is nearest, of each cell the face that most of it lies on
    std::map<std::uint32_t, std::map<std::size_t, int>> faces;
    int beside = 0, far = 0, inverted = 0, all = 0, turned = 0;
    forLabels(found.surface, [&](const Vec3d& p, const Vec3d& n, const Label& label) {
        std::size_t best = 0;
        double second = 1e9;
        for (std::size_t i = 0; i < solid.planes.size(); ++i) {
            const double off = std::abs(solid.planes[i].f(p));
            if (off < std::abs(solid.planes[best].f(p)))
                best = i;
        }
        for (std::size_t i = 0; i < solid.planes.size(); ++i)
            if (i != best)
                second = std::min(second, std::abs(solid.planes[i].f(p)));
        ++faces[label.cell][best];
        ++all;
        if (label.meeting == Meeting::None)
            return;
        ++beside;
        far += second > 3 * spacing ? 1 : 0;
        turned += dot(n, solid.planes[best].n) < std::cos(10 * pi / 180) ? 1 : 0;
        inverted += label.meeting == (kind == 1 && best >= 6 ? Meeting::None : Meeting::Concave) && kind != 1 ? 1 : 0;
    });
    int wrong = 0;
    std::set<std::size_t> known;
    for (const auto& [cell, counts] : faces) {
        int most = 0, sum = 0;
        std::size_t face = 0;
        for (const auto& [each, count] : counts) {
            sum += count;
            if (count > most) {
                most = count;
                face = each;
            }
        }
        wrong += sum - most;
        known.insert(face);
    }
    const QByteArray told =
        QString("seed %1: %2 cells, %3 of %4 on another face, %5 beside, %6 far, %7 turned, %8 inverted")
            .arg(test::seed())
            .arg(faces.size())
            .arg(wrong)
            .arg(all)
            .arg(beside)
            .arg(far)
            .arg(turned)
            .arg(inverted)
            .toUtf8();
    // about the tip faces are narrower than what noise lets be told, and two may be one across it
    const bool narrow = kind == 2 && noise > 0;
    QVERIFY2(known.size() + (narrow ? 1 : 0) >= solid.planes.size(), told);
    QVERIFY2(faces.size() <= solid.planes.size() + (narrow ? 8 : 4), told);
    QVERIFY2(wrong <= all / (narrow ? 5 : noise > 0 ? 18 : 50), told);
    QVERIFY2(beside > 200 && far <= beside / 20 && turned <= beside / (noise > 0 ? 6 : 40), told);
    QVERIFY2(inverted <= beside / (kind == 2 ? 20 : 80), told);
}

void DetectCreasesTest::smoothSurfacesStay_data() {
    QTest::addColumn<double>("noise");
    QTest::newRow("exact") << 0.0;
    QTest::newRow("noisy") << 0.1;
}

void DetectCreasesTest::smoothSurfacesStay() {
    QFETCH(double, noise);
    Random random(test::seed());
    const surface::Surface raw = rawPoints(ball(1), noise, 0, random);
    const cells::DetectedCreases found = cells::detectCreases(raw);
    QVERIFY(!found.found);
    QVERIFY(found.surface.tree() == raw.tree());
}

void DetectCreasesTest::grainIsRefused() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(0.9), 3, spacing, random);
    QVERIFY_THROWS_EXCEPTION(base::Error,
                             static_cast<void>(cells::detectCreases(rawPoints(s.surfels, 0.6, 0, random))));
}

void DetectCreasesTest::sidesAreNeeded() {
    Random random(test::seed());
    surfel::SurfelList list = sampled(cube(0.9), 3, spacing, random).surfels;
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = false;
    list.layout = layout;
    QVERIFY_THROWS_EXCEPTION(base::Error, static_cast<void>(cells::detectCreases(surfaceOf(list))));
}

void DetectCreasesTest::narrowStripsStaySmooth() {
    // a wall of two spacings: its rim is no face of its own
    Random random(test::seed());
    const double half = spacing;
    const Solid plate = intersection(
        {{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, half}, {{0, 0, -1}, half}});
    const SampledSolid s = sampled(plate, 3, spacing, random);
    const cells::DetectedCreases found = cells::detectCreases(rawPoints(s.surfels, 0, 0, random));
    forLabels(found.surface, [&](const Vec3d& p, const Vec3d&, const Label& label) {
        QVERIFY(label.meeting == Meeting::None || std::max(std::abs(p.x), std::abs(p.y)) > 0.5);
    });
}

/// The rim of a plate of 3.2 spacings, all of whose surfels have links over its edges.
void DetectCreasesTest::stripsOfThreeSpacingsAreCells() {
    Random random(test::seed());
    constexpr double half = 1.6 * spacing;
    const Solid plate = intersection(
        {{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}, {{0, 0, 1}, half}, {{0, 0, -1}, half}});
    int found = 0, all = 0;
    for (int round = 0; round < test::effort(4); ++round) {
        const SampledSolid s = sampled(plate, 3, spacing, random, 0.4);
        forLabels(cells::detectCreases(rawPoints(s.surfels, 0, 0, random)).surface,
                  [&](const Vec3d& p, const Vec3d&, const Label& label) {
                      if (std::max(std::abs(p.x), std::abs(p.y)) > 1 - 0.7 * spacing) {
                          ++all;
                          found += label.meeting != Meeting::None;
                      }
                  });
    }
    QVERIFY2(20 * found > 19 * all, qPrintable(QString("seed %1: %2 of %3").arg(test::seed()).arg(found).arg(all)));
}

void DetectCreasesTest::bitsAreThoseOfOneThread() {
    Random random(test::seed());
    const surface::Surface raw = rawPoints(sampled(lBlock(1), 3, spacing, random).surfels, 0.1, 20, random);
    const cells::DetectedCreases many = cells::detectCreases(raw);
    base::setThreadCount(1);
    const cells::DetectedCreases one = cells::detectCreases(raw);
    QVERIFY(one.surface.tree().contentHash() == many.surface.tree().contentHash());
}

static const test::Registered<DetectCreasesTest> registered;
#include "detect_creases_test.moc"
