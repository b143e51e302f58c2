// Noise is measured as it is, and taken out without shrinking what is below it.
#include "core/base/random.h"
#include "core/process/cleaning/denoise.h"
#include "core/process/estimation/cloud_normals.h"
#include "core/process/estimation/spacing.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/threads.h"

#include <QTest>

using namespace process;
using base::Vec3d, base::Vec3f;

class DenoiseTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void noiseIsFoundAsItIs_data();
    void noiseIsFoundAsItIs();
    void spheresKeepTheirRadius_data();
    void spheresKeepTheirRadius();
    void reliefKeepsItsHeight();
    void sharpEdgesStay_data();
    void sharpEdgesStay();
    void boxesKeepTheirCorners();
    void withoutNoiseNothingMoves();
    void wallsDoNotAttractEachOther();
    void threadsDoNotShow();
};

namespace {

/// Noise in all directions.
void shake(surfel::SurfelList& list, double sigma, base::Random& random) {
    for (surfel::Surfel& s : list.items)
        s.position += base::cast<float>(Vec3d{random.normal(), random.normal(), random.normal()} * sigma);
}

std::vector<Vec3f> normalsOfPlaces(const Cloud& cloud, const surfel::SurfelList& list) {
    std::vector<Vec3f> out(cloud.size());
    for (std::size_t i = 0; i < list.size(); ++i)
        out[cloud.places()[i]] = list.items[i].normal;
    return out;
}

/// The list with denoised positions; `sigma` 0: as found.
surfel::SurfelList clean(surfel::SurfelList list, double sigma) {
    const Cloud cloud(list.items);
    std::vector<float> noise(cloud.size(), float(sigma));
    if (sigma == 0)
        noise = estimateNoise(cloud).at;
    const Denoised found = denoised(cloud, normalsOfPlaces(cloud, list), true, noise);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list.items[i].position = found.positions[cloud.places()[i]];
        list.items[i].normal = found.normals[cloud.places()[i]];
    }
    return list;
}

void levels() {
    QTest::addColumn<double>("level");
    for (const double level : {0.05, 0.15, 0.3, 0.5})
        QTest::newRow(QByteArray::number(level).constData()) << level;
}

QByteArray told(double value) {
    return QByteArray::number(value) + ", seed " + QByteArray::number(test::seed());
}

} // namespace

void DenoiseTest::noiseIsFoundAsItIs_data() {
    levels();
}

void DenoiseTest::noiseIsFoundAsItIs() {
    QFETCH(double, level);
    base::Random random(test::seed());
    const auto n = static_cast<std::size_t>(test::effort(8000));
    surfel::SurfelList sphere = test::spherePoints(n), plane = test::planePoints(test::effort(90) + 20, 0.02);
    const double s = test::sphereSpacing(n);
    shake(sphere, level * s, random);
    shake(plane, level * 0.02, random);
    const double onSphere = estimateNoise(Cloud(sphere.items)).middle / (level * s);
    const double onPlane = estimateNoise(Cloud(plane.items)).middle / (level * 0.02);
    QVERIFY2(std::abs(onSphere - 1) < 0.15, told(onSphere));
    QVERIFY2(std::abs(onPlane - 1) < 0.15, told(onPlane));
}

void DenoiseTest::spheresKeepTheirRadius_data() {
    levels();
}

void DenoiseTest::spheresKeepTheirRadius() {
    QFETCH(double, level);
    base::Random random(test::seed());
    const std::size_t n = 8000; // of fewer, the curvature is more than the least noise
    const double s = test::sphereSpacing(n);
    surfel::SurfelList list = test::spherePoints(n);
    shake(list, level * s, random);
    const surfel::SurfelList out = clean(list, 0);
    double mean = 0, squares = 0, turned = 0;
    for (const surfel::Surfel& each : out.items) {
        const Vec3d p = base::cast<double>(each.position);
        const double off = length(p) - 1;
        mean += off / double(n), squares += off * off / double(n);
        const double cosine = dot(base::normalized(p), base::cast<double>(each.normal));
        turned += std::acos(std::min(1.0, cosine)) / double(n);
    }
    QVERIFY2(std::abs(mean) < 0.1 * s, told(mean / s));
    QVERIFY2(std::sqrt(squares) < 0.45 * level * s, told(std::sqrt(squares) / (level * s)));
    QVERIFY2(turned < 0.1, told(turned));
}

/// Waves of 16 spacings, twice as high as the noise to either side.
void DenoiseTest::reliefKeepsItsHeight() {
    base::Random random(test::seed());
    const double s = 0.02, length = 16 * s, height = 0.4 * s, sigma = 0.2 * s;
    surfel::SurfelList list = test::planePoints(100, s);
    for (surfel::Surfel& each : list.items)
        each.position.z += float(height * std::sin(2 * std::numbers::pi * double(each.position.x) / length));
    shake(list, sigma, random);
    const surfel::SurfelList out = clean(list, 0);
    double along = 0, square = 0;
    for (const surfel::Surfel& each : out.items) { // least squares of the wave's amplitude
        if (std::abs(each.position.x) > 0.8 || std::abs(each.position.y) > 0.7)
            continue;
        const double wave = std::sin(2 * std::numbers::pi * double(each.position.x) / length);
        along += wave * double(each.position.z), square += wave * wave;
    }
    const double kept = along / square / height;
    QVERIFY2(kept > 0.8 && kept < 1.1, told(kept));
}

void DenoiseTest::sharpEdgesStay_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("level");
    for (const double degrees : {30.0, 60.0, 90.0, 120.0, 150.0})
        for (const double level : {0.02, 0.05, 0.2})
            if (degrees < 150 || level < 0.1) // which a plane holds up to such noise
                QTest::addRow("%g, %g", degrees, level) << degrees << level;
}

/// A roof whose normals were estimated, and lie across its crest: beside it noise goes, and normals are the faces'.
void DenoiseTest::sharpEdgesStay() {
    QFETCH(double, degrees);
    QFETCH(double, level);
    base::Random random(test::seed());
    const double s = 0.02, half = degrees / 2 * std::numbers::pi / 180;
    const Vec3d face{std::sin(half), 0, std::cos(half)};
    surfel::SurfelList list;
    for (int i = -24; i < 24; ++i)
        for (int j = 0; j < test::effort(50); ++j) {
            const double side = i < 0 ? -1 : 1, t = (i + random.uniform()) * s * side;
            const Vec3d p{-t * std::cos(half), (j + random.uniform()) * s, side * t * std::sin(half)};
            surfel::Surfel each;
            each.position = base::cast<float>(p);
            each.normal = base::cast<float>(Vec3d{face.x, 0, side * face.z});
            list.items.push_back(each);
        }
    const surfel::SurfelList exact = list;
    shake(list, level * s, random);
    const Cloud cloud(list.items);
    const std::vector<Vec3f> estimated = normalsOf(cloud, 18);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Vec3f& n = estimated[cloud.places()[i]];
        list.items[i].normal = dot(n, list.items[i].normal) < 0 ? -n : n;
    }
    const surfel::SurfelList out = clean(list, 0);
    double squares = 0, turned = 0, count = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const Vec3d p = base::cast<double>(out.items[i].position), was = base::cast<double>(exact.items[i].position);
        if (std::hypot(was.x, was.z) > 2 * s)
            continue;
        const double off = p.x * face.x + std::abs(p.z) * face.z;
        squares += off * off, ++count;
        turned += std::acos(std::min(1.0f, dot(out.items[i].normal, exact.items[i].normal))) * 57.3;
    }
    const double rms = std::sqrt(squares / count) / (level * s);
    QVERIFY2(count > 30 && rms < (level < 0.05 ? 1.2 : 0.75), told(rms));
    QVERIFY2(turned / count < 18, told(turned / count));
}

void DenoiseTest::boxesKeepTheirCorners() {
    base::Random random(test::seed());
    const double s = 0.05, sigma = 0.05 * s;
    surfel::SurfelList list;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (int i = 0; i < 40; ++i)
                for (int j = 0; j < 40; ++j) {
                    surfel::Surfel each;
                    Vec3d p, n;
                    const auto a = static_cast<std::size_t>(axis);
                    p[a] = n[a] = side;
                    p[(a + 1) % 3] = (i + random.uniform()) * s - 1, p[(a + 2) % 3] = (j + random.uniform()) * s - 1;
                    each.position = base::cast<float>(p), each.normal = base::cast<float>(n);
                    list.items.push_back(each);
                }
    shake(list, sigma, random);
    const surfel::SurfelList out = clean(list, 0);
    double squares = 0, inwards = 0, count = 0;
    for (const surfel::Surfel& each : out.items) {
        const Vec3d p = base::cast<double>(each.position);
        double size[3] = {std::abs(p.x), std::abs(p.y), std::abs(p.z)};
        std::sort(size, size + 3);
        if (size[0] < 1 - 2 * s)
            continue; // not at a corner
        squares += (size[2] - 1) * (size[2] - 1), inwards += 1 - size[2], ++count;
    }
    const double rms = std::sqrt(squares / count) / sigma, cut = inwards / count / s;
    QVERIFY2(count > 60 && rms < 1.2 && std::abs(cut) < 0.06, (told(rms) + ", " + told(cut)));
}

void DenoiseTest::withoutNoiseNothingMoves() {
    const std::size_t n = 6000;
    const double s = test::sphereSpacing(n);
    const surfel::SurfelList list = test::spherePoints(n), out = clean(list, 0);
    for (std::size_t i = 0; i < n; ++i)
        QVERIFY(distance(list.items[i].position, out.items[i].position) < float(0.002 * s));
}

/// Two sheets a spacing apart that face away from each other.
void DenoiseTest::wallsDoNotAttractEachOther() {
    base::Random random(test::seed());
    const double s = 0.02;
    surfel::SurfelList list = test::planePoints(60, s);
    const std::size_t half = list.size();
    for (std::size_t i = 0; i < half; ++i) {
        surfel::Surfel other = list.items[i];
        other.position.z -= float(s);
        other.normal = -other.normal;
        list.append(other, {});
    }
    shake(list, 0.15 * s, random);
    const surfel::SurfelList out = clean(list, 0.15 * s);
    double upper = 0, lower = 0;
    for (std::size_t i = 0; i < half; ++i) {
        upper += double(out.items[i].position.z) / double(half);
        lower += double(out.items[half + i].position.z) / double(half);
    }
    QVERIFY2(std::abs(upper - lower - s) < 0.05 * s, told((upper - lower) / s));
}

void DenoiseTest::threadsDoNotShow() {
    base::Random random(test::seed());
    surfel::SurfelList list = test::spherePoints(std::size_t(test::effort(5000)));
    shake(list, 0.005, random);
    const auto work = [&] { return clean(list, 0); };
    const surfel::SurfelList one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.items == two.items);
}

static const test::Registered<DenoiseTest> registered;
#include "denoise_test.moc"
