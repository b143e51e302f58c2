// Labels: what is written is read again, models without them are left alone, partners are across the nearest crease.
#include "core/cells/labels.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using cells::Label;
using cells::LabelLayout;
using cells::Meeting;

class LabelsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatIsWrittenIsReadAgain();
    void sharpnessAndFacesTakeNoWordsWhereTheyTellNothing();
    void otherAttributesStay();
    void modelsWithoutLabelsHaveNoCells();
    void partnersAreAcrossTheNearestCrease();
};

static surfel::SurfelList some(std::size_t count, Random& random) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    layout->add("scan", surfel::ScalarType::Int16);
    out.layout = layout;
    for (std::size_t i = 0; i < count; ++i) {
        surfel::Surfel s;
        s.position = base::cast<float>(random.unitVector());
        s.normal = s.position;
        s.support = 0.3f;
        const std::uint32_t word = static_cast<std::uint32_t>(i);
        out.append(s, {&word, 1});
    }
    return out;
}

void LabelsTest::whatIsWrittenIsReadAgain() {
    Random random(test::seed());
    surfel::SurfelList surfels = some(100, random);
    std::vector<Label> labels(100);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        Label& l = labels[i];
        l.cell = static_cast<std::uint32_t>(random.below(70000));
        l.meeting = static_cast<Meeting>(random.below(3));
        l.partner = l.meeting == Meeting::None ? l.cell : l.cell + 1;
        l.sharpness = static_cast<std::uint8_t>(random.below(256));
        l.face = static_cast<std::uint32_t>(random.below(9));
    }
    setLabels(surfels, labels);
    const auto layout = LabelLayout::of(*surfels.layout);
    QVERIFY(layout);
    for (std::size_t i = 0; i < labels.size(); ++i)
        QVERIFY(layout->at(surfels.extraOf(i)) == labels[i]);
    const tree::SurfelTree tree = tree::SurfelTree::build(surfels);
    std::size_t seen = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        std::vector<std::uint32_t> words(block.extraWords());
        for (int slot = 0; slot < block.size(); ++slot, ++seen) {
            block.extra(slot, words);
            QVERIFY(layout->at(block, slot) == labels[words[0]]);
        }
    });
    QCOMPARE(seen, labels.size());
}

void LabelsTest::sharpnessAndFacesTakeNoWordsWhereTheyTellNothing() {
    Random random(test::seed());
    surfel::SurfelList surfels = some(10, random);
    std::vector<Label> labels(10);
    setLabels(surfels, labels);
    QVERIFY(surfels.layout->find("cell") && surfels.layout->find("partner") && surfels.layout->find("sign"));
    QVERIFY(!surfels.layout->find("sharpness") && !surfels.layout->find("face"));
}

void LabelsTest::otherAttributesStay() {
    Random random(test::seed());
    surfel::SurfelList surfels = some(10, random);
    setLabels(surfels, std::vector<Label>(10));
    const surfel::Attribute scan = *surfels.layout->find("scan");
    for (std::size_t i = 0; i < 10; ++i)
        QCOMPARE(surfel::read(scan, surfels.extraOf(i)), static_cast<double>(i));
}

void LabelsTest::modelsWithoutLabelsHaveNoCells() {
    Random random(test::seed());
    surfel::SurfelList surfels = some(10, random);
    QVERIFY(!LabelLayout::of(*surfels.layout));
    QVERIFY(!cells::CellSurface::of(surfaceOf(surfels)));
    QCOMPARE(cells::countCells(surfels).cells, std::size_t(0));
    auto layout = std::make_shared<surfel::AttributeLayout>(*surfels.layout);
    for (const char* name : {"cell", "partner", "sign"}) // a file's own, in reals
        layout->add(name, surfel::ScalarType::Float32);
    QVERIFY(!LabelLayout::of(*layout));
}

void LabelsTest::partnersAreAcrossTheNearestCrease() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.08, random);
    const LabelLayout layout = *LabelLayout::of(*s.surfels.layout);
    std::size_t convex = 0, concave = 0;
    for (std::size_t i = 0; i < s.surfels.size(); ++i) {
        const Label label = layout.at(s.surfels.extraOf(i));
        const Vec3d p = base::cast<double>(s.surfels.items[i].position);
        if (label.meeting == Meeting::None) {
            QCOMPARE(label.partner, label.cell);
            continue;
        }
        const bool inner = std::min(label.cell, label.partner) == 6 && std::max(label.cell, label.partner) == 7;
        QCOMPARE(label.meeting, inner ? Meeting::Concave : Meeting::Convex);
        QVERIFY(std::abs(s.solid.planes[label.partner].f(p)) < cells::partnerReach * s.spacing);
        (inner ? concave : convex) += 1;
    }
    const cells::CellCounts counts = cells::countCells(s.surfels);
    QCOMPARE(counts.cells, std::size_t(8));
    QCOMPARE(counts.pairs, std::size_t(18)); // edges of an L-shaped prism
    QCOMPARE(counts.convex, convex);
    QCOMPARE(counts.concave, concave);
    QVERIFY(convex > 100 && concave > 10);
}

static const test::Registered<LabelsTest> registered;
#include "labels_test.moc"
