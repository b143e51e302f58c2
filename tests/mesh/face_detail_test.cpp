// Faces are sampled more finely where they are thin or round within a spacing, and only there.
#include "core/mesh/faces/face_detail.h"

#include "core/mesh/faces/face_sampling.h"
#include "face_models.h"
#include "support/registry.h"
#include "support/threads.h"

#include <algorithm>
#include <QTest>

using namespace faces;
using mesh::FaceSampling;

class FaceDetailTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void roundingsGetTheirOwnSpacing();
    void whatIsFlatOrSharpAsksForNothing();
    void thinPartsGetTheirOwnSpacing();
    void samplesAreAsFarApartAsTheySay();
    void threadsDoNotShow();
};

namespace {

/// (radius, height) from the axis back to it, turned about z.
Faces turned(const std::vector<std::array<double, 2>>& profile, std::uint32_t around) {
    Faces out;
    for (const auto& [r, z] : profile)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            out.positions.push_back(base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), z}));
        }
    for (std::uint32_t k = 0; k + 1 < profile.size(); ++k)
        for (std::uint32_t i = 0; i < around; ++i) {
            const std::uint32_t a = k * around + i, b = k * around + (i + 1) % around;
            if (profile[k][0] > 0)
                out.triangles.push_back({a, b, b + around});
            if (profile[k + 1][0] > 0)
                out.triangles.push_back({a, b + around, a + around});
        }
    return out;
}

/// A cylinder with a flange of that thickness.
Faces flanged(double thickness) {
    return turned({{0, 0}, {1, 0}, {1, 2}, {1.3, 2}, {1.3, 2 + thickness}, {1, 2 + thickness}, {1, 4}, {0, 4}}, 96);
}

/// A cylinder of which one end's edge is rounded.
Faces rounded(double radius, int steps) {
    std::vector<std::array<double, 2>> profile = {{0, 0}, {1, 0}};
    for (int i = 0; i <= steps; ++i) {
        const double angle = std::numbers::pi / 2 * i / steps;
        profile.push_back({1 - radius + radius * std::cos(angle), 2 - radius + radius * std::sin(angle)});
    }
    profile.push_back({0, 2});
    return turned(profile, 192);
}

FaceSampling sampled(const Faces& faces, std::size_t count) {
    const FaceTopology topology = faces.topology();
    const mesh::InnerPlaces inside(topology, faces.positions);
    return mesh::sampleFaces(topology, faces.positions, inside, {}, {.count = count}, {});
}

/// The largest spacing at places of which that holds, and the median one at others.
template <class Fn>
std::pair<double, double> spacingsWhere(const Faces& faces, const FaceSampling& sampling, const Fn& fn) {
    const FaceTopology topology = faces.topology();
    double most = 0;
    std::vector<double> others;
    for (std::size_t i = 0; i < sampling.points.size(); ++i) {
        const double spacing = sampling.spacings[sampling.spacings.size() == 1 ? 0 : i];
        if (fn(placeOf(sampling.points[i], topology, faces.positions)))
            most = std::max(most, spacing);
        else
            others.push_back(spacing);
    }
    std::sort(others.begin(), others.end());
    return {most, others[others.size() / 2]};
}

} // namespace

void FaceDetailTest::roundingsGetTheirOwnSpacing() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(3); ++round) {
        const double radius = random.uniform(0.03, 0.1); // one spacing to 3.4
        const Faces faces = rounded(radius, 12);
        const auto [round12, others] = spacingsWhere(faces, sampled(faces, 16000), [&](const Vec3d& p) {
            return p.z > 2 - radius / 2 && std::hypot(p.x, p.y) > 1 - radius / 2;
        });
        const double wanted = radius * std::numbers::pi / 12; // 15 degrees of it
        QVERIFY2(round12 < 1.8 * wanted && others > 0.02,
                 qPrintable(
                     QString("radius %1: %2 and %3, seed %4").arg(radius).arg(round12).arg(others).arg(test::seed())));
    }
}

void FaceDetailTest::whatIsFlatOrSharpAsksForNothing() {
    const auto places = [](const Faces& faces, double spacing) {
        const FaceTopology topology = faces.topology();
        return mesh::detailedPlaces(topology, faces.positions, std::vector<double>{spacing}, topology.patches).size();
    };
    QCOMPARE(places(rounded(0.05, 1), 0.2), std::size_t(0)); // a chamfer: three patches
    Faces fine;                                              // a plate of small triangles
    for (int i = 0; i <= 100; ++i)
        for (int k = 0; k <= 100; ++k)
            fine.positions.push_back({0.01f * static_cast<float>(i), 0.01f * static_cast<float>(k), 0});
    for (std::uint32_t i = 0; i < 100; ++i)
        for (std::uint32_t k = 0; k < 100; ++k) {
            const std::uint32_t a = i * 101 + k;
            fine.triangles.push_back({a, a + 101, a + 102});
            fine.triangles.push_back({a, a + 102, a + 1});
        }
    QCOMPARE(places(fine, 0.1), std::size_t(0));
    QCOMPARE(places(rounded(0.05, 12), 0.006), std::size_t(0)); // resolved as it is
    QVERIFY(places(rounded(0.05, 12), 0.1) > 10);
}

void FaceDetailTest::thinPartsGetTheirOwnSpacing() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(3); ++round) {
        const double thickness = random.uniform(0.06, 0.1);
        const Faces faces = flanged(thickness);
        const FaceSampling found = sampled(faces, 40000);
        const auto [thin, others] =
            spacingsWhere(faces, found, [&](const Vec3d& p) { return std::hypot(p.x, p.y) > 1.1; });
        QVERIFY2(found.apart && thin < thickness / 2.2 && others > 0.02,
                 qPrintable(QString("%1: %2 and %3, seed %4").arg(thickness).arg(thin).arg(others).arg(test::seed())));
    }
}

/// Else supports are too small for what lies in them.
void FaceDetailTest::samplesAreAsFarApartAsTheySay() {
    const Faces faces = flanged(0.03);
    const FaceTopology topology = faces.topology();
    const FaceSampling found = sampled(faces, 16000);
    const auto place = [&](std::size_t i) { return placeOf(found.points[i], topology, faces.positions); };
    std::vector<double> apart;
    for (std::size_t i = 0; i < found.points.size(); ++i) {
        if (std::hypot(place(i).x, place(i).y) < 1.1 || i % 5 != 0)
            continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < found.points.size(); ++k)
            if (k != i &&
                dot(topology.normals[found.points[i].triangle], topology.normals[found.points[k].triangle]) > 0.5)
                nearest = std::min(nearest, distance(place(i), place(k)));
        apart.push_back(nearest / found.spacings[i]);
    }
    std::sort(apart.begin(), apart.end());
    QVERIFY(apart.size() > 100);
    QVERIFY2(apart[apart.size() / 20] > 0.6 && apart[apart.size() * 19 / 20] < 1.3,
             qPrintable(QString("%1 to %2").arg(apart[apart.size() / 20]).arg(apart[apart.size() * 19 / 20])));
}

void FaceDetailTest::threadsDoNotShow() {
    const Faces faces = rounded(0.04, 12);
    const FaceSampling one = test::onThreads(1, [&] { return sampled(faces, 8000); });
    const FaceSampling four = test::onThreads(4, [&] { return sampled(faces, 8000); });
    QCOMPARE(one.spacings, four.spacings);
    for (std::size_t i = 0; i < one.points.size(); ++i)
        QVERIFY(one.points[i].triangle == four.points[i].triangle && one.points[i].b == four.points[i].b &&
                one.points[i].c == four.points[i].c);
}

static const test::Registered<FaceDetailTest> registered;
#include "face_detail_test.moc"
