// Feet on complexes: exact on flat cells, ends where their boundaries are, the same from all cells that share a place.
#include "core/complexes/complex_projection.h"

#include "complexes/sample_complexes.h"
#include "core/base/error.h"
#include "core/base/mat3.h"
#include "core/base/random.h"
#include "core/surface/curvature.h"
#include "core/surface/evaluation/weights.h"
#include "support/registry.h"

#include <QTest>

using base::Random, base::Vec3d;
using complexes::CellFoot, complexes::CellFrame, complexes::Complex;
using surface::Projector;

class ComplexProjectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aSquareEndsAtItsEdges();
    void flatFacesAreExact();
    void positionsFarAwayFindTheNearest();
    void feetAreFeet_data();
    void feetAreFeet();
    void edgesAreTheSameFromBothFaces();
    void curvesInterpolateTheirEnds();
    void facesInterpolateTheirCurves();
    void roundCellsShrinkAsTheirSupportsSay();
    void sharedPlanesAreSmoothAndOthersKeepTheirCrease();
    void framesAreThoseOfPlainSums();
    void valuesHaveTheirGradients();
    void brokenComplexesAreRefused();
};

void ComplexProjectionTest::aSquareEndsAtItsEdges() {
    const Complex square = complex_models::complexOf("square", 1500);
    Random random(test::seed());
    for (int k = 0; k < test::effort(400); ++k) {
        const bool near = k % 4 != 0;
        const double size = near ? 1.2 : 6, high = near ? 0.1 : 3;
        const Vec3d x{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-high, high)};
        const Vec3d truth{std::clamp(x.x, -1.0, 1.0), std::clamp(x.y, -1.0, 1.0), 0};
        for (const Projector projector : {Projector::Almost, Projector::Orthogonal}) {
            const CellFoot foot = project(square, x, projector);
            QVERIFY2(foot.ok() && base::distance(foot.position, truth) < 1e-9,
                     qPrintable(QString("%1 %2 %3: off by %4, seed %5")
                                    .arg(x.x)
                                    .arg(x.y)
                                    .arg(x.z)
                                    .arg(base::distance(foot.position, truth))
                                    .arg(test::seed())));
            const int beyond = (std::abs(x.x) > 1 ? 1 : 0) + (std::abs(x.y) > 1 ? 1 : 0);
            QCOMPARE(square[foot.on].dimension, 2 - beyond);
        }
    }
}

void ComplexProjectionTest::flatFacesAreExact() {
    const Complex solid = complex_models::complexOf("icosahedron", 3000);
    const auto faces = complex_models::facesOf(solid);
    QCOMPARE(faces.size(), std::size_t(20));
    Random random(test::seed());
    for (int k = 0; k < test::effort(400); ++k) {
        const Vec3d x = random.unitVector() * random.uniform(0.7, 1.15);
        double nearest = std::numeric_limits<double>::infinity();
        for (auto face : faces) {
            if (dot(cross(face[1] - face[0], face[2] - face[0]), face[0]) < 0)
                std::swap(face[1], face[2]);
            nearest = std::min(nearest, base::distance(x, complex_models::nearestIn(face, x)));
        }
        const CellFoot foot = project(solid, x, Projector::Almost);
        QVERIFY2(foot.ok() && std::abs(base::distance(foot.position, x) - nearest) < 2e-7, // points are floats
                 qPrintable(
                     QString("off by %1, seed %2").arg(base::distance(foot.position, x) - nearest).arg(test::seed())));
    }
}

void ComplexProjectionTest::positionsFarAwayFindTheNearest() {
    const Complex octant = complex_models::complexOf("octant", 3000);
    const Complex ball = complex_models::complexOf("rounded", 2000);
    Random random(test::seed());
    for (int k = 0; k < test::effort(50); ++k) {
        const Vec3d u = random.unitVector(), inside = normalized(Vec3d{std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        const double far = random.uniform(1.05, 8);
        for (const Projector projector : {Projector::Almost, Projector::Orthogonal}) {
            const CellFoot round = project(octant, inside * far, projector), any = project(ball, u * far, projector);
            // not nearer than it is; how far off in direction the frames are counts with the distance
            QVERIFY2(round.ok() && base::distance(round.position, inside * far) < far - 1 + 0.01,
                     qPrintable(QString("octant from %1: off by %2, seed %3")
                                    .arg(far)
                                    .arg(base::distance(round.position, inside * far) - far + 1)
                                    .arg(test::seed())));
            QVERIFY2(any.ok() && base::distance(any.position, u * far) < far - 1 + 0.01,
                     qPrintable(QString("ball from %1: off by %2, seed %3")
                                    .arg(far)
                                    .arg(base::distance(any.position, u * far) - far + 1)
                                    .arg(test::seed())));
        }
    }
}

void ComplexProjectionTest::feetAreFeet_data() {
    QTest::addColumn<QString>("sample");
    for (const char* sample : {"square", "gasket", "octant", "cone", "icosahedron", "bulged", "rounded"})
        QTest::newRow(sample) << QString(sample);
}

void ComplexProjectionTest::feetAreFeet() {
    QFETCH(QString, sample);
    const Complex complex = complex_models::complexOf(sample.toUtf8(), 2000);
    Random random(test::seed());
    int failed = 0, moved = 0;
    const int tries = test::effort(250);
    for (int k = 0; k < tries; ++k) {
        const Vec3d x = random.unitVector() * random.uniform(0.1, 1.3);
        for (const Projector projector : {Projector::Basic, Projector::Almost}) {
            const CellFoot foot = project(complex, x, projector);
            failed += foot.ok() ? 0 : 1;
            if (!foot.ok())
                continue;
            const CellFoot again = project(complex, foot.position, projector);
            moved += again.ok() && base::distance(again.position, foot.position) < 1e-8 * foot.unit ? 0 : 1;
        }
    }
    QVERIFY2(failed <= tries / 100, qPrintable(QString("%1 failed, seed %2").arg(failed).arg(test::seed())));
    // beside edges another face may be as near
    QVERIFY2(moved <= tries / 40, qPrintable(QString("%1 moved, seed %2").arg(moved).arg(test::seed())));
}

void ComplexProjectionTest::edgesAreTheSameFromBothFaces() {
    for (const char* sample : {"icosahedron", "octant", "rounded"}) {
        const Complex complex = complex_models::complexOf(sample, 2000);
        Random random(test::seed());
        for (std::uint32_t curve = 0; curve < complex.cells().size(); ++curve) {
            if (complex[curve].dimension != 1)
                continue;
            const auto& ends = complex[curve].boundary;
            const double share = random.uniform(0.1, 0.9);
            const Vec3d middle = complex.place(ends[0]) * share + complex.place(ends[1]) * (1 - share);
            const CellFoot on = footOn(complex, curve, middle, {Projector::Almost, true, true, {}});
            QVERIFY(on.ok());
            std::optional<Vec3d> first;
            for (std::uint32_t patch = 0; patch < complex.cells().size(); ++patch)
                if (const auto& b = complex[patch].boundary;
                    complex[patch].dimension == 2 && std::find(b.begin(), b.end(), curve) != b.end()) {
                    const CellFoot foot = footOn(complex, patch, on.position, {});
                    QVERIFY2(foot.ok() && base::distance(foot.position, on.position) < 1e-12, sample);
                    QVERIFY2(foot.position == first.value_or(foot.position), sample);
                    first = foot.position;
                    QCOMPARE(foot.on, curve);
                }
        }
    }
}

void ComplexProjectionTest::curvesInterpolateTheirEnds() {
    const Complex octant = complex_models::complexOf("octant", 3000);
    for (std::uint32_t curve = 0; curve < octant.cells().size(); ++curve) {
        if (octant[curve].dimension != 1)
            continue;
        for (const std::uint32_t end : octant[curve].boundary) {
            QVERIFY(footOn(octant, curve, octant.place(end), {}).position == octant.place(end));
            double before = std::numeric_limits<double>::infinity();
            for (const double away : {1e-2, 1e-4, 1e-6}) { // of h: continuous into it
                const Vec3d inside = normalized(octant[curve].centre - octant.place(end));
                const Vec3d x = octant.place(end) + inside * (away * octant.reach(end));
                const CellFoot foot = footOn(octant, curve, x, {});
                QVERIFY(foot.ok());
                const double d = base::distance(foot.position, octant.place(end));
                QVERIFY(d < before && d < 1.01 * base::distance(x, octant.place(end)) + 1e-12);
                before = d;
            }
        }
    }
}

void ComplexProjectionTest::facesInterpolateTheirCurves() {
    const Complex octant = complex_models::complexOf("octant", 3000);
    for (std::uint32_t patch = 0; patch < octant.cells().size(); ++patch) {
        if (octant[patch].dimension != 2)
            continue;
        const std::uint32_t curve = octant[patch].boundary.front();
        const auto& ends = octant[curve].boundary;
        const CellFoot on = footOn(octant, curve, (octant.place(ends[0]) + octant.place(ends[1])) * 0.5,
                                   {Projector::Almost, true, true, {}});
        QVERIFY(on.ok());
        double before = std::numeric_limits<double>::infinity();
        for (const double away : {0.3, 0.03, 0.003, 0.0003}) { // of h
            const Vec3d inside = normalized(octant[patch].centre - on.position);
            const CellFoot foot = footOn(octant, patch, on.position + inside * (away * on.unit), {});
            QVERIFY(foot.ok());
            const double d = base::distance(foot.position, on.position);
            QVERIFY2(d < before && d < 1.1 * away * on.unit, qPrintable(QString::number(d / on.unit)));
            before = d;
        }
    }
}

void ComplexProjectionTest::roundCellsShrinkAsTheirSupportsSay() {
    // Of a sphere and a circle of radius 1: 1 - h^2 / 14.4 and 1 - h^2 / 28, of even points
    const Complex octant = complex_models::complexOf("octant", 6000);
    int looked = 0;
    for (std::uint32_t cell = 0; cell < octant.cells().size(); ++cell) {
        if (octant[cell].dimension == 2 && length(octant[cell].centre) > 0.7) {
            const CellFoot foot = footOn(octant, cell, normalized(Vec3d{1, 1, 1}), {});
            QVERIFY(foot.ok());
            const double shrunk = (1 - length(foot.position)) / (foot.unit * foot.unit);
            QVERIFY2(std::abs(shrunk - 1 / 14.4) < 0.006, qPrintable(QString::number(1 / shrunk)));
            ++looked;
        }
        if (octant[cell].dimension == 1 && length(octant[cell].centre) > 0.8) { // an arc: its mean is further out
            const CellFoot foot = footOn(octant, cell, normalized(octant[cell].centre), {});
            QVERIFY(foot.ok());
            const double shrunk = (1 - length(foot.position)) / (foot.unit * foot.unit);
            QVERIFY2(std::abs(shrunk - 1 / 28.0) < 0.003, qPrintable(QString::number(1 / shrunk)));
            ++looked;
        }
    }
    QCOMPARE(looked, 4);
}

/// The largest angle in degrees between the planes of two patches along the middle of a curve that they share.
static double largestTurn(const Complex& complex) {
    double out = 0;
    for (std::uint32_t curve = 0; curve < complex.cells().size(); ++curve) {
        if (complex[curve].dimension != 1)
            continue;
        const auto& ends = complex[curve].boundary;
        const CellFoot on = footOn(complex, curve, (complex.place(ends[0]) + complex.place(ends[1])) * 0.5,
                                   {Projector::Almost, true, true, {}});
        std::vector<Vec3d> normals;
        for (std::uint32_t patch = 0; patch < complex.cells().size(); ++patch)
            if (const auto& b = complex[patch].boundary;
                complex[patch].dimension == 2 && std::find(b.begin(), b.end(), curve) != b.end())
                normals.push_back(frameOf(complex, patch, on.position).axis);
        if (normals.size() == 2)
            out = std::max(out, std::asin(std::min(1.0, length(cross(normals[0], normals[1])))) * 57.29578);
    }
    return out;
}

void ComplexProjectionTest::sharedPlanesAreSmoothAndOthersKeepTheirCrease() {
    QVERIFY2(largestTurn(complex_models::complexOf("rounded", 2000)) < 1e-4,
             qPrintable(QString::number(largestTurn(complex_models::complexOf("rounded", 2000)))));
    const double creased = largestTurn(complex_models::complexOf("icosahedron", 2000));
    QVERIFY2(std::abs(creased - 41.8103) < 1e-3, qPrintable(QString::number(creased))); // 180 - 138.19 degrees
}

void ComplexProjectionTest::framesAreThoseOfPlainSums() {
    const Complex complex = complex_models::complexOf("octant", 1500);
    Random random(test::seed());
    int compared = 0;
    for (int k = 0; k < test::effort(300); ++k) {
        const Vec3d x = random.unitVector() * random.uniform(0.9, 1.05);
        for (std::uint32_t patch = 0; patch < complex.cells().size(); ++patch) {
            if (complex[patch].dimension != 2)
                continue;
            const CellFrame frame = frameOf(complex, patch, x);
            const bool pulled =
                !frame.attached.empty() && frame.attached.front().distance < frame.attached.front().reach;
            if (!frame.ok() || pulled)
                continue;
            const surfel::SurfelList points = complex[patch].own.tree().surfels();
            Vec3d centre;
            double weight = 0;
            const auto theta = [&](const surfel::Surfel& s) {
                return surface::weightAt(complex.weight(), base::distanceSq(base::cast<double>(s.position), x),
                                         static_cast<double>(s.support));
            };
            for (const surfel::Surfel& s : points.items) {
                centre += base::cast<double>(s.position) * theta(s);
                weight += theta(s);
            }
            centre = centre / weight;
            base::Mat3d moments;
            for (const surfel::Surfel& s : points.items) {
                const Vec3d d = base::cast<double>(s.position) - centre;
                moments += base::outer(d, d) * theta(s);
            }
            const Vec3d normal = base::symmetricEigen(moments).vector[0];
            QVERIFY2(base::distance(centre, frame.centre) < 1e-12 && length(cross(normal, frame.axis)) < 1e-7,
                     qPrintable(QString("seed %1").arg(test::seed())));
            ++compared;
        }
    }
    QVERIFY(compared > 0);
}

void ComplexProjectionTest::valuesHaveTheirGradients() {
    const Complex complex = complex_models::complexOf("rounded", 2000);
    Random random(test::seed());
    for (int k = 0; k < test::effort(60); ++k) {
        const Vec3d x = random.unitVector() * random.uniform(0.98, 1.02);
        const surface::Evaluationd at = evaluate(complex, x, surface::Need::Hessian);
        QVERIFY(at.ok());
        QVERIFY2(dot(normalized(at.gradient), normalized(x)) > 0.99, qPrintable(QString::number(test::seed())));
        QVERIFY(std::abs(at.value - (length(x) - 1)) < 0.01);
        const surface::Curvature bend = surface::curvatureOf(at);
        const CellFoot foot = project(complex, x, Projector::Almost);
        if (complex[foot.on].dimension == 2 && frameOf(complex, foot.on, x).attached.empty()) // away from edges
            QVERIFY2(bend.k1 > 0.5 && bend.k1 < 1.6, qPrintable(QString::number(bend.k1)));
    }
}

void ComplexProjectionTest::brokenComplexesAreRefused() {
    const surface::Surface square = complex_models::surfaceOf("square", 400);
    const auto with = [&](const auto& spoil) {
        surface::Connectivity broken = *square.definition().connectivity;
        spoil(broken);
        surface::SurfaceDefinition definition = square.definition();
        definition.connectivity = std::make_shared<const surface::Connectivity>(broken);
        return surface::Surface(square.tree(), definition);
    };
    QVERIFY(Complex::of(square));
    QVERIFY(!Complex::of(surface::Surface(square.tree(), {})));
    using C = surface::Connectivity;
    const std::function<void(C&)> faults[] = {
        [](C& c) { c.cells[0].dimension = 3; },
        [](C& c) { c.cells[4].boundary = {0}; }, // one end
        [](C& c) {
            c.cells[4].boundary = {0, 77};
        }, // nobody
        [](C& c) {
            c.cells[8].boundary = {4, 5, 6};
        }, // does not close
        [](C& c) {
            c.cells[8].boundary = {0, 1, 2, 3};
        },                                // points about a patch
        [](C& c) { c.cells.pop_back(); }, // points of a cell that is not there
        [](C& c) {
            c.cells.push_back({1, {0, 1}});
        }, // a curve without points
        [](C& c) {
            c.cells.push_back({0, {}});
        }, // a point without one
        [](C& c) {
            c.tangents.push_back({8, {8}, {}, {0, 0, 1}});
        }, // at a patch
        [](C& c) {
            c.tangents.push_back({4, {0}, {}, {0, 0, 1}});
        }, // of something lower
    };
    for (const auto& fault : faults)
        QVERIFY_THROWS_EXCEPTION(base::Error, Complex::of(with(fault)));
    surface::SurfaceDefinition none = square.definition();
    none.connectivity = nullptr;
    QVERIFY_THROWS_EXCEPTION(base::Error, Complex::of(surface::Surface(square.tree(), none)));
}

static const test::Registered<ComplexProjectionTest> registered;
#include "complex_projection_test.moc"
