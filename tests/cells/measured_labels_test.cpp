// Labels after an edit: nothing new where nothing moved; what was bent the other way is concave; cells that go on into
// one another all along are one.
#include "core/cells/flat_pairs.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using cells::Label;
using cells::LabelLayout;
using cells::Meeting;

class MeasuredLabelsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void creasesAreFoundWhereTheyWere_data();
    void creasesAreFoundWhereTheyWere();
    void bentTheOtherWayTheSignTurns_data();
    void bentTheOtherWayTheSignTurns();
    void cellsThatHaveBecomeFlatAreOne_data();
    void cellsThatHaveBecomeFlatAreOne();
    void flatCreasesWithinAFaceStay();
    void wallsThatComeNearDoNotMeet();
    void nothingChangesElsewhere();
};

namespace {

constexpr double spacing = 0.1;

std::vector<cells::EditedBall> everywhere() {
    return {{{}, 10.0f}};
}

/// Labels by position, of all surfels of a version.
template <class Fn>
void forLabels(const tree::SurfelTree& tree, const Fn& fn) {
    const LabelLayout labels = *LabelLayout::of(*tree.layout());
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            fn(number, slot, base::cast<double>(block.position(slot)), labels.at(block, slot));
    });
}

/// Two planes through the y axis, rising by so many degrees to both sides of it, normals up.
SampledSolid roof(double degrees, Random& random) {
    const double a = degrees * pi / 180;
    std::vector<Plane> planes{{{-std::sin(a), 0, std::cos(a)}, 0}, {{std::sin(a), 0, std::cos(a)}, 0}};
    if (degrees < 0)
        return sampled(intersection(planes), 1, spacing, random);
    return sampled({planes, [](const std::vector<double>& f) { return std::min(f[0], f[1]); },
                    [](std::size_t, std::size_t) { return false; }},
                   1, spacing, random);
}

} // namespace

void MeasuredLabelsTest::creasesAreFoundWhereTheyWere_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("cube") << 0;
    QTest::newRow("L-block") << 1;
    QTest::newRow("pyramid") << 2;
}

void MeasuredLabelsTest::creasesAreFoundWhereTheyWere() {
    QFETCH(int, kind);
    Random random(test::seed());
    const Solid solid = kind == 0 ? cube(0.7) : kind == 1 ? lBlock(0.8) : pyramid(5, 0.8, 0.8);
    const SampledSolid s = sampled(solid, 2.4, spacing, random);
    const surface::Surface before = surfaceOf(s.surfels);
    const tree::Edit edit = cells::measuredLabels(before, everywhere());
    const tree::SurfelTree after = edit.empty() ? before.tree() : before.tree().apply(edit);
    QCOMPARE(after.size(), before.tree().size());
    std::vector<Label> old;
    forLabels(before.tree(), [&](auto, auto, auto&&, const Label& label) { old.push_back(label); });
    std::size_t i = 0, partners = 0, signs = 0, beside = 0;
    forLabels(after, [&](auto, auto, auto&&, const Label& label) {
        const Label& was = old[i++];
        QCOMPARE(label.cell, was.cell);
        beside += was.meeting != Meeting::None ? 1 : 0;
        partners += label.partner != was.partner ? 1 : 0;
        signs += label.partner == was.partner && label.meeting != was.meeting ? 1 : 0;
    });
    // at corners two creases may be as near, and the end of their reach lies between surfels
    const QByteArray told = QString("seed %1: %2 beside, partners %3, signs %4")
                                .arg(test::seed())
                                .arg(beside)
                                .arg(partners)
                                .arg(signs)
                                .toUtf8();
    QVERIFY2(beside > 100 && partners <= beside / 12 && signs == 0, told);
}

void MeasuredLabelsTest::bentTheOtherWayTheSignTurns_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::newRow("ridge to valley") << -30.0 << 25.0;
    QTest::newRow("valley to ridge") << 30.0 << -20.0;
    QTest::newRow("ridge to hardly a valley") << -30.0 << 2.0;
    QTest::newRow("valley to hardly a ridge") << 30.0 << -2.0;
}

void MeasuredLabelsTest::bentTheOtherWayTheSignTurns() {
    QFETCH(double, from);
    QFETCH(double, to);
    Random random(test::seed());
    SampledSolid s = roof(from, random);
    const double a = to * pi / 180;
    for (surfel::Surfel& each : s.surfels.items) {
        const double side = each.position.x < 0 ? -1 : 1;
        each.position.z = static_cast<float>(std::abs(double(each.position.x)) * std::tan(a));
        each.normal = base::cast<float>(Vec3d{-side * std::sin(a), 0, std::cos(a)});
    }
    const surface::Surface before = surfaceOf(s.surfels);
    const tree::SurfelTree after = before.tree().apply(cells::measuredLabels(before, everywhere()));
    const Meeting expected = to > 0 ? Meeting::Concave : Meeting::Convex;
    std::size_t beside = 0, wrong = 0;
    forLabels(after, [&](auto, auto, const Vec3d& p, const Label& label) {
        if (std::abs(p.x) > 1.2 * spacing || std::abs(p.y) > 0.7)
            return;
        ++beside;
        wrong += label.meeting != expected ? 1 : 0;
    });
    QVERIFY2(beside > 20 && wrong == 0,
             qPrintable(QString("%1 of %2, seed %3").arg(wrong).arg(beside).arg(test::seed())));
}

void MeasuredLabelsTest::cellsThatHaveBecomeFlatAreOne_data() {
    QTest::addColumn<double>("left"); // degrees by which one side rises at the two ends
    QTest::addColumn<double>("right");
    QTest::addColumn<double>("radius"); // of the bend
    QTest::addColumn<bool>("merge");
    QTest::newRow("flat") << 1.0 << 1.0 << 1e6 << true;
    QTest::newRow("6 degrees") << 6.0 << 6.0 << 1e6 << true;
    QTest::newRow("11 degrees") << 11.0 << 11.0 << 1e6 << false;
    QTest::newRow("flat in part") << 25.0 << 0.0 << 1e6 << false;
    QTest::newRow("bent") << 0.0 << 0.0 << 0.9 << true;
    QTest::newRow("bent with an edge") << 12.0 << 12.0 << 0.9 << false;
}

/// One side rises over the y axis by an angle that goes from one to another along it, on what is bent across it.
void MeasuredLabelsTest::cellsThatHaveBecomeFlatAreOne() {
    QFETCH(double, left);
    QFETCH(double, right);
    QFETCH(double, radius);
    QFETCH(bool, merge);
    Random random(test::seed());
    SampledSolid s = roof(-20, random);
    for (surfel::Surfel& each : s.surfels.items) {
        const double x = double(each.position.x), y = double(each.position.y);
        const double slope = std::tan((left + (right - left) * (y + 1) / 2) * pi / 180);
        const double rise = x > 0 ? slope : 0, bend = std::sqrt(radius * radius - 0.5 * x * x);
        each.position.z = static_cast<float>(x * rise + radius - bend);
        each.normal = base::cast<float>(base::normalized(
            Vec3d{-rise - 0.5 * x / bend, x > 0 ? -x * (right - left) / 2 * pi / 180 * (1 + slope * slope) : 0, 1}));
    }
    surface::Surface now = surfaceOf(s.surfels);
    const auto apply = [&](const tree::Edit& edit) {
        if (!edit.empty())
            now = {now.tree().apply(edit), now.definition()};
        return !edit.empty();
    };
    apply(cells::measuredLabels(now, everywhere()));
    const bool merged = apply(cells::mergedFlatPairs(now, everywhere()));
    std::size_t cellsLeft = 0, beside = 0;
    forLabels(now.tree(), [&](auto, auto, auto&&, const Label& label) {
        cellsLeft |= std::size_t(1) << label.cell;
        beside += label.meeting != Meeting::None ? 1 : 0;
    });
    const QByteArray told =
        QString("seed %1: cells %2, %3 beside").arg(test::seed()).arg(cellsLeft).arg(beside).toUtf8();
    QVERIFY2(merged == merge && (cellsLeft != 3) == merge && (beside == 0) == merge, told);
}

/// They were drawn, and are to become an edge by the strokes that follow.
void MeasuredLabelsTest::flatCreasesWithinAFaceStay() {
    Random random(test::seed());
    SampledSolid s = sampled(intersection({{{0, 0, 1}, 0}}), 1, spacing, random);
    std::vector<Label> halves(s.surfels.size());
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const float x = s.surfels.items[i].position.x;
        halves[i].cell = x < 0 ? 1 : 2;
        halves[i].partner = std::abs(x) > 2 * static_cast<float>(spacing) ? halves[i].cell : x < 0 ? 2 : 1;
        halves[i].meeting = halves[i].partner == halves[i].cell ? Meeting::None : Meeting::Convex;
    }
    cells::setLabels(s.surfels, halves, true);
    const surface::Surface drawn = surfaceOf(s.surfels);
    QVERIFY(cells::measuredLabels(drawn, everywhere()).empty());
    QVERIFY(cells::mergedFlatPairs(drawn, everywhere()).empty());
}

/// A plate that is a third of a spacing thick in its middle: the planes of both sides meet there, both sides go on.
void MeasuredLabelsTest::wallsThatComeNearDoNotMeet() {
    Random random(test::seed());
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    list.layout = layout;
    std::vector<Label> labels;
    constexpr double slope = 0.2, thin = 0.15 * spacing;
    for (const int side : {-1, 1})
        for (int i = -8; i <= 8; ++i)
            for (int k = -8; k <= 8; ++k) {
                const double x = (i + random.uniform(-0.2, 0.2)) * spacing,
                             y = (k + random.uniform(-0.2, 0.2)) * spacing;
                const double z = std::sqrt(slope * slope * x * x + thin * thin);
                surfel::Surfel s;
                s.position = base::cast<float>(Vec3d{x, y, side * z});
                s.normal = base::cast<float>(base::normalized(Vec3d{-slope * slope * x / z, 0, 1.0 * side}));
                s.support = static_cast<float>(3.5 * spacing);
                list.append(s, {});
                const std::uint32_t cell = side < 0 ? 1 : 2;
                const bool beside = std::abs(x) < 2 * spacing;
                labels.push_back({cell, beside ? 3 - cell : cell, beside ? Meeting::Convex : Meeting::None, 255, cell});
            }
    cells::setLabels(list, labels);
    const surface::Surface before = surfaceOf(list);
    QVERIFY(cells::mergedFlatPairs(before, everywhere()).empty());
    const tree::SurfelTree after = before.tree().apply(cells::measuredLabels(before, everywhere()));
    std::size_t beside = 0;
    forLabels(after, [&](auto, auto, const Vec3d& p, const Label& label) {
        beside += std::abs(p.x) < 4 * spacing && std::abs(p.y) < 6 * spacing && label.meeting != Meeting::None ? 1 : 0;
    });
    QVERIFY2(beside == 0, qPrintable(QString("%1, seed %2").arg(beside).arg(test::seed())));
}

void MeasuredLabelsTest::nothingChangesElsewhere() {
    Random random(test::seed());
    SampledSolid s = sampled(cube(0.7), 2.4, spacing, random);
    std::vector<Label> none(s.surfels.size());
    const LabelLayout labels = *LabelLayout::of(*s.surfels.layout);
    for (std::size_t i = 0; i < none.size(); ++i) {
        none[i] = labels.at(s.surfels.extraOf(i));
        none[i].meeting = none[i].meeting == Meeting::None ? Meeting::None : cells::opposite(none[i].meeting);
    }
    cells::setLabels(s.surfels, none); // all signs wrong
    const surface::Surface before = surfaceOf(s.surfels);
    const base::Vec3f corner{0.7f, 0.7f, 0.7f};
    const cells::EditedBall ball{corner, 0.3f};
    const tree::SurfelTree after = before.tree().apply(cells::measuredLabels(before, {&ball, 1}));
    std::size_t turned = 0, touched = 0;
    forLabels(after, [&](auto, auto, const Vec3d& p, const Label& label) {
        const double far = base::distance(p, base::cast<double>(corner));
        turned += far < 0.3 && label.meeting == Meeting::Convex ? 1 : 0;
        touched += far > 0.3 + 3.6 * spacing && label.meeting == Meeting::Convex ? 1 : 0;
    });
    QVERIFY(turned > 10);
    QCOMPARE(touched, std::size_t(0));
}

static const test::Registered<MeasuredLabelsTest> registered;
#include "measured_labels_test.moc"
