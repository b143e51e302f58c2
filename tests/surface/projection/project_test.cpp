// Projections: what their feet promise, where they start from, and what they say when they fail.
#include "core/surface/projection/project.h"

#include "core/surface/definition_text.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <cstring>
#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;

class ProjectTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void feetKeepTheirPromise_data();
    void feetKeepTheirPromise();
    void projectingAFootMovesNothing();
    void orthogonalFootIsTheClosestPoint();
    void positionsOutsideStartFromTheNearestSurfel();
    void curvedBasinsConvergeWithDamping();
    void feetBeyondTheBoundarySaySo();
    void batchGivesTheBitsOfSingles();
    void emptySurfaceAnswersOutside();
};

void ProjectTest::feetKeepTheirPromise_data() {
    QTest::addColumn<int>("projector");
    for (const auto& projector : projectorNames())
        QTest::addRow("%s", projector.name) << static_cast<int>(projector.value);
}

void ProjectTest::feetKeepTheirPromise() {
    QFETCH(int, projector);
    const double h = 0.25;
    ProjectOptions options;
    options.projector = static_cast<Projector>(projector);
    for (const bool shrinkFree : {false, true}) {
        SurfaceDefinition definition;
        definition.shrinkFree = shrinkFree;
        const Surface surface =
            shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.5, 0.07, h), 0.01, test::seed()), definition);
        base::Random random(test::seed() + 1);
        const auto list = surface.tree().surfels();
        for (int i = 0; i < 200; ++i) {
            const Vec3d x = base::cast<double>(list.items[random.below(list.size())].position) +
                            random.unitVector() * random.uniform(0, 0.5 * h);
            const Projection<double> p = projectReference(surface, x, options);
            QVERIFY2(p.ok(), statusName(p.status));
            QVERIFY(std::abs(p.at.value) <= 1e-11 * h);
            const Vec3d away = base::normalized(x - p.foot);
            if (options.projector == Projector::Almost)
                QVERIFY(length(cross(away, p.at.normal)) * distance(x, p.foot) <= 1e-10 * h);
            if (options.projector == Projector::Orthogonal)
                QVERIFY(length(cross(away, base::normalized(p.at.gradient))) * distance(x, p.foot) <= 1e-10 * h);
            const Projection<float> f = project(surface, base::cast<float>(x), options);
            QVERIFY2(f.ok(), statusName(f.status));
            QVERIFY(distance(base::cast<double>(f.foot), p.foot) <= 2e-5 * h);
        }
    }
}

void ProjectTest::projectingAFootMovesNothing() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.5, 0.07, 0.25), 0.01, 1));
    const auto list = surface.tree().surfels();
    base::Random random(test::seed());
    for (const auto& projector : projectorNames())
        for (int i = 0; i < 100; ++i) {
            const Vec3f x =
                list.items[random.below(list.size())].position + base::cast<float>(random.unitVector() * 0.05);
            ProjectOptions options;
            options.projector = projector.value;
            const Projection<float> once = project(surface, x, options), twice = project(surface, once.foot, options);
            QVERIFY(once.ok() && twice.ok());
            QVERIFY2(once.foot == twice.foot, projector.name);
        }
}

void ProjectTest::orthogonalFootIsTheClosestPoint() {
    const Surface surface = shapes::surfaceOf(shapes::torus(1, 0.5, 0.07, 0.25));
    base::Random random(test::seed());
    for (int i = 0; i < 50; ++i) {
        const double u = random.uniform(0, 6.28), v = random.uniform(0, 6.28), r = 0.5 + random.uniform(-0.1, 0.1);
        const Vec3d x{(1 + r * std::cos(v)) * std::cos(u), (1 + r * std::cos(v)) * std::sin(u), r * std::sin(v)};
        const Projection<double> p = projectReference(surface, x);
        QVERIFY(p.ok());
        ProjectOptions basic;
        basic.projector = Projector::Basic;
        for (int k = 0; k < 20; ++k) {
            const Projection<double> other = projectReference(surface, p.foot + random.unitVector() * 0.02, basic);
            QVERIFY(other.ok());
            QVERIFY(distance(x, other.foot) >= distance(x, p.foot) - 1e-12);
        }
    }
}

void ProjectTest::positionsOutsideStartFromTheNearestSurfel() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, 0.2));
    base::Random random(test::seed());
    for (const auto& projector : projectorNames())
        for (int i = 0; i < 100; ++i) {
            ProjectOptions options;
            options.projector = projector.value;
            const Vec3d direction = random.unitVector(), x = direction * random.uniform(1.3, 4);
            QCOMPARE(surface.evaluateReference(x).status, Status::Outside);
            const Projection<double> p = projectReference(surface, x, options);
            QVERIFY2(p.ok(), qPrintable(QString("%1 %2").arg(projector.name).arg(statusName(p.status))));
            QVERIFY(std::abs(length(p.foot) - 1) < 1e-4);
            if (projector.value == Projector::Orthogonal)
                QVERIFY(distance(p.foot, direction * length(p.foot)) < 2e-3);
            const Projection<float> f = project(surface, base::cast<float>(x), options);
            QVERIFY2(f.ok(), qPrintable(QString("%1 %2").arg(projector.name).arg(statusName(f.status))));
            QVERIFY(std::abs(length(f.foot) - 1) < 1e-4f);
        }
}

/// From inside a sphere at |e| kappa up to 0.55 the plain iteration converges slowly; it must converge, or say it did
/// not.
void ProjectTest::curvedBasinsConvergeWithDamping() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(1200, 1, 0.8));
    base::Random random(test::seed());
    for (int i = 0; i < 100; ++i) {
        const Vec3d direction = random.unitVector();
        const Projection<float> p = project(surface, base::cast<float>(direction * random.uniform(0.65, 1.6)));
        QVERIFY2(p.ok(), qPrintable(QString("%1 after %2").arg(statusName(p.status)).arg(p.iterations)));
        QVERIFY(distance(base::cast<double>(p.foot), direction * double(length(p.foot))) < 0.02);
    }
}

void ProjectTest::feetBeyondTheBoundarySaySo() {
    SurfaceDefinition definition;
    definition.boundary = Boundary::Limit;
    definition.boundaryLimit = 0.3f;
    const Surface surface = shapes::surfaceOf(shapes::plane(15, 0.1, 0.35), definition);
    ProjectOptions unchecked;
    unchecked.checkBoundary = false;
    for (const float x : {1.0f, 1.75f}) {
        const Projection<float> p = project(surface, {x, 0.1f, 0.1f});
        QCOMPARE(p.status, x < 1.5f ? Status::Ok : Status::BeyondBoundary);
        QVERIFY(project(surface, {x, 0.1f, 0.1f}, unchecked).ok());
        QVERIFY(distance(p.foot, Vec3f{x, 0.1f, 0}) < 1e-5f);
    }
}

void ProjectTest::batchGivesTheBitsOfSingles() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.5, 0.05, 0.17), 0.01, 1));
    const auto list = surface.tree().surfels();
    base::Random random(test::seed());
    std::vector<Vec3f> x;
    for (int i = 0; i < 2000; ++i)
        x.push_back(list.items[random.below(list.size())].position +
                    base::cast<float>(random.unitVector() * (i % 50 == 0 ? 0.5 : 0.03)));
    for (const auto& projector : projectorNames()) {
        ProjectOptions options;
        options.projector = projector.value;
        std::vector<Projection<float>> out(x.size());
        project(surface, x, options, out);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Projection<float> single = project(surface, x[i], options);
            QVERIFY(out[i].status == single.status && out[i].foot == single.foot &&
                    out[i].iterations == single.iterations && out[i].at.gradient == single.at.gradient);
        }
    }
}

void ProjectTest::emptySurfaceAnswersOutside() {
    QCOMPARE(project(Surface(), {1, 2, 3}).status, Status::Outside);
    QCOMPARE(projectReference(Surface(), {1, 2, 3}).status, Status::Outside);
}

static const test::Registered<ProjectTest> registered;
#include "project_test.moc"
