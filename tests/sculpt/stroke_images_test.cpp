// The images of a dab: mirrors, radial copies, and how a stamp turns with them and with the stroke.
#include "core/base/random.h"
#include "core/sculpt/contact.h"
#include "core/sculpt/mirror.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;
using base::Vec3f;
using test::down;
using test::settingsOf;

class StrokeImagesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase();
    void imagesMakeAGroupWithoutRepeats();
    void fourCopiesMakeAFourFoldShape();
    void mirroredStampsMirror();
    void stampsFollowTheStroke();
    void uprightStampsFollowTheUpAxis();
    void anAnchoredStampTurnsWithTheDrag();

  private:
    surface::Surface m_plane;
};

static constexpr double s = 0.02;

void StrokeImagesTest::initTestCase() {
    m_plane = test::surfaceOf(test::planePoints(80, s));
}

/// White in its upper half.
static std::shared_ptr<const BrushStamp> upperHalf() {
    return std::make_shared<BrushStamp>(4, 4, std::vector<float>{1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0});
}

static surface::Surface stamped(const surface::Surface& start, StrokeSettings settings,
                                const std::vector<StrokeSample>& samples) {
    settings.stamp = "upper half";
    settings.resample = false;
    Stroke stroke(start, settings, {}, upperHalf());
    for (const StrokeSample& sample : samples)
        stroke.add(sample);
    stroke.finish();
    return stroke.surface();
}

/// Mean of the raised surfels' places, weighted by height.
static Vec3f raisedCentre(const surface::Surface& surface) {
    base::Vec3d sum;
    double weight = 0;
    for (const surfel::Surfel& each : surface.tree().surfels().items)
        sum += base::cast<double>(each.position) * double(each.position.z), weight += double(each.position.z);
    return base::cast<float>(sum / weight);
}

void StrokeImagesTest::imagesMakeAGroupWithoutRepeats() {
    QCOMPARE(mirrors({}, {}).size(), std::size_t(1));
    QCOMPARE(mirrors({{true, true, true}}, {}).size(), std::size_t(8));
    QCOMPARE(mirrors({{}, 5, Axis::Y}, {}).size(), std::size_t(5));
    QCOMPARE(mirrors({{true}, 3, Axis::Z}, {}).size(), std::size_t(6));
    QCOMPARE(mirrors({{true, true}, 2, Axis::Z}, {}).size(), std::size_t(4)); // half a turn is both flips
    QCOMPARE(mirrors({{true, true}, 4, Axis::Z}, {}).size(), std::size_t(8));
    const base::Vec3d origin{1, -2, 0.5};
    for (const Symmetry& symmetry : {Symmetry{{true}, 6, Axis::Z}, Symmetry{{false, true, true}, 5, Axis::X}}) {
        const std::vector<Mirror> images = mirrors(symmetry, origin);
        base::Random random(test::seed());
        const Vec3f p = base::cast<float>(random.unitVector());
        for (const Mirror& a : images) {
            QVERIFY(std::abs(std::abs(determinant(a.matrix())) - 1) < 1e-5f);
            QCOMPARE(determinant(a.matrix()) < 0, a.reflects());
            QVERIFY(length(a.matrix() * p - a.direction(p)) < 1e-6f);
            for (const Mirror& b : images) // closed: an image of an image is an image
                QVERIFY(std::any_of(images.begin(), images.end(), [&](const Mirror& c) {
                    return distance(a.position(b.position(p)), c.position(p)) < 1e-5f;
                }));
        }
    }
}

void StrokeImagesTest::fourCopiesMakeAFourFoldShape() {
    // A model that a quarter turn about z takes to itself, bit for bit.
    surfel::SurfelList points;
    points.layout = test::orientedLayout();
    for (int i = -40; i < 40; ++i)
        for (int j = -40; j < 40; ++j)
            points.append(test::surfelAt({(i + 0.5) * s, (j + 0.5) * s, 0}, {0, 0, 1}, s), {});
    const surface::Surface square = test::surfaceOf(points);
    StrokeSettings settings = settingsOf("draw", 0.12f);
    settings.symmetry.copies = 4;
    settings.resample = false;
    const surface::Surface after =
        test::stroked(square, settings, {down(0.25f, 0.07f), down(0.4f, 0.2f), down(0.1f, 0.03f)});
    double worst = 0, high = 0;
    const Mirror quarter = mirrors(settings.symmetry, {})[1];
    std::vector<tree::Neighbour> found;
    for (const surfel::Surfel& each : after.tree().surfels().items) {
        const Vec3f turned = quarter.position(each.position);
        after.tree().nearest(turned, 1, found);
        worst = std::max(worst, std::sqrt(double(found[0].distanceSq)));
        high = std::max(high, double(each.position.z));
    }
    // Where copies overlap they are done one after the other: the rest is second order in the height.
    QVERIFY2(high > 0.01 && worst < 0.03 * high, qPrintable(QString("%1 of %2").arg(worst).arg(high)));
}

void StrokeImagesTest::mirroredStampsMirror() {
    StrokeSettings settings = settingsOf("draw", 0.15f, StrokeMethod::Dots);
    settings.symmetry.planes.x = true;
    settings.stampAngleRad = 1.1f;
    const surface::Surface after = stamped(m_plane, settings, {down(0.3f, 0.1f)});
    for (const float dx : {-0.05f, 0.0f, 0.06f})
        for (const float dy : {-0.07f, 0.02f, 0.08f}) {
            const auto a = contact(after, down(0.3f + dx, 0.1f + dy).ray),
                       b = contact(after, down(-0.3f - dx, 0.1f + dy).ray);
            QVERIFY(a && b && std::abs(a->position.z - b->position.z) < 2e-4f);
        }
    const Vec3f centre = raisedCentre(after);
    QVERIFY(std::abs(centre.x) < 2e-3f);
}

void StrokeImagesTest::stampsFollowTheStroke() {
    StrokeSettings settings = settingsOf("draw", 0.15f);
    settings.stampFollows = true;
    settings.spacing = 5;
    // One step to the right: both dabs, the first too, have their upper half on the right.
    const surface::Surface after = stamped(m_plane, settings, {down(-0.4f, 0), down(0.4f, 0)});
    for (const float x : {-0.4f, 0.36f}) {
        const auto ahead = contact(after, down(x + 0.07f, 0).ray), behind = contact(after, down(x - 0.07f, 0).ray);
        QVERIFY(ahead && behind);
        QVERIFY2(ahead->position.z > 0.0015f && behind->position.z < 0.0005f,
                 qPrintable(QString("%1 %2").arg(ahead->position.z).arg(behind->position.z)));
    }
    // A stroke that ends before it went anywhere is one upright dab.
    const Vec3f centre = raisedCentre(stamped(m_plane, settings, {down(0, 0)}));
    QVERIFY(centre.y > 0.03f && std::abs(centre.x) < 0.005f);
}

/// Seen along -z: an axis in the plane is upright there; from straight above, what is away from the viewer's feet is.
void StrokeImagesTest::uprightStampsFollowTheUpAxis() {
    for (const base::UpRow& up : base::upTable()) {
        StrokeSettings settings = settingsOf("draw", 0.15f, StrokeMethod::Dots);
        settings.stampUpright = up.axis;
        const bool above = up.up.z != 0;
        const Vec3f upwards = above ? Vec3f{0, 1, 0} : base::cast<float>(up.up);
        const Vec3f centre = raisedCentre(stamped(m_plane, settings, {down(0, 0)}));
        QVERIFY2(length(centre) > 0.03f && dot(normalized(Vec3f{centre.x, centre.y, 0}), upwards) > 0.99f, up.id);
    }
}

void StrokeImagesTest::anAnchoredStampTurnsWithTheDrag() {
    for (const Vec3f& to : {Vec3f{0.3f, 0, 0}, Vec3f{0, -0.3f, 0}, Vec3f{-0.2f, 0.2f, 0}}) {
        const StrokeSettings settings = settingsOf("draw", 0.1f, StrokeMethod::Anchored);
        const Vec3f centre = raisedCentre(stamped(m_plane, settings, {down(0, 0), down(to.x, to.y)}));
        QVERIFY(dot(normalized(Vec3f{centre.x, centre.y, 0}), normalized(to)) > 0.99f);
    }
}

static const test::Registered<StrokeImagesTest> registered;
#include "stroke_images_test.moc"
