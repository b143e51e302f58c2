// Winding numbers: one inside, none outside, the same in groups as surfel by surfel; areas that add up.
#include "core/surface/winding/winding_number.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/surface/winding/surfel_areas.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using base::Vec3d, base::Vec3f, surface::WindingNumber;

class WindingNumberTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void isOneInsideAndZeroOutside();
    void groupsChangeLittle();
    void gradientIsTheDerivative();
    void areasAddUpWhateverTheSupports();
    void sheetsOfAStackDoNotShareTheirAreas();
    void fewAreasAddUpAsEachDo();
    void straysStandForNothing();
    void sameBitsAtAnyThreadCount();
    void cancellingStops();
};

namespace {

constexpr double spacing = 0.06, major = 1, minor = 0.4;

surfel::SurfelList torus() {
    return shapes::torus(major, minor, spacing, 3.5 * spacing);
}

double torusHeight(const Vec3d& p) {
    return std::hypot(std::hypot(p.x, p.y) - major, p.z) - minor;
}

Vec3d somewhere(base::Random& random) {
    return {random.uniform(-1.6, 1.6), random.uniform(-1.6, 1.6), random.uniform(-0.6, 0.6)};
}

double total(const std::vector<float>& areas) {
    double out = 0;
    for (const float each : areas)
        out += double(each);
    return out;
}

/// The sum itself.
double bySurfels(const tree::SurfelTree& tree, const std::vector<float>& areas, const Vec3d& x) {
    double out = 0;
    std::size_t i = 0;
    for (const surfel::Surfel& s : tree.surfels().items) {
        const Vec3d to = base::cast<double>(s.position) - x;
        const double area = double(areas[i++]);
        out += area * dot(base::cast<double>(s.normal), to) / std::pow(lengthSq(to) + area / 4, 1.5);
    }
    return out / (4 * shapes::pi);
}

} // namespace

void WindingNumberTest::isOneInsideAndZeroOutside() {
    base::Random random(test::seed());
    const WindingNumber winding(tree::SurfelTree::build(torus()));
    for (int i = 0; i < test::effort(3000); ++i) {
        const Vec3d x = somewhere(random);
        const double height = torusHeight(x), w = winding.at(x);
        if (std::abs(height) > 1.5 * spacing)
            QVERIFY2(std::abs(w - (height < 0 ? 1 : 0)) < 0.08, QByteArray::number(w));
        if (std::abs(height) > 0.3 * spacing) // near the surface its side at least
            QVERIFY2((w > 0.5) == (height < 0), QByteArray::number(height / spacing) + " " + QByteArray::number(w));
    }
}

/// Of points in no order, with normals in all directions: nothing cancels.
void WindingNumberTest::groupsChangeLittle() {
    base::Random random(test::seed());
    for (const bool solid : {true, false}) {
        surfel::SurfelList list = torus();
        if (!solid)
            for (surfel::Surfel& s : list.items)
                s.normal = base::normalized(s.normal + base::cast<float>(random.unitVector()) * 0.9f);
        const tree::SurfelTree tree = tree::SurfelTree::build(list);
        const WindingNumber winding(tree);
        const std::vector<float> areas = surface::surfelAreas(tree);
        double most = 0;
        for (int i = 0; i < test::effort(1000); ++i) {
            const Vec3d x = somewhere(random);
            most = std::max(most, std::abs(winding.at(x) - bySurfels(tree, areas, x)));
        }
        QVERIFY2(most < 0.03, QByteArray::number(most));
        QVERIFY(most > 0); // groups there are
    }
}

void WindingNumberTest::gradientIsTheDerivative() {
    base::Random random(test::seed());
    const WindingNumber winding(tree::SurfelTree::build(torus()));
    constexpr double step = 2e-3;
    int off = 0;
    for (int i = 0; i < test::effort(200); ++i) {
        const Vec3d x = somewhere(random), along = random.unitVector();
        const double difference = (winding.at(x + along * step) - winding.at(x - along * step)) / (2 * step);
        const double slope = dot(winding.gradient(x), along);
        off += std::abs(difference - slope) > 0.01 / spacing ? 1 : 0;
    }
    // where a group opens between the two places there is a step
    QVERIFY2(off <= test::effort(200) / 20, QByteArray::number(off));
}

/// And copies share what one would have.
void WindingNumberTest::areasAddUpWhateverTheSupports() {
    const double exact = 4 * shapes::pi * shapes::pi * major * minor;
    for (const double support : {1.3, 1.5, 2.5, 3.5, 6.0}) // those of reduced models hold few surfels, and no copies
        for (const int copies : {1, support < 2 ? 1 : 3}) {
            surfel::SurfelList list;
            list.layout = shapes::layout(true, true);
            for (const surfel::Surfel& s : shapes::torus(major, minor, spacing, support * spacing).items)
                list.items.insert(list.items.end(), std::size_t(copies), s);
            const double sum = total(surface::surfelAreas(tree::SurfelTree::build(list)));
            QVERIFY2(std::abs(sum / exact - 1) < 0.1, QByteArray::number(sum / exact));
        }
}

/// That face alike, as every other wall of a comb does; in any direction.
void WindingNumberTest::sheetsOfAStackDoNotShareTheirAreas() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(10); ++round) {
        const double apart = random.uniform(1.5, 3) * spacing;
        const Vec3d up = random.unitVector(), u = base::normalized(cross(up, random.unitVector())), v = cross(up, u);
        surfel::SurfelList list;
        list.layout = shapes::layout(true, true);
        for (int sheet = 0; sheet < 4; ++sheet)
            for (int i = 0; i < 30; ++i)
                for (int j = 0; j < 30; ++j)
                    list.items.push_back(shapes::surfelAt(
                        up * (sheet * apart) +
                            (u * (i + random.uniform(-0.3, 0.3)) + v * (j + random.uniform(-0.3, 0.3))) * spacing,
                        up, 3.5 * spacing));
        const double exact = double(list.size()) * spacing * spacing;
        const double sum = total(surface::surfelAreas(tree::SurfelTree::build(list)));
        // more at the rims; farther along the sheet than above it, neighbours still count
        QVERIFY2(sum / exact > 0.82 && sum / exact < 1.25, QByteArray::number(sum / exact) + " apart " +
                                                               QByteArray::number(apart / spacing) + " seed " +
                                                               QByteArray::number(test::seed()));
    }
}

/// Where supports follow the spacing, which varies by 4 here.
void WindingNumberTest::fewAreasAddUpAsEachDo() {
    base::Random random(test::seed());
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    for (double x = 0; x < 2;) {
        const double step = spacing * (1 + 1.5 * x);
        for (double y = 0; y < 2; y += step)
            list.items.push_back(shapes::surfelAt({x + random.uniform(0, 0.3) * step, y, 0}, {0, 0, 1}, 3.5 * step));
        x += step;
    }
    const tree::SurfelTree tree = tree::SurfelTree::build(list);
    const double each = total(surface::surfelAreas(tree)),
                 few = total(surface::surfelAreas(tree, {}, surface::Areas::Few));
    QVERIFY2(std::abs(few / each - 1) < 0.1, QByteArray::number(few / each));
}

void WindingNumberTest::straysStandForNothing() {
    surfel::SurfelList list = torus();
    const double before = total(surface::surfelAreas(tree::SurfelTree::build(list)));
    for (const double x : {3.0, 4.0, 5.0})
        list.items.push_back(shapes::surfelAt({x, 0, 0}, {1, 0, 0}, 3.5 * spacing));
    const double after = total(surface::surfelAreas(tree::SurfelTree::build(list)));
    QVERIFY2(std::abs(after - before) < 1e-6 * before, QByteArray::number(after - before));
}

void WindingNumberTest::sameBitsAtAnyThreadCount() {
    const tree::SurfelTree tree = tree::SurfelTree::build(torus());
    const int threads = base::threadCount();
    base::setThreadCount(1);
    const std::vector<float> one = surface::surfelAreas(tree);
    base::setThreadCount(2);
    const std::vector<float> two = surface::surfelAreas(tree);
    base::setThreadCount(threads);
    QVERIFY(one == two);
}

void WindingNumberTest::cancellingStops() {
    const std::atomic<bool> cancel = true;
    QVERIFY_EXCEPTION_THROWN(WindingNumber(tree::SurfelTree::build(torus()), base::Progress{{}, &cancel}),
                             base::Cancelled);
}

static const test::Registered<WindingNumberTest> registered;
#include "winding_number_test.moc"
