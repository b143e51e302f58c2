// The selection as an attribute: what joins what, what stays, what is made anew.
#include "clouds.h"
#include "core/base/error.h"
#include "support/registry.h"

#include <QTest>

using namespace selection;
using test::Place;

class FieldTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void firstSelectionKeepsEverySurfelAndTheTreesShape();
    void selectingNothingAtFirstIsTheSameVersion();
    void modesAreThoseOfSets();
    void onlyBlocksThatChangeAreMadeAnew();
    void maskAndSelectionAreApart();
    void attributesOfThatNameAndOtherTypeAreRefused();
};

static bool someOf(const surfel::Surfel& s, int which) {
    return base::mix(static_cast<std::uint64_t>(s.colour) + static_cast<std::uint64_t>(which)) % 3 == 0;
}

static tree::Selection randomly(const tree::SurfelTree& tree, int which) {
    return test::those(tree, [&](const surfel::Surfel& s) { return someOf(s, which); });
}

void FieldTest::firstSelectionKeepsEverySurfelAndTheTreesShape() {
    const surface::Surface ball = test::unevenBall(test::seed(), 3000);
    const tree::SurfelTree next = combined(ball.tree(), randomly(ball.tree(), 1), Mode::Replace);
    next.validate();
    QCOMPARE(next.blockCount(), ball.tree().blockCount());
    QCOMPARE(next.layout()->words(), ball.tree().layout()->words() + 1);
    const surfel::SurfelList before = ball.tree().surfels(), after = next.surfels();
    QVERIFY(before.items == after.items);
    QCOMPARE(test::placesOf(selectedIn(next)), test::placesOf(randomly(ball.tree(), 1)));
}

void FieldTest::selectingNothingAtFirstIsTheSameVersion() {
    const surface::Surface ball = test::unevenBall(test::seed(), 500);
    for (const Mode mode : {Mode::Replace, Mode::Add, Mode::Subtract, Mode::Intersect})
        QVERIFY(combined(ball.tree(), {}, mode) == ball.tree());
    QVERIFY(combined(ball.tree(), randomly(ball.tree(), 1), Mode::Subtract) == ball.tree());
    QVERIFY(selectedIn(ball.tree()).empty());
}

void FieldTest::modesAreThoseOfSets() {
    const surface::Surface ball = test::unevenBall(test::seed(), 1500);
    const tree::SurfelTree start = combined(ball.tree(), randomly(ball.tree(), 1), Mode::Replace);
    for (const Mode mode : {Mode::Replace, Mode::Add, Mode::Subtract, Mode::Intersect}) {
        const tree::SurfelTree next = combined(start, randomly(start, 2), mode);
        next.validate();
        test::forSurfels(next, [&](const Place& at, const surfel::Surfel& s) {
            const bool a = someOf(s, 1), b = someOf(s, 2);
            const bool expected = mode == Mode::Replace    ? b
                                  : mode == Mode::Add      ? a || b
                                  : mode == Mode::Subtract ? a && !b
                                                           : a && b;
            QCOMPARE(test::selectionAt(next, at), expected ? 1.0f : 0.0f);
        });
    }
}

void FieldTest::onlyBlocksThatChangeAreMadeAnew() {
    const surface::Surface ball = test::unevenBall(test::seed(), 4000);
    const tree::SurfelTree start = combined(
        ball.tree(), test::those(ball.tree(), [](const surfel::Surfel& s) { return s.position.z > 0; }), Mode::Replace);
    QVERIFY(combined(start, selectedIn(start), Mode::Replace) == start);
    tree::Selection one = selectedIn(start);
    one.resize(1);
    const tree::SurfelTree next = combined(start, one, Mode::Subtract);
    QCOMPARE(tree::diff(start, next).added.size(), std::size_t(1));
}

void FieldTest::maskAndSelectionAreApart() {
    const surface::Surface ball = test::unevenBall(test::seed(), 700);
    const auto half = [](std::uint32_t, const surfel::SurfelBlock&, BlockValues& values) { values.fill(0.5f); };
    const tree::SurfelTree masked = rewritten(ball.tree(), Field::Mask, half);
    QVERIFY(masked.layout()->masks && masked.layout()->words() == ball.tree().layout()->words());
    QVERIFY(selectedIn(masked).empty());
    QCOMPARE(tree::sizeOf(selectedIn(masked, Field::Mask)), masked.size()); // 1/2 is enough
    const tree::SurfelTree both = combined(masked, randomly(masked, 1), Mode::Replace);
    test::forSurfels(both, [](const Place&, const surfel::Surfel& s) { QCOMPARE(s.mask, 0.5f); });
}

void FieldTest::attributesOfThatNameAndOtherTypeAreRefused() {
    surfel::SurfelList points = test::spherePoints(200);
    auto layout = std::make_shared<surfel::AttributeLayout>(*points.layout);
    layout->add(attributeName(Field::Selection), surfel::ScalarType::UInt8);
    points.layout = layout;
    points.extra.assign(points.size(), 1);
    const tree::SurfelTree tree = tree::SurfelTree::build(points);
    QVERIFY_EXCEPTION_THROWN(combined(tree, {}, Mode::Add), base::Error);
}

static const test::Registered<FieldTest> registered;
#include "field_test.moc"
