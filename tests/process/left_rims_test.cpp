// Where surfels of a model that knows its rims go, what is left beside them is a rim.
#include "core/process/estimation/left_rims.h"

#include "core/base/random.h"
#include "core/process/estimation/part_limit.h"
#include "core/surface/rims.h"
#include "even_shapes.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3f;

class LeftRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void besideWhatWentAndNowhereElse();
    void partsOfModelsKnowTheirRims();
    void whatEndedNowhereKnowsItsRimsWhenItIsCut();
};

namespace {

surface::Surface ball() {
    surfel::SurfelList list = test::spherePoints(3000);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->add(surface::rimName, surfel::ScalarType::UInt8);
    list.layout = layout;
    list.extra.assign(list.size() * layout->words(), 0);
    surface::SurfaceDefinition definition;
    definition.knownRims = true;
    return {tree::SurfelTree::build(list), definition};
}

/// Takes what lies within `radius` of a place.
tree::Edit taking(const tree::SurfelTree& tree, const Vec3f& place, float radius) {
    tree::Edit edit;
    edit.inserted.layout = tree.layout();
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        tree::BlockEdit each{number, {}, {}};
        for (int slot = 0; slot < block.size(); ++slot)
            each.removed[std::size_t(slot)] = distance(block.position(slot), place) < radius;
        if (each.removed.any())
            edit.blocks.push_back(each);
    });
    return edit;
}

void checkRims(const tree::SurfelTree& left, const tree::SurfelTree& whole, const Vec3f& place, float radius) {
    std::size_t rims = 0;
    left.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            bool near = false;
            for (const surfel::Surfel& s : whole.surfels().items)
                near = near ||
                       (distance(s.position, place) < radius &&
                        distance(s.position, block.position(slot)) < process::reachOfLeftRims * block.support(slot));
            QCOMPARE(surface::isBesideRim(block, slot, *left.layout()), near);
            rims += near;
        }
    });
    QVERIFY(rims > 0 && rims < left.size() / 2);
}

} // namespace

void LeftRimsTest::besideWhatWentAndNowhereElse() {
    base::Random random(test::seed());
    const surface::Surface whole = ball();
    const Vec3f place = base::cast<float>(random.unitVector());
    tree::Edit edit = taking(whole.tree(), place, 0.3f);
    process::addRims(whole, edit);
    checkRims(whole.tree().apply(edit), whole.tree(), place, 0.3f);
}

void LeftRimsTest::partsOfModelsKnowTheirRims() {
    base::Random random(test::seed());
    const surface::Surface whole = ball();
    const Vec3f place = base::cast<float>(random.unitVector());
    const surface::Surface left = process::partOf(whole, whole.tree().apply(taking(whole.tree(), place, 0.3f)));
    checkRims(left.tree(), whole.tree(), place, 0.3f);
    QVERIFY(surface::knowsRims(left) && std::isfinite(left.definition().boundaryLimit));
}

/// Blades and folds away from the cut are no rims of it.
void LeftRimsTest::whatEndedNowhereKnowsItsRimsWhenItIsCut() {
    base::Random random(test::seed());
    const Vec3f place = base::cast<float>(random.unitVector());
    for (const auto boundary : {surface::Boundary::None, surface::Boundary::Auto}) {
        surface::SurfaceDefinition definition;
        definition.boundary = boundary;
        const surface::Surface whole{tree::SurfelTree::build(test::spherePoints(3000)), definition};
        const surface::Surface left =
            process::partOf(whole, whole.tree().apply(taking(whole.tree(), place, 0.3f)), {}, true);
        QVERIFY(surface::knowsRims(left) && std::isfinite(left.definition().boundaryLimit));
        checkRims(left.tree(), whole.tree(), place, 0.3f);
    }
}

static const test::Registered<LeftRimsTest> registered;
#include "left_rims_test.moc"
