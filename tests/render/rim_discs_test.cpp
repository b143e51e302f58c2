// Discs of few samples end at the rims that a model knows of, as reduced models have them (render/README 3.1).
#include "core/surface/rims.h"
#include "render/masks.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

class RimDiscsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void fewDiscsEndAtKnownRims();
};

namespace {

constexpr double spacing = 0.1;

/// A round plate in rings, the outermost so far from the rim that this is where the limit is, supports of 8 neighbours.
surfel::SurfelList plate(std::uint64_t seed) {
    base::Random random(seed);
    const double support = std::sqrt(8 / std::numbers::pi) * spacing;
    auto layout = std::make_shared<surfel::AttributeLayout>(*test::orientedLayout());
    layout->add(surface::rimName, surfel::ScalarType::UInt8);
    const surfel::Attribute rim = *layout->find(surface::rimName);
    surfel::SurfelList out;
    out.layout = layout;
    constexpr int rings = 10;
    for (int at = 0; at < rings; ++at) {
        const double ring = (1 - 0.27 * support) * (1 - at / (rings - 0.5));
        const int count = std::max(1, static_cast<int>(std::lround(2 * std::numbers::pi * ring / spacing)));
        const double phase = random.uniform(0, 1);
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * (k + phase + random.uniform(-0.2, 0.2)) / count;
            const double r = ring + random.uniform(-0.1, 0.1) * spacing;
            surfel::Surfel s;
            s.position = base::cast<float>(base::Vec3d{r * std::cos(angle), r * std::sin(angle), 0});
            s.normal = {0, 0, 1};
            s.support = static_cast<float>(support);
            std::vector<std::uint32_t> words(layout->words());
            surfel::write(rim, words, 1 - r < double(surface::rimReach) * support ? 1 : 0);
            out.append(s, words);
        }
    }
    return out;
}

} // namespace

void RimDiscsTest::fewDiscsEndAtKnownRims() {
    for (int round = 0; round < test::effort(5); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        surface::SurfaceDefinition definition;
        definition.knownRims = true;
        definition.boundaryLimit = 0.284f;
        const surface::Surface surface(tree::SurfelTree::build(plate(seed)), definition);
        std::vector<render::Camera> views = test::allAround(surface.tree().bounds(), 300, 300);
        views.resize(4); // the others see the plate edge-on
        const test::MaskGap all = test::maskGap(surface, test::atRest(surface), views);
        const QString found =
            QString("%1 % holes, %2 % strays, seed %3").arg(all.holesPercent()).arg(all.straysPercent()).arg(seed);
        QVERIFY2(all.hit > 40000 && all.holesPercent() < 2 && all.straysPercent() < 0.2, qPrintable(found));
    }
}

static const test::Registered<RimDiscsTest> registered;
#include "rim_discs_test.moc"
