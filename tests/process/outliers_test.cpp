// Outliers about a dense model leave its supports alone.
#include "core/base/random.h"
#include "core/process/estimation/spacing.h"
#include "core/process/estimation/supports.h"
#include "core/process/neighbours/knn.h"
#include "process/uneven_sphere.h"
#include "support/registry.h"

#include <QTest>

using namespace process;
using base::Vec3d;

class OutliersTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void outliersDoNotWidenTheModel();
    void outliersAreNoWiderThanWhatTheyStandBeside();
    void sparsePartsAreNoOutliers();
};

using shapes::at, shapes::unevenSphere;

namespace {

/// Adds outliers anywhere about the sphere, near it by the spacing, and in clumps of five.
void addOutliers(surfel::SurfelList& list, base::Random& random) {
    const std::vector<float> spacing = spacings(list.items);
    const std::size_t model = list.size();
    for (int k = 0; k < 100; ++k)
        list.items.push_back(at(random.unitVector() * random.uniform(1.5, 4)));
    for (int k = 0; k < 100; ++k) {
        const std::size_t i = random.below(model);
        const Vec3d p = base::cast<double>(list.items[i].position);
        list.items.push_back(at(p * (1 + double(spacing[i]) * random.uniform(4, 9))));
    }
    for (int k = 0; k < 10; ++k) {
        const Vec3d p = random.unitVector() * random.uniform(1.3, 2);
        for (int j = 0; j < 5; ++j)
            list.items.push_back(at(p + random.unitVector() * 0.1));
    }
}

} // namespace

void OutliersTest::outliersDoNotWidenTheModel() {
    base::Random random(test::seed());
    surfel::SurfelList clean = unevenSphere(20000, random), dirty = clean;
    addOutliers(dirty, random);
    assignSupports(clean, {});
    assignSupports(dirty, {});
    std::size_t changed = 0;
    for (std::size_t i = 0; i < clean.size(); ++i) {
        const float ratio = dirty.items[i].support / clean.items[i].support;
        changed += std::abs(ratio - 1) > 0.01f;
        if (clean.items[i].support < 0.5f) // elsewhere the model is as sparse as its outliers
            QVERIFY2(ratio < 2, qPrintable(QString("%1 times at %2, seed %3").arg(ratio).arg(i).arg(test::seed())));
    }
    QVERIFY2(changed < clean.size() / 100, qPrintable(QString("%1, seed %2").arg(changed).arg(test::seed())));
}

void OutliersTest::outliersAreNoWiderThanWhatTheyStandBeside() {
    base::Random random(test::seed());
    surfel::SurfelList list = unevenSphere(20000, random);
    const std::size_t model = list.size();
    for (int k = 0; k < 50; ++k) {
        Vec3d d = random.unitVector();
        d.z = -std::abs(d.z); // where the model is dense
        list.items.push_back(at(d * random.uniform(1.5, 3)));
    }
    assignSupports(list, {});
    const Cloud cloud(list.items);
    std::vector<std::uint8_t> ofModel(cloud.size(), 0);
    std::vector<float> support(cloud.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        ofModel[cloud.places()[i]] = i < model;
        support[cloud.places()[i]] = list.items[i].support;
    }
    Neighbours near;
    for (std::size_t i = model; i < list.size(); ++i) {
        cloud.nearest(cloud.places()[i], 12, near);
        float widest = 0;
        for (const std::uint32_t j : near.index)
            widest = std::max(widest, ofModel[j] ? support[j] : 0);
        QVERIFY2(widest == 0 || list.items[i].support <= widest * 1.00001f,
                 qPrintable(QString("%1 beside %2, seed %3").arg(list.items[i].support).arg(widest).arg(test::seed())));
    }
}

void OutliersTest::sparsePartsAreNoOutliers() {
    // Round holes of a dense sphere, filled with a ninth of its density: too few samples to be told by their
    // number.
    base::Random random(test::seed());
    std::vector<Vec3d> holes;
    for (int k = 0; k < 12; ++k)
        holes.push_back(random.unitVector());
    surfel::SurfelList list;
    while (list.size() < 20000) {
        const Vec3d d = random.unitVector();
        const auto holds = [&](const Vec3d& c) { return dot(c, d) > 0.98; };
        if (std::none_of(holes.begin(), holes.end(), holds) || random.uniform() < 0.11)
            list.items.push_back(at(d));
    }
    assignSupports(list, {});
    const std::vector<float> spacing = spacings(list.items);
    for (std::size_t i = 0; i < list.size(); ++i)
        QVERIFY2(list.items[i].support > 0.4f * 3.4f * spacing[i],
                 qPrintable(QString("point %1, seed %2").arg(i).arg(test::seed())));
}

static const test::Registered<OutliersTest> registered;

#include "outliers_test.moc"
