#include "core/base/mat3.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace base;

class Mat3Test : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void eigenvectorsRebuildTheMatrix();
    void closeEigenvaluesKeepTheirDigits();
    void matricesThatAreNotFiniteHaveTheAxes();
    void inversesAndSolvesUndoProducts();
    void cofactorMapsNormalsLikeTheInverseTranspose();
};

static Mat3d randomSymmetric(Random& random) {
    Mat3d a;
    for (int r = 0; r < 3; ++r)
        for (int c = r; c < 3; ++c)
            a[r][c] = a[c][r] = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-6, 6));
    return a;
}

void Mat3Test::eigenvectorsRebuildTheMatrix() {
    Random random(test::seed());
    for (int k = 0; k < 2000; ++k) {
        const Mat3d a = randomSymmetric(random);
        const auto e = symmetricEigen(a);
        QVERIFY(e.value[0] <= e.value[1] && e.value[1] <= e.value[2]);
        Mat3d rebuilt;
        for (int i = 0; i < 3; ++i)
            rebuilt += e.value[i] * outer(e.vector[i], e.vector[i]);
        double scale = 0, error = 0;
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) {
                scale = std::max(scale, std::abs(a[r][c]));
                error = std::max(error, std::abs(a[r][c] - rebuilt[r][c]));
            }
        QVERIFY2(error <= 1e-14 * scale, qPrintable(QString("round %1, seed %2").arg(k).arg(test::seed())));
        QVERIFY(dot(cross(e.vector[0], e.vector[1]), e.vector[2]) > 0.999);
    }
}

void Mat3Test::closeEigenvaluesKeepTheirDigits() {
    Mat3d a = Mat3d::identity();
    const Vec3d n = normalized(Vec3d{1, 2, 3});
    a += -1e-9 * outer(n, n);
    const auto e = symmetricEigen(a);
    QVERIFY(length(cross(e.vector[0], n)) < 1e-6);
}

void Mat3Test::matricesThatAreNotFiniteHaveTheAxes() {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Mat3d a = Mat3d::identity();
        a[0][1] = a[1][0] = bad;
        const auto e = symmetricEigen(a);
        QVERIFY(e.vector[0] == (Vec3d{1, 0, 0}) && e.vector[1] == (Vec3d{0, 1, 0}) && e.vector[2] == (Vec3d{0, 0, 1}));
    }
}

void Mat3Test::inversesAndSolvesUndoProducts() {
    Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        Mat3d a;
        for (auto& row : a.m)
            for (double& value : row)
                value = random.uniform(-1, 1);
        if (std::abs(determinant(a)) < 0.01)
            continue;
        const Vec3d x{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        QVERIFY2(length(inverse(a) * (a * x) - x) < 1e-11, qPrintable(QString("seed %1").arg(test::seed())));
        const Mat3d square = transposed(a) * a;
        QVERIFY2(length(solvePositive(square, square * x) - x) < 1e-8,
                 qPrintable(QString("seed %1").arg(test::seed())));
    }
}

void Mat3Test::cofactorMapsNormalsLikeTheInverseTranspose() {
    const Mat3d f{{{2, 0.3, 0}, {0, 1, -0.2}, {0.1, 0, 0.5}}};
    const Vec3d u{1, 2, 0.5}, v{0, 1, -3};
    const Vec3d mapped = cofactor(f) * cross(u, v), expected = cross(f * u, f * v);
    QVERIFY(length(mapped - expected) < 1e-13);
}

static const test::Registered<Mat3Test> registered;
#include "mat3_test.moc"
