#include "core/render/splats/splat_scale.h"

#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

class SplatScaleTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void usualSupportsAreLeftAlone();
    void otherSupportsGetTheUsualSplats();
    void fewSurfelsHaveNoSpacing();
};

void SplatScaleTest::usualSupportsAreLeftAlone() {
    QCOMPARE(render::splatScaleOf(test::built(test::sphere({0, 0, 0}, 1, 20000))), 1.0f);
    QCOMPARE(render::splatScaleOf(test::built(test::torus(1, 0.4, 20000, test::seed()))), 1.0f);
}

void SplatScaleTest::otherSupportsGetTheUsualSplats() {
    for (const float factor : {0.4f, 1.6f, 5.0f}) {
        surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
        for (auto& s : list.items)
            s.support *= factor;
        const float scale = render::splatScaleOf(test::built(list));
        QVERIFY2(std::abs(scale * factor - 1) < 0.08f, qPrintable(QString::number(scale)));
    }
}

void SplatScaleTest::fewSurfelsHaveNoSpacing() {
    QCOMPARE(render::splatScaleOf({}), 1.0f);
    QCOMPARE(render::splatScaleOf(test::built(test::sphere({0, 0, 0}, 1, 4))), 1.0f);
}

static const test::Registered<SplatScaleTest> registered;
#include "splat_scale_test.moc"
