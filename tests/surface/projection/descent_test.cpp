// Orthogonal projections between near sheets, where Newton's steps go round in circles or are caught where f nearly
// vanishes: they find feet, and what they find is one.
#include "core/base/random.h"
#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;

class DescentTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void hardlyAPlaceBetweenNearSheetsLacksItsFoot();
};

namespace {

constexpr double s = 0.03, h = 3.5 * s;

/// z = height + tilt x + waves, jittered; facing up or down.
void addSheet(base::Random& random, double height, double spacing, double tilt, double side, surfel::SurfelList& out) {
    const double high = random.uniform(0, 0.02), k = random.uniform(3, 9);
    for (double u = -0.5; u < 0.5; u += spacing)
        for (double v = -0.5; v < 0.5; v += spacing) {
            const double x = u + random.uniform(-0.3, 0.3) * spacing, y = v + random.uniform(-0.3, 0.3) * spacing;
            const Vec3d up{-tilt - high * k * std::cos(k * x) * std::cos(k * y),
                           high * k * std::sin(k * x) * std::sin(k * y), 1};
            surfel::Surfel each;
            each.position =
                base::cast<float>(Vec3d{x, y, height + tilt * x + high * std::sin(k * x) * std::cos(k * y)});
            each.normal = base::cast<float>(normalized(up) * side);
            each.support = static_cast<float>(3.5 * spacing);
            out.append(each, {});
        }
}

/// Two scans of one side that lie beside each other, or two walls.
Surface nearSheets(base::Random& random, bool walls) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    addSheet(random, 0, s, 0, walls ? -1 : 1, out);
    addSheet(random, s * random.uniform(1, 3), s * random.uniform(1, 1.6), random.uniform(-0.1, 0.1), 1, out);
    return shapes::surfaceOf(out, shapes::definitionOf(Frame::Normals, true, Weight::Wendland));
}

/// f vanishes there, and the way to it goes along the gradient.
template <class T>
bool isFoot(const Surface& surface, const base::Vec3<T>& x, const Projection<T>& p, double tolerance) {
    const Evaluationd at = surface.evaluateReference(base::cast<double>(p.foot), Need::Gradient);
    const Vec3d way = base::cast<double>(x) - base::cast<double>(p.foot);
    return std::abs(at.value) <= tolerance * h &&
           length(cross(way, at.gradient)) <= tolerance * (h + 20 * length(way)) * length(at.gradient);
}

} // namespace

void DescentTest::hardlyAPlaceBetweenNearSheetsLacksItsFoot() {
    int asked = 0, missed = 0, wrong = 0;
    for (int model = 0; model < 12; ++model) {
        base::Random random(test::seed() + std::uint64_t(model));
        const Surface surface = nearSheets(random, model % 3 == 2);
        std::vector<Vec3f> places;
        while (places.size() < std::size_t(test::effort(1500))) {
            const Vec3d p{random.uniform(-0.35, 0.35), random.uniform(-0.35, 0.35), s * random.uniform(-1, 4)};
            std::vector<tree::Neighbour> near;
            surface.tree().nearest(base::cast<float>(p), 1, near);
            if (near[0].distanceSq < float(s * s))
                places.push_back(base::cast<float>(p));
        }
        std::vector<Projection<float>> feet(places.size());
        project(surface, places, {}, feet);
        for (std::size_t i = 0; i < places.size(); ++i) {
            ++asked;
            missed += feet[i].ok() ? 0 : 1;
            wrong += feet[i].ok() && !isFoot(surface, places[i], feet[i], 2e-4) ? 1 : 0;
            if (feet[i].iterations < 20) // those that are hard to find
                continue;
            const Vec3d x = base::cast<double>(places[i]);
            const Projection<double> there = projectReference(surface, x);
            wrong += there.ok() && !isFoot(surface, x, there, 1e-7) ? 1 : 0;
        }
    }
    const QString told =
        QString("%1 missed, %2 wrong of %3, seed %4").arg(missed).arg(wrong).arg(asked).arg(test::seed());
    qInfo("%s", qPrintable(told));
    QVERIFY2(wrong == 0, qPrintable(told));
    QVERIFY2(missed <= asked / 600, qPrintable(told));
}

static const test::Registered<DescentTest> registered;
#include "descent_test.moc"
