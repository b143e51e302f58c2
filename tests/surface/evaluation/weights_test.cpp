// Weights one by one, against closed forms and against the sums of the reference; means of attributes by brute force.
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3f;

Q_DECLARE_METATYPE(surface::Weight)

class WeightsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void valuesAreThoseOfTheFormulas();
    void nothingWeighsFromTheSupportOn();
    void sumsAreThoseOfTheReference_data() { weights(); }
    void sumsAreThoseOfTheReference();
    void meansAreThoseOfPlainLoops_data() { weights(); }
    void meansAreThoseOfPlainLoops();
    void equalSurfelsHaveThemselvesAsMean();
    void wholeNumbersAreOfTheHeaviest();

  private:
    static void weights() {
        QTest::addColumn<Weight>("weight");
        QTest::newRow("wendland") << Weight::Wendland;
        QTest::newRow("wendland-c4") << Weight::WendlandC4;
        QTest::newRow("gaussian") << Weight::Gaussian;
    }
};

namespace {

constexpr Weight everyWeight[] = {Weight::Wendland, Weight::WendlandC4, Weight::Gaussian};

/// A jittered plane with supports that differ, colours, masks and two further attributes, drawn at random.
surfel::SurfelList randomPlane(base::Random& random) {
    surfel::SurfelList list = shapes::jittered(shapes::plane(12, 0.1, 0.35), 0.03, random.next());
    auto attributes = std::make_shared<surfel::AttributeLayout>(*list.layout);
    attributes->colours = attributes->masks = true;
    attributes->add("height", surfel::ScalarType::Float64);
    attributes->add("label", surfel::ScalarType::UInt8);
    list.layout = attributes;
    list.extra.resize(list.size() * attributes->words());
    for (std::size_t i = 0; i < list.size(); ++i) {
        surfel::Surfel& s = list.items[i];
        s.support *= static_cast<float>(random.uniform(0.9, 1.3));
        s.colour = static_cast<surfel::Colour>(random.next());
        s.mask = static_cast<float>(random.uniform(0, 1));
        const std::span<std::uint32_t> words{list.extra.data() + i * attributes->words(), attributes->words()};
        write(attributes->attributes()[0], words, random.uniform(-5, 5));
        write(attributes->attributes()[1], words, static_cast<double>(i % 200));
    }
    return list;
}

/// theta in double, from the definition (surface/README 2.1).
double plainWeight(Weight weight, double distance, double support) {
    const double r = distance / support, t = 1 - r;
    if (r >= 1)
        return 0;
    if (weight == Weight::Gaussian)
        return std::exp(-std::pow(r * double(gaussianReach), 2));
    return weight == Weight::Wendland ? std::pow(t, 4) * (4 * r + 1) : std::pow(t, 6) * (35 * r * r + 18 * r + 3) / 3;
}

QString seedText() {
    return QString("seed %1").arg(test::seed());
}

} // namespace

void WeightsTest::valuesAreThoseOfTheFormulas() {
    for (const Weight weight : everyWeight) {
        QCOMPARE(weightAt(weight, 0.0f, 2), 1.0f);
        for (const float r : {0.01f, 0.25f, 0.5f, 0.75f, 0.99f}) {
            const double plain = plainWeight(weight, 2 * double(r), 2);
            QVERIFY(std::abs(double(weightAt(weight, 4 * r * r, 2)) - plain) < 1e-6 + 1e-5 * plain);
        }
    }
    QCOMPARE(wendlandC2(0.5f), 3.0f / 16);
    QVERIFY(std::abs(weightAt(Weight::WendlandC4, 0.25f, 1) - 83.0f / 768) < 1e-7f);
    QVERIFY(std::abs(weightAt(Weight::Gaussian, 1.0f, gaussianReach) - std::exp(-1.0f)) < 1e-6f);
}

void WeightsTest::nothingWeighsFromTheSupportOn() {
    for (const Weight weight : everyWeight)
        for (const float h : {1e-3f, 0.7f, 40.0f}) {
            QCOMPARE(weightAt(weight, h * h, h), 0.0f);
            QCOMPARE(weightAt(weight, 2 * h * h, h), 0.0f);
            QVERIFY(weightAt(weight, 0.9f * h * h, h) > 0);
        }
}

void WeightsTest::sumsAreThoseOfTheReference() {
    QFETCH(const Weight, weight);
    base::Random random(test::seed());
    SurfaceDefinition definition;
    definition.weight = weight;
    const Surface surface(tree::SurfelTree::build(randomPlane(random)), definition);
    for (int trial = 0; trial < test::effort(200); ++trial) {
        const Vec3f x{float(random.uniform(-1, 1)), float(random.uniform(-1, 1)), float(random.uniform(-0.1, 0.1))};
        double sum = 0;
        int samples = 0;
        forWeights(surface, x, [&](const surfel::SurfelBlock&, int, float theta) {
            sum += double(theta);
            ++samples;
        });
        const Evaluationd expected = surface.evaluateReference(base::cast<double>(x));
        QVERIFY2(std::abs(sum - expected.weight) < 1e-5 * expected.weight, qPrintable(seedText()));
        QVERIFY2(std::abs(samples - expected.samples) <= 1, qPrintable(seedText()));
    }
}

void WeightsTest::meansAreThoseOfPlainLoops() {
    QFETCH(const Weight, weight);
    base::Random random(test::seed());
    const surfel::SurfelList list = randomPlane(random);
    const surfel::Attribute& height = list.layout->attributes()[0];
    SurfaceDefinition definition;
    definition.weight = weight;
    const Surface surface(tree::SurfelTree::build(list), definition);
    for (int trial = 0; trial < test::effort(200); ++trial) {
        const Vec3f x{float(random.uniform(-1, 1)), float(random.uniform(-1, 1)), float(random.uniform(-0.1, 0.1))};
        AttributeSum sum(*list.layout);
        forWeights(surface, x, [&](const surfel::SurfelBlock& block, int slot, float theta) { //
            sum.add(block, slot, theta);
        });
        double total = 0, mask = 0, red = 0, heights = 0;
        for (std::size_t i = 0; i < list.size(); ++i) {
            const surfel::Surfel& s = list.items[i];
            const double w = plainWeight(weight, double(distance(s.position, x)), double(s.support));
            total += w, mask += w * double(s.mask), red += w * double(s.colour & 255u);
            heights += w * read(height, list.extraOf(i));
        }
        std::vector<std::uint32_t> words(list.layout->words());
        sum.further(words);
        QVERIFY2(sum.any(), qPrintable(seedText()));
        QVERIFY2(std::abs(double(sum.mask()) - mask / total) < 1e-5, qPrintable(seedText()));
        QVERIFY2(std::abs(double(sum.colour() & 255u) - red / total) < 0.501, qPrintable(seedText()));
        QVERIFY2(std::abs(read(height, words) - heights / total) < 1e-4, qPrintable(seedText()));
    }
}

void WeightsTest::equalSurfelsHaveThemselvesAsMean() {
    surfel::SurfelList list = shapes::plane(4, 0.1, 0.35);
    for (surfel::Surfel& s : list.items) {
        s.colour = surfel::rgba(1, 128, 255, 77);
        s.mask = 0.25f;
    }
    const Surface surface(tree::SurfelTree::build(list), {});
    AttributeSum sum(*surfel::AttributeLayout::none());
    QVERIFY(!sum.any());
    forWeights(surface, {0.03f, 0.04f, 0.01f},
               [&](const surfel::SurfelBlock& block, int slot, float theta) { sum.add(block, slot, theta); });
    QCOMPARE(sum.colour(), surfel::rgba(1, 128, 255, 77));
    QCOMPARE(sum.mask(), 0.25f);
}

void WeightsTest::wholeNumbersAreOfTheHeaviest() {
    base::Random random(test::seed());
    const surfel::SurfelList list = randomPlane(random);
    const tree::SurfelTree tree = tree::SurfelTree::build(list);
    const surfel::Attribute& label = tree.layout()->attributes()[1];
    AttributeSum sum(*tree.layout());
    float most = 0;
    double expected = -1;
    std::vector<std::uint32_t> words(tree.layout()->words());
    forWeights(Surface(tree, {}), {0.2f, -0.3f, 0}, [&](const surfel::SurfelBlock& block, int slot, float theta) {
        sum.add(block, slot, theta);
        if (theta <= most)
            return;
        most = theta;
        block.extra(slot, words);
        expected = read(label, words);
    });
    sum.further(words);
    QVERIFY2(expected >= 0 && read(label, words) == expected, qPrintable(seedText()));
}

static const test::Registered<WeightsTest> registered;
#include "weights_test.moc"
