// The least direction of a covariance, against the full decomposition.
#include "core/base/random.h"
#include "core/process/estimation/least_direction.h"
#include "support/registry.h"

#include <QTest>

using base::Mat3d, base::Vec3d;

class LeastDirectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void clearDirectionsAreFound();
    void unclearOnesAreThoseOfTheFullDecomposition();
};

namespace {

/// With these eigenvalues along an orthogonal frame of any direction; `out`: that of the first.
Mat3d covarianceOf(const Vec3d& values, base::Random& random, Vec3d& out) {
    out = random.unitVector();
    const Vec3d u = base::normalized(cross(out, random.unitVector())), v = cross(out, u);
    Mat3d m;
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            m.m[r][c] = values.x * out[r] * out[c] + values.y * u[r] * u[c] + values.z * v[r] * v[c];
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < r; ++c)
            m.m[r][c] = m.m[c][r];
    return m;
}

} // namespace

void LeastDirectionTest::clearDirectionsAreFound() {
    base::Random random(test::seed());
    for (int round = 0; round < 20000; ++round) {
        const double scale = std::pow(10.0, random.uniform(-30, 12)), middle = std::pow(10.0, random.uniform(-3, 0));
        const double least = round % 3 == 0 ? 0 : middle * random.uniform(0, 0.8);
        Vec3d expected;
        const Mat3d m = covarianceOf({least * scale, middle * scale, scale}, random, expected);
        const Vec3d found = process::leastDirection(m);
        const double off = length(cross(found, expected));
        QVERIFY2(off < 1e-9 && std::abs(lengthSq(found) - 1) < 1e-12,
                 qPrintable(QString("%1 rad, least %2, middle %3, round %4, seed %5")
                                .arg(off)
                                .arg(least)
                                .arg(middle)
                                .arg(round)
                                .arg(test::seed())));
    }
}

void LeastDirectionTest::unclearOnesAreThoseOfTheFullDecomposition() {
    base::Random random(test::seed());
    Vec3d any;
    for (const Vec3d& values : {Vec3d{0, 0, 0}, {1, 1, 1}, {0, 0, 1}, {1e-6, 2e-6, 1}, {0.5, 0.5, 1}}) {
        const Mat3d m = covarianceOf(values, random, any);
        QVERIFY(process::leastDirection(m) == base::symmetricEigen(m).vector[0]);
    }
}

static const test::Registered<LeastDirectionTest> registered;
#include "least_direction_test.moc"
