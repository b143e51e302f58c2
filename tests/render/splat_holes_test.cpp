// Splats cover the surface: no pixel inside an outline looks through it, whatever the spacing does.
#include "core/process/estimation/supports.h"
#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class SplatHolesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sphereHasNoHoles_data();
    void sphereHasNoHoles();
    void torusHasNoHoles();
    void spacingThatVariesByFiveLeavesNoHoles();
    void gradedScansHaveNoHoles();
};

/// Every pixel that looks well inside the outline shows the sphere at its depth. `reach`: the splats' radius.
static void checkSphere(const Image& image, const Camera& camera, double reach) {
    int inside = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
            if (!std::isfinite(test::sphereDepth(ray, {0, 0, 0}, 0.98)))
                continue;
            ++inside;
            const double expected = test::sphereDepth(ray, {0, 0, 0}, 1);
            const double slant = -dot(ray.at(expected), ray.direction);
            // A tangent disc leaves the sphere by half the squared way along it, which a pixel of the filter lengthens.
            const double way = std::max(reach, 1.1 * expected / camera.focalPx() / slant);
            const double tolerance = 0.6 * way * way / slant + 1e-5;
            const double depth = image.depth[static_cast<std::size_t>(y * camera.width + x)];
            QVERIFY2(std::abs(depth - expected) < tolerance,
                     qPrintable(QString("%1 %2: %3 for %4").arg(x).arg(y).arg(depth).arg(expected)));
        }
    QVERIFY(inside > 1000);
}

void SplatHolesTest::sphereHasNoHoles_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<float>("scale");
    QTest::addColumn<double>("distance");
    QTest::newRow("coarse") << 2000 << 1.0f << 3.0;
    QTest::newRow("fine") << 100000 << 1.0f << 3.0;
    QTest::newRow("close") << 20000 << 1.0f << 1.3;
    QTest::newRow("far") << 100000 << 1.0f << 12.0;
    QTest::newRow("radius 0.75 s") << 20000 << 0.75f / (splatRadiusOfSupport * test::supportOfSpacing) << 2.0;
}

void SplatHolesTest::sphereHasNoHoles() {
    QFETCH(int, count);
    QFETCH(float, scale);
    QFETCH(double, distance);
    Camera camera = test::cutTilesCamera();
    camera.eye = normalized(Vec3d{1, 2, 3}) * distance;
    RenderOptions options;
    options.splatScale = scale;
    CpuSplatter splatter;
    const auto model = test::built(test::sphere({0, 0, 0}, 1, static_cast<std::size_t>(count)));
    const double s = scale * test::evenSpacing(4 * std::numbers::pi, static_cast<std::size_t>(count));
    checkSphere(test::drawn(splatter, model, camera, options), camera,
                s * test::supportOfSpacing * splatRadiusOfSupport);
}

/// Distance along the ray to the torus, by steps of its distance function; +inf where the ray passes.
static double torusDepth(const base::Rayd& ray, double ring, double tube) {
    double t = 0;
    for (int step = 0; step < 300 && t < 20; ++step) {
        const Vec3d p = ray.at(t);
        const double across = std::sqrt(p.x * p.x + p.z * p.z) - ring;
        const double distance = std::sqrt(across * across + p.y * p.y) - tube;
        if (distance < 1e-6)
            return t;
        t += distance;
    }
    return std::numeric_limits<double>::infinity();
}

void SplatHolesTest::torusHasNoHoles() {
    Camera camera = test::cutTilesCamera();
    const auto model = test::built(test::torus(1, 0.4, 30000, test::seed()));
    CpuSplatter splatter;
    base::Random random(test::seed());
    for (int view = 0; view < 6; ++view) {
        camera.eye = random.unitVector() * 4;
        const Image image = test::drawn(splatter, model, camera);
        int inside = 0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
                const double thin = torusDepth(ray, 1, 0.38), thick = torusDepth(ray, 1, 0.42);
                if (!(std::abs(thin - thick) < 0.3)) // near an outline, or beside the torus
                    continue;
                ++inside;
                const float depth = image.depth[static_cast<std::size_t>(y * camera.width + x)];
                QVERIFY2(depth > thick && depth < thin, qPrintable(QString("view %1 at %2 %3: %4 for %5, seed %6")
                                                                       .arg(view)
                                                                       .arg(x)
                                                                       .arg(y)
                                                                       .arg(depth)
                                                                       .arg(0.5 * (thin + thick))
                                                                       .arg(test::seed())));
            }
        QVERIFY(inside > 1000);
    }
}

void SplatHolesTest::spacingThatVariesByFiveLeavesNoHoles() {
    // Rows of a square whose spacing grows from 0.01 to 0.05 along x; supports follow the wider spacing.
    surfel::SurfelList list;
    list.layout = test::orientedLayout();
    for (double x = -1; x < 1;) {
        const double s = 0.01 + 0.02 * (x + 1);
        for (double y = -1; y < 1; y += s)
            list.items.push_back({base::cast<float>(Vec3d{x, y, 0}),
                                  {0, 0, 1},
                                  static_cast<float>(s) * test::supportOfSpacing,
                                  surfel::white,
                                  0});
        x += s;
    }
    CpuSplatter splatter;
    const Camera camera = test::cutTilesCamera();
    const Image image = test::drawn(splatter, test::built(list), camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
            const Vec3d at = ray.at(-ray.origin.z / ray.direction.z);
            if (std::abs(at.x) < 0.94 && std::abs(at.y) < 0.94)
                QVERIFY(std::isfinite(image.depth[static_cast<std::size_t>(y * camera.width + x)]));
        }
}

/// A scan of a ball as files bring it, without supports, whose spacing grows fivefold from pole to pole at random
/// places that keep a distance: prepared like any model, drawn at rest and coarsely.
void SplatHolesTest::gradedScansHaveNoHoles() {
    base::Random random(test::seed());
    surfel::SurfelList list;
    list.layout = test::orientedLayout();
    std::vector<Vec3d> darts(test::effort(300000));
    const double finest = 0.012 * std::sqrt(300000.0 / double(darts.size()));
    const auto spacing = [&](const Vec3d& d) { return finest * std::pow(5, 0.5 * (d.z + 1)); };
    for (Vec3d& d : darts)
        d = random.unitVector();
    std::sort(darts.begin(), darts.end(), [](const Vec3d& a, const Vec3d& b) { return a.z < b.z; });
    std::vector<Vec3d> apart;
    for (const Vec3d& d : darts) {
        bool free = true;
        for (std::size_t k = apart.size(); free && k-- > 0 && d.z - apart[k].z < 0.8 * spacing(d);)
            free = lengthSq(d - apart[k]) > 0.64 * spacing(d) * spacing(d);
        if (free)
            apart.push_back(d);
    }
    for (const Vec3d& d : apart)
        list.items.push_back({base::cast<float>(d), base::cast<float>(d), 0, surfel::white, 0});
    process::assignSupports(list, {});
    const tree::SurfelTree model = test::built(list);
    float least = 1e9f, most = 0;
    for (const surfel::Surfel& s : list.items)
        least = std::min(least, s.support), most = std::max(most, s.support);
    QVERIFY2(most > 4 * least, qPrintable(QString("%1 %2").arg(least).arg(most)));
    CpuSplatter splatter;
    for (const float detail : {1.0f, 6.0f})
        for (const Vec3d& eye : {Vec3d{0, 0, 2.5}, Vec3d{0, 0, -2.5}, Vec3d{2.4, 0.5, 0}}) {
            Camera camera = test::cutTilesCamera();
            camera.eye = eye;
            camera.up = {0, 1, 0};
            RenderOptions options;
            options.detailPx = detail;
            options.definition.boundaryLimit = 0.3f;
            const Image image = test::drawn(splatter, model, camera, options);
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x)
                    if (std::isfinite(test::sphereDepth(camera.ray(x + 0.5, y + 0.5), {0, 0, 0}, 0.97)))
                        QVERIFY2(
                            std::isfinite(image.depth[static_cast<std::size_t>(y * camera.width + x)]),
                            qPrintable(
                                QString("%1 %2 at detail %3, seed %4").arg(x).arg(y).arg(detail).arg(test::seed())));
        }
}

static const test::Registered<SplatHolesTest> registered;
#include "splat_holes_test.moc"
