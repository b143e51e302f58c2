// Strokes over the edges of a solid: every edge stays one seam from corner to corner, whichever tool goes over it, and
// where one draws it apart.
#include "cells/solids.h"
#include "core/cells/seams.h"
#include "core/sculpt/stroke/stroke.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using namespace plane_solids;
using base::Random;

class SeamStrokesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyEdgeStaysOneSeam_data();
    void everyEdgeStaysOneSeam();
    void edgesThatAreDrawnApartStayOneSeam();
    void smoothingLeavesPlanesAlone();
    void strokesOneAfterAnotherLeaveEveryEdge();
};

namespace {

constexpr double spacing = 0.08, half = 0.8;

/// A cube in any pose, and its axes.
struct Cube {
    Vec3d axes[3];
    surface::Surface surface;

    explicit Cube(Random& random) {
        axes[0] = random.unitVector();
        axes[1] = base::normalized(cross(axes[0], random.unitVector()));
        axes[2] = cross(axes[0], axes[1]);
        std::vector<Plane> planes;
        for (const Vec3d& axis : axes)
            planes.insert(planes.end(), {{axis, half}, {-axis, half}});
        surface = surfaceOf(sampled(intersection(planes), 2 * half, spacing, random).surfels);
    }
};

sculpt::StrokeSettings anyStroke(const char* tool, Random& random) {
    sculpt::StrokeSettings out;
    out.tool = tool;
    out.radius = static_cast<float>(random.uniform(3, 6) * spacing);
    out.strength = static_cast<float>(random.uniform(0.3, 0.6));
    out.invert = random.below(3) == 0;
    return out;
}

/// Slanting over the middle of an edge, seen from outside of it.
surface::Surface stroked(const Cube& cube, const sculpt::StrokeSettings& settings, Random& random) {
    const Vec3d &u = cube.axes[0], &v = cube.axes[1], &w = cube.axes[2], n = base::normalized(u + v);
    const Vec3d middle = (u + v) * half + w * (half * random.uniform(-0.3, 0.3));
    // pulled farther an edge becomes a needle, which no surfels can carry
    const double far = sculpt::tool(settings.tool).motion == sculpt::Motion::Drag ? 0.5 : 1;
    const double angle = random.uniform(0, 2 * pi), reach = far * static_cast<double>(settings.radius);
    const Vec3d way = w * (reach * std::cos(angle)) + base::normalized(u - v) * (reach * std::sin(angle));
    sculpt::Stroke stroke(cube.surface, settings);
    const bool turns = sculpt::tool(settings.tool).motion == sculpt::Motion::Turn;
    for (int k = 0; k <= 8; ++k) {
        const double turn = 0.1 * k;
        const Vec3d aside =
            turns ? w * (reach * std::cos(turn)) + cross(n, w) * (reach * std::sin(turn)) : way * (k / 4.0 - 1);
        const Vec3d eye = middle + (turns && k == 0 ? Vec3d() : aside) + n;
        stroke.add({{base::cast<float>(eye), base::cast<float>(-n)}, 1, 0.03f * static_cast<float>(k)});
    }
    stroke.finish();
    return stroke.surface();
}

/// Empty where the seams are those of a cube: a curve for each edge, from corner to corner.
QByteArray notOfCube(const surface::Surface& surface) {
    const auto cells = cells::CellSurface::of(surface);
    const std::vector<cells::Seam> seams = cells ? cells::traceSeams(*cells) : std::vector<cells::Seam>();
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const cells::Seam& seam : seams)
        pairs.insert(std::minmax(seam.a, seam.b));
    const std::size_t corners = cells::cornersOf(seams).size();
    if (seams.size() == 12 && pairs.size() == 12 && corners == 8)
        return {};
    return QString("%1 curves of %2 pairs, %3 corners, seed %4")
        .arg(seams.size())
        .arg(pairs.size())
        .arg(corners)
        .arg(test::seed())
        .toUtf8();
}

} // namespace

void SeamStrokesTest::everyEdgeStaysOneSeam_data() {
    QTest::addColumn<QByteArray>("tool");
    for (const sculpt::ToolRow& row : sculpt::toolTable()) // draw-sharp: grooves narrower than a support
        if (row.id != std::string_view("draw-sharp") && sculpt::movesSurfaces(row) && !row.needs.layer &&
            !row.needs.source)
            QTest::newRow(row.id) << QByteArray(row.id);
}

void SeamStrokesTest::everyEdgeStaysOneSeam() {
    QFETCH(QByteArray, tool);
    Random random(test::seed());
    const Cube cube(random);
    const QByteArray wrong = notOfCube(stroked(cube, anyStroke(tool.constData(), random), random));
    QVERIFY2(wrong.isEmpty(), wrong);
}

/// Each side of the edge moves away from it: both have to grow towards it, or the edge has nothing beside it.
void SeamStrokesTest::edgesThatAreDrawnApartStayOneSeam() {
    for (unsigned long long k = 0; k < 3; ++k) {
        Random random(test::seed() + k);
        const Cube cube(random);
        sculpt::StrokeSettings settings = anyStroke("inflate", random);
        settings.radius = static_cast<float>(6 * spacing);
        settings.strength = 1;
        settings.invert = false;
        const QByteArray wrong = notOfCube(stroked(cube, settings, random));
        QVERIFY2(wrong.isEmpty(), wrong + ", " + QByteArray::number(k));
    }
}

/// Each cell is drawn to its own surface: edges and corners of planes stay where they are.
void SeamStrokesTest::smoothingLeavesPlanesAlone() {
    Random random(test::seed());
    Cube cube(random);
    sculpt::StrokeSettings settings = anyStroke("smooth", random);
    settings.strength = 1;
    for (int k = 0; k < 3; ++k)
        cube.surface = stroked(cube, settings, random);
    double off = 0, turned = 0;
    cube.surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3d p = base::cast<double>(block.position(slot)), n = base::cast<double>(block.normal(slot));
            const Vec3d axis = *std::max_element(cube.axes, cube.axes + 3, [&](const Vec3d& a, const Vec3d& b) {
                return std::abs(dot(n, a)) < std::abs(dot(n, b));
            });
            off = std::max(off, std::abs(std::abs(dot(p, axis)) - half));
            turned = std::max(turned, 1 - std::abs(dot(n, axis)));
        }
    });
    QVERIFY2(off < 1e-4 * spacing && turned < 1e-6,
             qPrintable(QString("off %1 s, turned %2, seed %3").arg(off / spacing).arg(turned).arg(test::seed())));
}

/// Any tools, over any of the edges.
void SeamStrokesTest::strokesOneAfterAnotherLeaveEveryEdge() {
    Random random(test::seed());
    std::vector<const char*> tools;
    for (const sculpt::ToolRow& row : sculpt::toolTable())
        if (row.id != std::string_view("draw-sharp") && row.writes != sculpt::Writes::Count && !row.needs.layer &&
            !row.needs.source)
            tools.push_back(row.id);
    Cube cube(random);
    for (int k = 0; k < test::effort(8); ++k) {
        std::swap(cube.axes[random.below(3)], cube.axes[2]);
        for (Vec3d& axis : cube.axes)
            axis = random.below(2) == 0 ? axis : -axis;
        sculpt::StrokeSettings settings = anyStroke(tools[random.below(tools.size())], random);
        settings.strength *= 0.5f;
        cube.surface = stroked(cube, settings, random);
        const QByteArray wrong = notOfCube(cube.surface);
        QVERIFY2(wrong.isEmpty(), wrong + ", stroke " + QByteArray::number(k) + " " + settings.tool.c_str());
    }
}

static const test::Registered<SeamStrokesTest> registered;
#include "seam_strokes_test.moc"
