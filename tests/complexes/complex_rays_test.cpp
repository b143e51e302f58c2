// Rays and complexes: none is lost, none hits what is not there, closed ones are met in pairs.
#include "core/complexes/complex_rays.h"

#include "complexes/sample_complexes.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/complexes/complex_projection.h"
#include "support/registry.h"

#include <QTest>

using base::Random, base::Rayd, base::Vec3d;
using complexes::Complex;

class ComplexRaysTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aSquareIsHitWhereItIs();
    void theGasketIsHitWhereItIs();
    void flatSolidsAreHitExactly();
    void noRaySlipsThroughEdges_data();
    void noRaySlipsThroughEdges();
    void closedOnesAreMetInPairs();
    void firstHitsAreTheFirstOfAll();
    void hitsAreFeet();
    void threadsDoNotShow();
};

static Rayd towards(const Vec3d& target, const Vec3d& direction, double from) {
    const Vec3d d = normalized(direction);
    return {target - d * from, d};
}

void ComplexRaysTest::aSquareIsHitWhereItIs() {
    const Complex square = complex_models::complexOf("square", 1500);
    Random random(test::seed());
    for (int k = 0; k < test::effort(600); ++k) {
        const Vec3d target{random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), 0};
        const Rayd ray = towards(target, {random.normal() * 0.4, random.normal() * 0.4, -1}, 3);
        const bool there = std::abs(target.x) <= 1 && std::abs(target.y) <= 1;
        const auto hit = intersectReference(square, ray);
        QVERIFY2(hit.hit == there, qPrintable(QString("%1 %2, seed %3").arg(target.x).arg(target.y).arg(test::seed())));
        if (there)
            QVERIFY(base::distance(hit.position, target) < 1e-12);
    }
}

/// Is a place of the plane in Sierpinski's triangle of the sample?
static bool inGasket(const Vec3d& p) {
    const double high = std::sqrt(0.75), v = (p.y + high) / (2 * high), u = (p.x + 1 - v) / 2;
    double l[3] = {1 - u - v, u, v};
    if (l[0] < 0 || l[1] < 0 || l[2] < 0)
        return false;
    for (int depth = 0; depth < 3; ++depth) {
        bool any = false;
        for (double& each : l) {
            each *= 2;
            any = any || each >= 1;
        }
        if (!any)
            return false;
        for (double& each : l)
            each -= each >= 1 ? 1 : 0;
    }
    return true;
}

void ComplexRaysTest::theGasketIsHitWhereItIs() {
    const Complex gasket = complex_models::complexOf("gasket", 5000);
    Random random(test::seed());
    for (int k = 0; k < test::effort(600); ++k) {
        const Vec3d target{random.uniform(-1, 1), random.uniform(-0.87, 0.87), 0};
        const Rayd ray = towards(target, {random.normal() * 0.3, random.normal() * 0.3, -1}, 3);
        QVERIFY2(intersectReference(gasket, ray).hit == inGasket(target),
                 qPrintable(QString("%1 %2, seed %3").arg(target.x).arg(target.y).arg(test::seed())));
    }
}

void ComplexRaysTest::flatSolidsAreHitExactly() {
    const Complex solid = complex_models::complexOf("icosahedron", 3000);
    const auto faces = complex_models::facesOf(solid);
    Random random(test::seed());
    for (int k = 0; k < test::effort(300); ++k) {
        const Rayd ray = towards(random.unitVector() * random.uniform(0, 0.7), random.unitVector(), 3);
        double enter = 0;
        Vec3d normal;
        for (const auto& face : faces) {
            Vec3d n = normalized(cross(face[1] - face[0], face[2] - face[0]));
            n = dot(n, face[0]) < 0 ? -n : n;
            if (const double fall = dot(n, ray.direction); fall < 0)
                if (const double t = dot(n, face[0] - ray.origin) / fall; t > enter) {
                    enter = t;
                    normal = n;
                }
        }
        const auto hit = intersectReference(solid, ray);
        QVERIFY2(hit.hit && std::abs(hit.t - enter) < 1e-6,
                 qPrintable(QString("%1 at %2, seed %3").arg(hit.hit).arg(hit.t - enter).arg(test::seed())));
        QVERIFY(length(cross(hit.normal, normal)) < 1e-5 || base::distance(hit.position, ray.at(enter)) < 1e-6);
    }
}

void ComplexRaysTest::noRaySlipsThroughEdges_data() {
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"octant", "icosahedron", "bulged", "rounded", "cone"})
        QTest::newRow(sample) << QString(sample);
}

void ComplexRaysTest::noRaySlipsThroughEdges() {
    QFETCH(QString, sample);
    const Complex complex = complex_models::complexOf(sample.toUtf8(), 2500);
    Random random(test::seed());
    for (std::uint32_t curve = 0; curve < complex.cells().size(); ++curve) {
        const auto& ends = complex[curve].boundary;
        const auto patches = std::count_if(complex.cells().begin(), complex.cells().end(), [&](const auto& cell) {
            return cell.dimension == 2 && std::count(cell.boundary.begin(), cell.boundary.end(), curve) > 0;
        });
        if (complex[curve].dimension != 1 || patches != 2) // of the cone's rim one
            continue;
        for (int k = 0; k < test::effort(20); ++k) {
            const double share = random.uniform(0.02, 0.98);
            const auto foot =
                footOn(complex, curve, complex.place(ends[0]) * share + complex.place(ends[1]) * (1 - share),
                       {surface::Projector::Almost, true, true, {}});
            QVERIFY(foot.ok());
            // from outside through a place just inside of the edge
            const Vec3d inwards =
                normalized(Vec3d{0.25, 0.25, 0.25} * (sample == "octant" ? 1.0 : 0.0) - foot.position);
            const Vec3d target = foot.position + inwards * (0.002 * foot.unit);
            const Rayd ray = towards(target, inwards + random.unitVector() * 0.3, 2);
            const auto hit = intersectReference(complex, ray);
            QVERIFY2(hit.hit && hit.t < 2 + 0.5 * foot.unit,
                     qPrintable(QString("curve %1, seed %2").arg(curve).arg(test::seed())));
        }
    }
}

void ComplexRaysTest::closedOnesAreMetInPairs() {
    for (const char* sample : {"octant", "icosahedron", "rounded"}) {
        const Complex complex = complex_models::complexOf(sample, 2500);
        Random random(test::seed());
        int odd = 0;
        const int tries = test::effort(200);
        for (int k = 0; k < tries; ++k) {
            const Rayd ray = towards(random.unitVector() * 0.4, random.unitVector(), 4);
            odd += static_cast<int>(intersectAllReference(complex, ray).size() % 2);
        }
        QVERIFY2(odd <= tries / 100, qPrintable(QString("%1: %2 odd, seed %3").arg(sample).arg(odd).arg(test::seed())));
    }
}

void ComplexRaysTest::firstHitsAreTheFirstOfAll() {
    for (const char* sample : {"octant", "gasket", "rounded", "cone"}) {
        const Complex complex = complex_models::complexOf(sample, 2500);
        Random random(test::seed());
        for (int k = 0; k < test::effort(100); ++k) {
            // from within at times
            const Rayd ray = towards(random.unitVector() * 0.5, random.unitVector(), random.uniform(0, 3));
            const auto first = intersectReference(complex, ray);
            const auto all = intersectAll(complex, ray);
            const QByteArray where = QString("%1, seed %2").arg(sample).arg(test::seed()).toUtf8();
            QVERIFY2(first.hit == !all.empty(), where);
            QVERIFY2(all.empty() || (first.t == all[0].hit.t && first.normal == all[0].hit.normal), where);
            const bool any = std::any_of(all.begin(), all.end(), [](const auto& each) {
                return each.hit.t > surface::secondaryEpsilon * each.hit.unit * surface::spacingOfUnit;
            });
            QVERIFY2(intersectAnyReference(complex, ray) == any, where);
        }
    }
}

void ComplexRaysTest::hitsAreFeet() {
    for (const char* sample : {"octant", "bulged", "cone"}) {
        const Complex complex = complex_models::complexOf(sample, 2500);
        Random random(test::seed());
        for (int k = 0; k < test::effort(100); ++k) {
            const Rayd ray = towards(random.unitVector() * 0.2, random.unitVector(), 4);
            const auto hit = intersectReference(complex, ray);
            if (!hit.hit)
                continue;
            const complexes::CellFoot foot = project(complex, hit.position, surface::Projector::Almost);
            QVERIFY2(foot.ok() && base::distance(foot.position, hit.position) < 1e-6 * hit.unit,
                     qPrintable(QString("%1, seed %2").arg(sample).arg(test::seed())));
            QVERIFY(dot(hit.normal, ray.direction) <= 0);
        }
    }
}

void ComplexRaysTest::threadsDoNotShow() {
    const Complex complex = complex_models::complexOf("octant", 1500);
    Random random(test::seed());
    std::vector<base::Rayf> rays;
    for (int k = 0; k < 200; ++k) {
        const Rayd ray = towards(random.unitVector() * 0.5, random.unitVector(), 3);
        rays.push_back({base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
    }
    std::vector<surface::RayHit<float>> one(rays.size()), two(rays.size());
    base::setThreadCount(1);
    intersect(complex, rays, {}, one);
    base::setThreadCount(2);
    intersect(complex, rays, {}, two);
    base::setThreadCount(0);
    for (std::size_t i = 0; i < rays.size(); ++i)
        QVERIFY(one[i].hit == two[i].hit && one[i].t == two[i].t && one[i].normal == two[i].normal);
}

static const test::Registered<ComplexRaysTest> registered;
#include "complex_rays_test.moc"
