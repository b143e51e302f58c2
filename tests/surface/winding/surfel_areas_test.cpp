// Areas, to the bit, against sums over all surfels, taken one by one.
#include "core/surface/winding/surfel_areas.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <numbers>
#include <QTest>

using base::Vec3d;
using base::Vec3f;

namespace {

float plainArea(const surfel::SurfelList& all, const surfel::Surfel& s, float reach) {
    const float radius = reach * s.support, radiusSq = radius * radius;
    float sum = 0;
    for (const surfel::Surfel& other : all.items) {
        const Vec3f way = other.position - s.position;
        const float square = lengthSq(way), a = dot(way, s.normal), b = dot(way, other.normal);
        const float height = std::min(a * a, b * b);
        const bool stacked = 2 * height > square && height > 0.4f * 0.4f * radiusSq;
        if (square < radiusSq && !stacked)
            sum += (1 - square / radiusSq) * std::clamp(1 + 2 * dot(s.normal, other.normal), 0.0f, 1.0f);
    }
    return sum < 2.5f ? reach < 1 ? plainArea(all, s, 1.2f) : 0
                      : 0.5f * std::numbers::pi_v<float> * radius * radius / sum;
}

/// A ball of two walls, some of it copies and strays, the supports those of an uneven sampling.
surfel::SurfelList someBall(base::Random& random, const Vec3d& centre) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    for (int i = 0; i < 3000; ++i) {
        const Vec3d u = random.unitVector();
        const bool inner = i % 3 == 0, stray = i % 50 == 0;
        surfel::Surfel s;
        s.position = base::cast<float>(centre + u * (inner ? 0.9 : stray ? random.uniform(0, 2) : 1.0));
        s.normal = base::cast<float>(inner ? -u : u);
        s.support = static_cast<float>(random.uniform(0.1, 0.4));
        out.items.push_back(i % 7 == 0 && i > 0 ? out.items[static_cast<std::size_t>(i) - 1] : s);
    }
    return out;
}

} // namespace

class SurfelAreasTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void AreasAreThoseOfSumsTakenOneByOne();
};

void SurfelAreasTest::AreasAreThoseOfSumsTakenOneByOne() {
    base::Random random(test::seed());
    for (const double away : {0.0, 1000.0}) {
        const tree::SurfelTree tree = tree::SurfelTree::build(someBall(random, {away, 0, -away}));
        const surfel::SurfelList inOrder = tree.surfels();
        std::vector<float> wanted;
        for (const surfel::Surfel& s : inOrder.items)
            wanted.push_back(plainArea(inOrder, s, 0.8f));
        for (const int threads : {1, 0}) {
            base::setThreadCount(threads);
            QVERIFY2(surface::surfelAreas(tree) == wanted,
                     qPrintable(QString("seed %1, %2 away").arg(test::seed()).arg(away)));
        }
    }
    base::setThreadCount(0);
}

static const test::Registered<SurfelAreasTest> registered;
#include "surfel_areas_test.moc"
