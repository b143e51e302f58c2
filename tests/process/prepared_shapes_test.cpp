// Shapes of supports that a file brings without supports, as Gaussian splats do.
#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "core/surfel/shape.h"
#include "support/registry.h"

#include <array>
#include <map>
#include <QTest>

class PreparedShapesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void shapesWithoutSupportsGetTheAreaOfBalls();
};

/// In the tangent planes; and only where that is asked for.
void PreparedShapesTest::shapesWithoutSupportsGetTheAreaOfBalls() {
    surfel::SurfelList balls = process::sample("sphere").make(400, 1);
    for (surfel::Surfel& each : balls.items)
        each.support = 0;
    surfel::SurfelList shaped = balls;
    auto layout = std::make_shared<surfel::AttributeLayout>(*balls.layout);
    surfel::addShape(*layout);
    shaped.layout = layout;
    shaped.extra.assign(shaped.size() * layout->words(), 0);
    const std::size_t words = layout->words(), first = surfel::shapeWord(*layout);
    for (std::size_t i = 0; i < shaped.size(); ++i)
        surfel::putShape(std::span(shaped.extra).subspan(i * words, words), first, {1.5f, 0.2f, 0.4f});
    process::PrepareOptions options;
    const auto supports = [&](const surfel::SurfelList& list) {
        std::map<std::array<float, 3>, std::pair<float, surfel::Surfel>> out; // by place
        const surface::Surface made = process::prepare(list, options);
        const int channel = surfel::shapeChannel(*made.tree().layout());
        made.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                const base::Vec3f p = block.position(slot), b = surfel::shapeOf(block, slot, channel);
                out[{p.x, p.y, p.z}] = {surfel::ballOf(block, slot, channel), block.surfel(slot)};
                if (std::abs(dot(b, block.normal(slot))) > 1e-4f ||
                    (channel > 0 && options.keepShapes == (b == base::Vec3f{})))
                    out.clear();
            }
        });
        return out;
    };
    const auto plain = supports(balls), unasked = supports(shaped);
    options.keepShapes = true;
    const auto asked = supports(shaped);
    QVERIFY(plain.size() == balls.size() && unasked.size() == plain.size() && asked.size() == plain.size());
    for (const auto& [place, ball] : plain) {
        QCOMPARE(unasked.at(place).second.support, ball.second.support);
        QVERIFY(std::abs(asked.at(place).first / ball.first - 1) < 1e-5f);
        QVERIFY(asked.at(place).second.support > ball.second.support);
    }
}

static const test::Registered<PreparedShapesTest> registered;
#include "prepared_shapes_test.moc"
