// Normals and footprints follow the Jacobian of the deformation: against finite differences of what the tools do.
#include "core/sculpt/brush_stamp.h"
#include "core/surfel/shape.h"
#include "sculpt/dabs.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using test::applied;
using test::dabOf;

class JacobianTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void normalsFollowTheTangentsOfEveryFormula();
    void footprintsFollowTheStretchOfArea();
    void ellipsesFollowTheTangentsOfEveryFormula();
    void ellipsesKeepTheirAreaWhereFootprintsDoNotFollow();
    void swollenAndLayeredSpheresHaveTheNormalsOfTheirShape();
    void factorsBendNormalsToo();
    void masksBendNormalsToo();
};

/// Supports of some tests: ellipses that are so much longer along the first tangent than along the second.
constexpr double longer = 2;

/// A surfel and its four neighbours at e along two tangents, numbered by their colours.
static surface::Surface cross5(const base::Vec3d& p, const base::Vec3d& u, const base::Vec3d& v, double e,
                               bool shaped) {
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>(*test::orientedLayout());
    if (shaped)
        surfel::addShape(*layout);
    list.layout = layout;
    std::vector<std::uint32_t> words(layout->words());
    if (shaped)
        surfel::putShape(words, 0, base::cast<float>(v * std::sqrt(longer * longer - 1)));
    const base::Vec3d places[] = {p, p + u * e, p - u * e, p + v * e, p - v * e};
    for (unsigned k = 0; k < 5; ++k) {
        list.append(test::surfelAt(places[k], cross(u, v), 0.02), words);
        list.items.back().colour = k;
    }
    return test::surfaceOf(list);
}

/// One of every kind of movement, strong and with a random direction of the brush.
static Dab randomDab(const ToolRow& row, base::Random& random) {
    Dab dab = dabOf(row, {0.01f, -0.02f, 0.03f}, 0.5f, random.uniform() < 0.5 ? 0.9f : -0.7f);
    dab.areaNormal = base::cast<float>(random.unitVector());
    dab.areaCentre = dab.centre + base::cast<float>(random.unitVector() * 0.05);
    dab.move = base::cast<float>(random.unitVector() * 0.04);
    dab.travel = base::cast<float>(random.unitVector() * 0.05);
    dab.angle = float(random.uniform(-0.6, 0.6));
    dab.footprints = true;
    for (const ToolParameter& p : row.parameters)
        dab.parameters[p.id] = random.uniform() < 0.5 ? p.fallback : 0.5 * (p.fallback + p.max);
    return dab;
}

struct Carried {
    surfel::Surfel centre;
    base::Vec3f shape; ///< of the centre
    base::Vec3d u, v;  ///< tangents after the deformation
    bool moved = false;
};

static Carried carriedBy(const ToolRow& row, const Dab& dab, const surface::Surface& s, double e) {
    Carried out;
    base::Vec3d q[5];
    base::Vec3f start;
    for (const surfel::Surfel& a : s.tree().surfels().items)
        if (a.colour == 0)
            start = a.position;
    const surfel::SurfelList after = applied(row, s, dab).tree().surfels();
    for (std::size_t i = 0; i < after.size(); ++i) {
        const surfel::Surfel& a = after.items[i];
        q[a.colour] = base::cast<double>(a.position);
        if (a.colour != 0)
            continue;
        out.centre = a;
        if (surfel::shapeChannel(*after.layout) > 0)
            out.shape = surfel::shapeIn(after.extraOf(i), surfel::shapeWord(*after.layout));
    }
    out.moved = out.centre.position != start;
    out.u = (q[1] - q[2]) / (2 * e), out.v = (q[3] - q[4]) / (2 * e);
    return out;
}

struct Supports {
    bool shaped = false, follow = true;
};

/// law(row, what the tool made of an orthonormal pair of tangents).
template <class Law>
static void forFormulas(const Law& law, Supports supports = {}) {
    constexpr double e = 3e-4;
    for (const ToolRow& row : toolTable()) {
        if (row.writes != Writes::Shape || std::string(row.id) == "smooth")
            continue;
        base::Random random(test::seed());
        int moved = 0;
        for (int k = 0; k < 300; ++k) {
            const base::Vec3d n = random.unitVector(), u = perpendicular(n), v = cross(n, u);
            const base::Vec3d p = random.unitVector() * (0.45 * std::cbrt(random.uniform()));
            Dab dab = randomDab(row, random);
            dab.footprints = supports.follow;
            const Carried c = carriedBy(row, dab, cross5(p, u, v, e, supports.shaped), e);
            moved += c.moved;
            law(row, c);
        }
        QVERIFY2(moved > 100, row.id);
    }
}

void JacobianTest::normalsFollowTheTangentsOfEveryFormula() {
    forFormulas([](const ToolRow& row, const Carried& c) {
        const double error = length(normalized(cross(c.u, c.v)) - base::cast<double>(c.centre.normal));
        QVERIFY2(error < 1.5e-3, qPrintable(QString("%1: %2, seed %3").arg(row.id).arg(error).arg(test::seed())));
    });
}

void JacobianTest::footprintsFollowTheStretchOfArea() {
    const double before = double(test::surfelAt({}, {}, 0.02).support);
    forFormulas([&](const ToolRow& row, const Carried& c) {
        const double area = length(cross(c.u, c.v)), ratio = double(c.centre.support) / before;
        QVERIFY2(
            std::abs(ratio * ratio - area) < 2e-3,
            qPrintable(QString("%1: %2 of %3, seed %4").arg(row.id).arg(ratio * ratio).arg(area).arg(test::seed())));
    });
}

/// The points of the ellipse go where the tangents take them, along the new normal.
void JacobianTest::ellipsesFollowTheTangentsOfEveryFormula() {
    const double before = double(test::surfelAt({}, {}, 0.02).support);
    int compared = 0;
    forFormulas(
        [&](const ToolRow& row, const Carried& c) {
            QVERIFY2(std::abs(dot(c.shape, c.centre.normal)) < 1e-3f, row.id);
            if (surfel::aspectOf(c.shape) > 0.999f * surfel::mostAspect)
                return; // capped
            ++compared;
            for (int k = 0; k < 8; ++k) {
                const double t = 0.8 * k;
                const base::Vec3d p = c.u * (before * std::cos(t)) + c.v * (before / longer * std::sin(t));
                const double r = std::sqrt(double(surfel::shapedSq(base::cast<float>(p), c.shape)));
                QVERIFY2(
                    std::abs(r / double(c.centre.support) - 1) < 4e-3,
                    qPrintable(
                        QString("%1: %2, seed %3").arg(row.id).arg(r / double(c.centre.support)).arg(test::seed())));
            }
        },
        {true, true});
    QVERIFY(compared > 2000);
}

void JacobianTest::ellipsesKeepTheirAreaWhereFootprintsDoNotFollow() {
    const double before = double(test::surfelAt({}, {}, 0.02).support);
    forFormulas(
        [&](const ToolRow& row, const Carried& c) {
            const double radius = double(c.centre.support), area = radius * radius / double(surfel::aspectOf(c.shape));
            QVERIFY2(std::abs(area * longer / (before * before) - 1) < 1e-4, row.id);
        },
        {true, false});
}

void JacobianTest::swollenAndLayeredSpheresHaveTheNormalsOfTheirShape() {
    // On the unit sphere both tools make the surface of revolution r = 1 + a(angle).
    constexpr std::size_t count = 40000;
    const surface::Surface sphere = test::surfaceOf(test::spherePoints(count));
    for (const char* id : {"inflate", "layer"}) {
        const ToolRow& row = tool(id);
        Dab dab = dabOf(row, {0, 0, 1}, 0.5f, 0.8f);
        const double height = std::string(id) == "layer" ? 0.1 : 0.05;
        const auto profile = [&](double angle) {
            const double r = 2 * std::sin(angle / 2) / double(dab.radius); // chord
            return height * double(dab.strength) * double(dab.radius) * double(weight(Falloff::Smooth, float(r)));
        };
        double worst = 0, worstHeight = 0;
        for (const surfel::Surfel& s : applied(row, sphere, dab).tree().surfels().items) {
            const base::Vec3d p = base::cast<double>(s.position), u = normalized(p);
            const double angle = std::acos(std::min(1.0, u.z)), r = 1 + profile(angle);
            const double slope = (profile(angle + 1e-3) - profile(std::abs(angle - 1e-3))) / 2e-3;
            const base::Vec3d away =
                angle > 1e-6 ? normalized(base::Vec3d{u.x, u.y, 0}) * u.z - base::Vec3d{0, 0, std::sqrt(1 - u.z * u.z)}
                             : base::Vec3d{};
            const base::Vec3d n = normalized(u * r - away * slope);
            worstHeight = std::max(worstHeight, std::abs(length(p) - r));
            worst = std::max(worst, angle > 2e-3 ? length(n - base::cast<double>(s.normal)) : 0.0);
        }
        QVERIFY2(worstHeight < 1e-4 && worst < 3e-3,
                 qPrintable(QString("%1: %2, %3").arg(id).arg(worstHeight).arg(worst)));
    }
}

void JacobianTest::factorsBendNormalsToo() {
    // A stamp's gradient, seen through a tool that has a full Jacobian.
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, 0.02));
    std::vector<float> values;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            values.push_back(0.5f + 0.5f * std::sin(0.8f * float(x)) * std::cos(0.6f * float(y)));
    Dab dab = dabOf(tool("blob"), {}, 0.4f, 1);
    dab.parameters["magnify"] = 0;
    dab.stampRight = {1, 0, 0}, dab.stampUp = {0, 1, 0};
    dab.stamp = std::make_shared<BrushStamp>(16, 16, values);
    const auto after = applied(tool("blob"), plane, dab).tree().surfels().items;
    const auto heightAt = [&](double x, double y) {
        const double r = std::hypot(x, y) / 0.4;
        const auto v = dab.stamp->at(float(x / 0.4), float(y / 0.4));
        return 0.05 * 0.4 * double(weight(Falloff::Smooth, float(r))) * double(v.value);
    };
    for (const surfel::Surfel& s : after) {
        const double x = double(s.position.x), y = double(s.position.y), e = 1e-3;
        const double fx = (heightAt(x + e, y) - heightAt(x - e, y)) / (2 * e),
                     fy = (heightAt(x, y + e) - heightAt(x, y - e)) / (2 * e);
        QVERIFY(std::abs(double(s.position.z) - heightAt(x, y)) < 1e-6);
        QVERIFY(length(normalized(base::Vec3d{-fx, -fy, 1}) - base::cast<double>(s.normal)) < 3e-3);
    }
}

void JacobianTest::masksBendNormalsToo() {
    // Where the mask rises evenly, what it leaves of a flat lift is a slope, and the normals know.
    surfel::SurfelList points = test::planePoints(60, 0.02);
    for (surfel::Surfel& s : points.items)
        s.mask = std::clamp(0.5f + 2 * s.position.x, 0.0f, 1.0f);
    const surface::Surface plane = test::surfaceOf(points);
    for (const char* id : {"draw", "blob"}) { // by one direction, and by a full Jacobian
        Dab dab = dabOf(tool(id), {}, 0.5f, 1);
        dab.falloff = Falloff::Constant;
        if (dab.parameters.contains("magnify"))
            dab.parameters["magnify"] = 0;
        int looked = 0;
        for (const surfel::Surfel& s : applied(tool(id), plane, dab).tree().surfels().items) {
            if (std::abs(s.position.x) > 0.15f || std::abs(s.position.y) > 0.3f)
                continue; // away from the kinks of the mask
            QVERIFY(std::abs(s.position.z - 0.025f * (0.5f - 2 * s.position.x)) < 1e-6f);
            QVERIFY(length(s.normal - normalized(base::Vec3f{0.05f, 0, 1})) < 1e-3f);
            ++looked;
        }
        QVERIFY(looked > 100);
    }
}

static const test::Registered<JacobianTest> registered;
#include "jacobian_test.moc"
