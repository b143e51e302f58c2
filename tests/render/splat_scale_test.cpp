#include "core/render/splats/splat_scale.h"

#include "core/base/random.h"
#include "core/render/splats/splat_kernels.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

class SplatScaleTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void usualSupportsAreLeftAlone();
    void otherSupportsGetTheUsualSplats();
    void discsOfFewSamplesEndSoonBehindTheirGaps();
    void scaleGrowsWithoutAJump();
    void densePlacesLeaveSparseOnesTheirCover();
    void fewSurfelsHaveNoSpacing();
};

void SplatScaleTest::usualSupportsAreLeftAlone() {
    QCOMPARE(render::splatScaleOf(test::built(test::sphere({0, 0, 0}, 1, 20000))), 1.0f);
    QCOMPARE(render::splatScaleOf(test::built(test::torus(1, 0.4, 20000, test::seed()))), 1.0f);
}

void SplatScaleTest::otherSupportsGetTheUsualSplats() {
    for (const float factor : {1.6f, 5.0f}) {
        surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
        for (auto& s : list.items)
            s.support *= factor;
        const float scale = render::splatScaleOf(test::built(list));
        QVERIFY2(std::abs(scale * factor - 1) < 0.08f, qPrintable(QString::number(scale)));
    }
}

/// Large discs stand out over outlines; where samples are even, smaller ones leave no hole either. Where they lie by
/// chance they stay as large as they were.
void SplatScaleTest::discsOfFewSamplesEndSoonBehindTheirGaps() {
    constexpr float factor = 0.45f; // of the usual supports: about eight neighbours
    base::Random random(test::seed());
    surfel::SurfelList even = test::sphere({0, 0, 0}, 1, 3000), chance = even;
    for (auto& s : even.items)
        s.support *= factor;
    for (auto& s : chance.items) {
        s.position = s.normal = base::cast<float>(random.unitVector());
        s.support *= factor;
    }
    const float small = render::splatScaleOf(test::built(even)) * factor;
    const float large = render::splatScaleOf(test::built(chance)) * factor;
    const QByteArray told = QString("%1 %2 seed %3").arg(small).arg(large).arg(test::seed()).toUtf8();
    QVERIFY2(small > 0.6f && small < 0.8f && large > 0.9f, told);
    const tree::SurfelTree model = test::built(even);
    const float radius = render::splatRadiusOfSupport * small / factor * even.items[0].support;
    std::vector<tree::Neighbour> near;
    for (int k = 0; k < test::effort(2000); ++k) {
        model.nearest(base::cast<float>(random.unitVector()), 1, near);
        QVERIFY2(near[0].distanceSq < radius * radius, told);
    }
}

void SplatScaleTest::scaleGrowsWithoutAJump() {
    const surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
    float last = 0;
    for (float factor = 2.5f; factor > 0.4f; factor *= 0.98f) {
        surfel::SurfelList scaled = list;
        for (auto& s : scaled.items)
            s.support *= factor;
        const float scale = render::splatScaleOf(test::built(scaled));
        QVERIFY2(last == 0 || (scale >= last && scale < 1.07f * last),
                 qPrintable(QString("%1 after %2 at supports times %3").arg(scale).arg(last).arg(factor)));
        last = scale;
    }
}

/// A stroke may leave most surfels closer than their supports say: the others still need their discs.
void SplatScaleTest::densePlacesLeaveSparseOnesTheirCover() {
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 4000);
    const surfel::SurfelList dense = test::sphere({0, 0, 0}, 1, 60000);
    for (surfel::Surfel s : dense.items)
        if (s.position.z > 0.6f) {
            s.support = list.items[0].support; // as wide as where they are sparse
            list.items.push_back(s);
        }
    QCOMPARE(render::splatScaleOf(test::built(list)), 1.0f);
}

void SplatScaleTest::fewSurfelsHaveNoSpacing() {
    QCOMPARE(render::splatScaleOf({}), 1.0f);
    QCOMPARE(render::splatScaleOf(test::built(test::sphere({0, 0, 0}, 1, 4))), 1.0f);
}

static const test::Registered<SplatScaleTest> registered;
#include "splat_scale_test.moc"
