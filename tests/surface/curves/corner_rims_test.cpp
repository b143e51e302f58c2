// Rims with corners, as torn scans have them: boundaries step over kinks and are traced once all the same.
#include "core/base/random.h"
#include "core/base/segment.h"
#include "core/surface/curves/boundary_curves.h"
#include "support/registry.h"
#include "surface/bounded.h"
#include "surface/shapes.h"

#include <algorithm>
#include <QTest>

using namespace surface;
using base::Vec3d;

class CornerRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void rimsWithCornersAreTracedOnce();
};

namespace {

/// The share of a curve's points that lie on a stretch of it that is elsewhere along it, and runs the same way.
double tracedTwice(const BoundaryCurve& curve) {
    const auto& p = curve.points;
    std::vector<double> along(p.size() + 1, 0);
    for (std::size_t i = 0; i < p.size(); ++i)
        along[i + 1] = along[i] + distance(p[i].position, p[(i + 1) % p.size()].position);
    int twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t k = 0; k + 1 < p.size(); ++k) {
            const double gap = std::max(along[k] - along[i], along[i] - along[k + 1]); // or round the other way
            const bool elsewhere = std::min(gap, curve.closed ? along.back() - gap : gap) > p[i].unit;
            if (elsewhere &&
                distance(base::nearestOnSegment(p[k].position, p[k + 1].position, p[i].position), p[i].position) <
                    0.01 * p[i].unit &&
                dot(p[i].tangent(), p[k].tangent()) > 0.5) {
                ++twice;
                break;
            }
        }
    return static_cast<double>(twice) / static_cast<double>(p.size());
}

/// A jittered grid on a wavy sheet, without what lies in random triangles, which overlap.
surfel::SurfelList sheetWithTriangularHoles(base::Random& random, double s) {
    struct Triangle {
        Vec3d corner[3];
        bool contains(const Vec3d& p) const {
            const auto side = [&](int k) { return cross(corner[(k + 1) % 3] - corner[k], p - corner[k]).z > 0; };
            return side(0) == side(1) && side(1) == side(2);
        }
    };
    std::vector<Triangle> holes(10);
    for (Triangle& hole : holes) {
        const Vec3d about{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), 0};
        for (Vec3d& corner : hole.corner)
            corner = about + Vec3d{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0};
    }
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    const int rows = static_cast<int>(1 / s);
    for (int i = -rows; i <= rows; ++i)
        for (int k = -rows; k <= rows; ++k) {
            const Vec3d at{(i + random.uniform(-0.3, 0.3)) * s, (k + random.uniform(-0.3, 0.3)) * s, 0};
            if (std::any_of(holes.begin(), holes.end(), [&](const Triangle& hole) { return hole.contains(at); }))
                continue;
            const Vec3d up = base::normalized(Vec3d{-0.6 * std::cos(3 * at.x), 0, 1});
            out.items.push_back(shapes::surfelAt(at + Vec3d{0, 0, 0.2 * std::sin(3 * at.x)}, up, 3.3 * s));
        }
    return out;
}

} // namespace

void CornerRimsTest::rimsWithCornersAreTracedOnce() {
    int all = 0;
    QStringList open, twice;
    for (int k = 0; k < test::effort(30); ++k) {
        base::Random random(1000 * test::seed() + static_cast<unsigned>(k));
        constexpr double s = 0.025;
        const auto curves =
            findBoundaryCurves(shapes::surfaceOf(sheetWithTriangularHoles(random, s), shapes::bounded(0.2f)));
        for (const BoundaryCurve& curve : curves) {
            if (curve.length() < 20 * s)
                continue;
            ++all;
            const QString what = QString("%1: length %2").arg(k).arg(curve.length());
            if (!curve.closed)
                open << what;
            if (tracedTwice(curve) > 0.02)
                twice << what;
        }
    }
    QVERIFY(all > test::effort(30));
    // One in 150 ends where the rim turns back at once.
    QVERIFY2(open.size() <= 1 + all / 50 && twice.isEmpty(), qPrintable(QString("open %1; twice %2; of %3, seed %4")
                                                                            .arg(open.join(", "), twice.join(", "))
                                                                            .arg(all)
                                                                            .arg(test::seed())));
}

static const test::Registered<CornerRimsTest> registered;
#include "corner_rims_test.moc"
