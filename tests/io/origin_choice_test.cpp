#include "core/io/origin_choice.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <algorithm>

using base::Vec3d;

class OriginChoiceTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void modelsNearZeroKeepTheirCoordinates();
    void farModelsGetARoundedMiddle();
    void floatErrorIsSmallAfterwards();
    void fewStrayPointsDoNotDecide();
};

static std::vector<Vec3d> cloud(base::Random& random, const Vec3d& centre, double radius, std::size_t n) {
    std::vector<Vec3d> out;
    for (std::size_t i = 0; i < n; ++i)
        out.push_back(centre + random.unitVector() * radius);
    return out;
}

void OriginChoiceTest::modelsNearZeroKeepTheirCoordinates() {
    base::Random random(test::seed());
    for (const double radius : {1e-6, 0.1, 1.0, 5e5, 1e12})
        for (const double away : {0.0, 1.0, 5.0})
            QCOMPARE(io::chooseOrigin(cloud(random, Vec3d{radius * away, 0, 0}, radius, 4000), 4000), Vec3d());
    QCOMPARE(io::chooseOrigin({}, 0), Vec3d());
    QCOMPARE(io::chooseOrigin(std::vector<Vec3d>(5, Vec3d{1, 2, 3}), 5), Vec3d());
}

void OriginChoiceTest::farModelsGetARoundedMiddle() {
    base::Random random(test::seed());
    const Vec3d origin = io::chooseOrigin(cloud(random, {665184.3, 5648352.7, 243.1}, 8, 4000), 4000);
    QCOMPARE(origin, Vec3d({665180, 5648350, 240}));
}

void OriginChoiceTest::floatErrorIsSmallAfterwards() {
    base::Random random(test::seed());
    for (int round = 0; round < 200; ++round) {
        const double radius = std::pow(10.0, random.uniform(-3, 4));
        const Vec3d centre = random.unitVector() * std::pow(10.0, random.uniform(0, 9));
        const std::size_t n = 4000;
        const auto points = cloud(random, centre, radius, n);
        const Vec3d origin = io::chooseOrigin(points, n);
        double worst = 0;
        for (const Vec3d& p : points) {
            const Vec3d inside = base::cast<double>(base::cast<float>(p - origin)) + origin;
            for (std::size_t k = 0; k < 3; ++k)
                worst = std::max(worst, std::abs(inside[k] - p[k]));
        }
        // Either a ten-thousandth of the spacing (2 r / sqrt n), or as good as float is a few extents from zero.
        const double spacing = 2 * radius / std::sqrt(double(n));
        const double allowed = std::max({1.1e-4 * spacing, 17 * radius * 0x1p-24, base::length(centre) * 0x1p-50});
        QVERIFY2(worst <= allowed, qPrintable(QString("round %1, seed %2").arg(round).arg(test::seed())));
    }
}

void OriginChoiceTest::fewStrayPointsDoNotDecide() {
    base::Random random(test::seed());
    auto points = cloud(random, {3e6, 5e6, 100}, 20, 4000);
    for (std::size_t i = 0; i < 20; ++i)
        points[i * 7] = {};
    QVERIFY(base::distance(io::chooseOrigin(points, points.size()), Vec3d{3e6, 5e6, 100}) < 40);
}

static const test::Registered<OriginChoiceTest> registered;
#include "origin_choice_test.moc"
