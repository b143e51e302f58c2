// Creases of steps that run out: below and above of a narrow wall is one face, whose samples tell of two sheets.
#include "core/base/random.h"
#include "core/cells/cell_rays.h"
#include "core/cells/cell_section.h"
#include "mesh/creased_faces.h"
#include "support/registry.h"

#include <QTest>

using namespace faces;
using cells::Label;
using cells::Meeting;

class StepCreasesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void stepsThatRunOutKeepBothLevelsApart();
    void stepsThatRunOutAreCutAlongOneCurve();
};

namespace {

/// A step that grows out of a smooth sheet: its wall begins with no width, and the sheet is below and above it.
Faces step(base::Random& random) {
    constexpr int n = 40, side = 24, wall = 4, columns = 2 * side + wall;
    const double rise = random.uniform(0.2, 0.5), from = random.uniform(-0.6, 0), slant = random.uniform(0.3, 1.2),
                 bend = random.uniform(-0.2, 0.2), fall = random.uniform(0, 1);
    Faces out;
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= columns; ++k) {
            const double x = -1 + 2.0 * i / n, begin = bend * x * x, d = std::max(0.0, x - from);
            const double h = rise * d * (d + 0.15), wide = slant * h;
            double y = 0, up = 0;
            if (k <= side) {
                y = -1 + (begin + 1) * k / side;
            } else if (k <= side + wall) {
                const double part = static_cast<double>(k - side) / wall;
                y = begin + wide * part, up = h * part;
            } else {
                const double part = static_cast<double>(k - side - wall) / side;
                y = begin + wide + (1 - begin - wide) * part, up = h * (1 - fall * part * part);
            }
            out.positions.push_back(base::cast<float>(Vec3d{x, y, 0.1 * x * y + 0.05 * y * y + up}));
        }
    const auto at = [](int i, int k) { return static_cast<std::uint32_t>(i * (columns + 1) + k); };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < columns; ++k) {
            out.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            out.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    return out;
}

/// Where a ray first meets triangles; infinity where it does not.
double firstHit(const Faces& f, const base::Rayd& ray) {
    double out = std::numeric_limits<double>::infinity();
    for (const mesh::Triangle& t : f.triangles) {
        const auto at = [&](std::size_t k) { return base::cast<double>(f.positions[t[k]]); };
        const Vec3d u = at(1) - at(0), v = at(2) - at(0), p = cross(ray.direction, v), q = ray.origin - at(0),
                    r = cross(q, u);
        const double det = dot(u, p), b = dot(q, p) / det, c = dot(ray.direction, r) / det, hit = dot(v, r) / det;
        if (det != 0 && b >= 0 && c >= 0 && b + c <= 1 && hit > 0)
            out = std::min(out, hit);
    }
    return out;
}

/// Sampled, with its cells.
struct Step {
    Faces faces;
    surfel::SurfelList points;
    cells::CellSurface cells;

    explicit Step(base::Random& random)
        : faces(step(random)), points(openedFaces(faces, 1600).points), cells(cellsOf(points)) {}

  private:
    static cells::CellSurface cellsOf(const surfel::SurfelList& points) {
        surface::SurfaceDefinition definition;
        definition.boundary = surface::Boundary::None;
        return *cells::CellSurface::of({tree::SurfelTree::build(points), definition});
    }
};

} // namespace

/// Below and above of a narrow wall is one face, whose samples tell of two sheets.
void StepCreasesTest::stepsThatRunOutKeepBothLevelsApart() {
    base::Random random(test::seed());
    int rays = 0, lost = 0;
    double squares = 0;
    for (int round = 0; round < test::effort(5); ++round) {
        const Step step(random);
        const std::vector<Label> labels = labelsOf(step.points);
        for (int k = 0; k < 400; ++k) {
            const std::size_t i = random.below(labels.size());
            const double spacing = static_cast<double>(step.points.items[i].support) / 3.5;
            const Vec3d target =
                base::cast<double>(step.points.items[i].position) + random.unitVector() * (spacing * random.uniform());
            const Vec3d d = base::normalized(Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), -1});
            if (labels[i].meeting == Meeting::None || std::max(std::abs(target.x), std::abs(target.y)) > 0.8)
                continue;
            const base::Rayd ray{target - d * 2, d};
            const double t = firstHit(step.faces, ray),
                         beside = firstHit(step.faces, {ray.origin + Vec3d{0, 0.05 * spacing, 0}, d});
            if (!(std::abs(t - beside) < spacing))
                continue;
            ++rays;
            const cells::CellHit hit = intersectCells(step.cells, ray);
            if (!hit.hit.hit || std::abs(hit.hit.t - t) > spacing)
                ++lost;
            else
                squares += (hit.hit.t - t) * (hit.hit.t - t) / (spacing * spacing);
        }
    }
    const double rms = std::sqrt(squares / rays);
    const QByteArray told =
        QString("seed %1: %2 rays, %3 lost, rms %4 spacings").arg(test::seed()).arg(rays).arg(lost).arg(rms).toUtf8();
    qInfo() << told;
    QVERIFY(rays > test::effort(5) * 20);
    QVERIFY2(lost <= 1 + rays / 300 && rms < 0.045, told);
}

/// Where bands and faces go on into one another each has a stretch of the curve.
void StepCreasesTest::stepsThatRunOutAreCutAlongOneCurve() {
    base::Random random(test::seed());
    const auto lengthWithin = [](Vec3d a, Vec3d b) { // beyond, the surface ends in air
        constexpr double within = 0.85;
        if (a.y > b.y)
            std::swap(a, b);
        const double from = std::max(a.y, -within), to = std::min(b.y, within);
        return from < to ? base::distance(a, b) * (to - from) / (b.y - a.y) : 0;
    };
    for (int round = 0; round < test::effort(4); ++round) {
        const Step step(random);
        for (int k = 0; k < 8; ++k) {
            const Vec3d n = base::normalized(Vec3d{1, random.uniform(-0.4, 0.4), random.uniform(-0.3, 0.3)});
            const base::Plane plane{n, dot(n, Vec3d{random.uniform(-0.4, 0.6), 0, 0})};
            double expected = 0;
            for (const mesh::Triangle& t : step.faces.triangles) {
                std::vector<Vec3d> ends;
                for (std::size_t e = 0; e < 3; ++e) {
                    const Vec3d a = base::cast<double>(step.faces.positions[t[e]]),
                                b = base::cast<double>(step.faces.positions[t[(e + 1) % 3]]);
                    if ((plane.distance(a) > 0) != (plane.distance(b) > 0))
                        ends.push_back(a + (b - a) * (plane.distance(a) / (plane.distance(a) - plane.distance(b))));
                }
                if (ends.size() == 2)
                    expected += lengthWithin(ends[0], ends[1]);
            }
            const auto curves = findSection(step.cells, plane);
            double found = 0;
            for (const surface::SectionCurve& curve : curves)
                for (std::size_t e = 1; e < curve.points.size(); ++e)
                    found += lengthWithin(curve.points[e - 1].position, curve.points[e].position);
            QVERIFY2(curves.size() == 1 && std::abs(found - expected) < 0.12 * expected,
                     qPrintable(QString("seed %1, round %2, plane %3: %4 curves, of %5, not %6")
                                    .arg(test::seed())
                                    .arg(round)
                                    .arg(k)
                                    .arg(curves.size())
                                    .arg(found)
                                    .arg(expected)));
        }
    }
}

static const test::Registered<StepCreasesTest> registered;
#include "step_creases_test.moc"
