// The view as a hand moves it: what stays where it is, what comes back, and what time does not change.
#include "core/base/random.h"
#include "core/render/named_views.h"
#include "support/patience.h"
#include "support/registry.h"
#include "ui/interaction/navigator.h"
#include "ui/view/fly.h"
#include "ui/view/navigation.h"
#include "ui/view/saved_views.h"

#include <numbers>
#include <QSignalSpy>
#include <QTest>

using namespace ui;
using base::Vec3d;

class ViewTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void rotationsTurnAsTheirAxesSay();
    void cameraAndViewAreInverse();
    void everyStyleKeepsThePivotInItsPlace_data();
    void everyStyleKeepsThePivotInItsPlace();
    void turntablesNeverTurnUpsideDown();
    void trackballsComeBack();
    void lookingAroundKeepsTheEye();
    void panFollowsThePointer();
    void zoomKeepsThePivotInPlace();
    void changingTheProjectionKeepsTheTargetsSize();
    void pickingAPivotMovesNoPixel();
    void namedViewsLookAlongTheAxes();
    void everyAxisStandsAlike_data();
    void everyAxisStandsAlike();
    void framingShowsTheWholeBox();
    void savedViewsComeBackBitForBit();
    void savedViewsFollowTheOrigin();
    void brokenSavedViewsAreRefused();
    void flightDoesNotDependOnTheFrames();
    void flightGoesWhereTheKeysSay();
    void transitionsLeadWhereTheyShould();
    void whateverMovesTheViewEndsTheTransition();
};

static Rotation randomTurn(base::Random& random) {
    return Rotation::about(random.unitVector(), random.uniform(-3, 3));
}

static View randomView(base::Random& random) {
    View out;
    out.target = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    out.distance = std::pow(10.0, random.uniform(-3, 3));
    out.turn = randomTurn(random);
    out.parallel = random.below(2) == 1;
    return out;
}

static QByteArray seeded(int round) {
    return QByteArray("round ") + QByteArray::number(round) + ", seed " + QByteArray::number(test::seed());
}

static bool same(const View& a, const View& b, double tolerance) {
    return distance(a.target, b.target) < tolerance * (1 + a.distance) &&
           distance(a.turn({1, 0, 0}), b.turn({1, 0, 0})) < tolerance &&
           distance(a.turn({0, 1, 0}), b.turn({0, 1, 0})) < tolerance &&
           std::abs(a.distance - b.distance) < tolerance * a.distance;
}

void ViewTest::rotationsTurnAsTheirAxesSay() {
    base::Random random(test::seed());
    QVERIFY(distance(Rotation::about({0, 0, 1}, std::numbers::pi / 2)({1, 0, 0}), {0, 1, 0}) < 1e-15);
    for (int k = 0; k < 500; ++k) {
        const Rotation a = randomTurn(random), b = randomTurn(random);
        const Vec3d p = random.unitVector();
        QVERIFY2(distance((a * b)(p), a(b(p))) < 1e-14 && distance(a.inverse()(a(p)), p) < 1e-14, seeded(k));
        const Rotation c = Rotation::toAxes(a({1, 0, 0}), a({0, 1, 0}), a({0, 0, 1}));
        QVERIFY2(distance(c(p), a(p)) < 1e-12, seeded(k));
        QVERIFY2(distance(Rotation::between(a, b, 0)(p), a(p)) < 1e-12, seeded(k));
        QVERIFY2(distance(Rotation::between(a, b, 1)(p), b(p)) < 1e-12, seeded(k));
    }
}

void ViewTest::cameraAndViewAreInverse() {
    base::Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        const View view = randomView(random);
        const View back = View::of(view.camera(640, 480));
        QVERIFY2(same(view, back, 1e-9) && view.parallel == back.parallel, seeded(k));
    }
}

void ViewTest::everyStyleKeepsThePivotInItsPlace_data() {
    QTest::addColumn<QString>("style");
    for (const NavigationRow& row : navigationTable())
        if (QString(row.id) != "fly")
            QTest::newRow(row.id) << row.id;
}

void ViewTest::everyStyleKeepsThePivotInItsPlace() {
    QFETCH(QString, style);
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        View view = randomView(random);
        if (k % 2)
            view.pivot = view.target + view.turn(Vec3d{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2),
                                                       random.uniform(-0.5, 0.5)} *
                                                 view.distance);
        const double distance = view.distance;
        const Vec3d before = view.camera(800, 600).project(view.turningPoint());
        const ImagePoint from{random.uniform(0, 800), random.uniform(0, 600)},
            to{random.uniform(0, 800), random.uniform(0, 600)};
        navigation(style.toStdString()).drag(view, from, to, 800, 600);
        const Vec3d after = view.camera(800, 600).project(view.turningPoint());
        QVERIFY2(std::abs(after.x - before.x) < 1e-6 && std::abs(after.y - before.y) < 1e-6, seeded(k));
        QVERIFY2(std::abs(after.z - before.z) < 1e-9 * distance && view.distance == distance, seeded(k));
    }
}

void ViewTest::turntablesNeverTurnUpsideDown() {
    base::Random random(test::seed());
    View view;
    for (int k = 0; k < 1000; ++k) {
        navigation("turntable").drag(view, {0, 0}, {random.uniform(-400, 400), random.uniform(-400, 400)}, 800, 600);
        const Vec3d right = view.turn({1, 0, 0}), up = view.turn({0, 1, 0});
        QVERIFY2(std::abs(right.y) < 1e-9 && up.y > -1e-9, seeded(k));
    }
}

/// A drag there and back, over however many places, is none.
void ViewTest::trackballsComeBack() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        const View before = randomView(random);
        View view = before;
        std::vector<ImagePoint> way;
        for (int j = 0; j < 6; ++j)
            way.push_back({random.uniform(0, 800), random.uniform(0, 600)});
        const NavigationRow& ball = navigation("trackball");
        for (std::size_t j = 1; j < way.size(); ++j)
            ball.drag(view, way[j - 1], way[j], 800, 600);
        for (std::size_t j = way.size(); --j > 0;)
            ball.drag(view, way[j], way[j - 1], 800, 600);
        QVERIFY2(same(before, view, 1e-9), seeded(k));
    }
}

void ViewTest::lookingAroundKeepsTheEye() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        View view = randomView(random);
        view.parallel = false;
        const Vec3d eye = view.camera(800, 600).eye;
        navigation("fly").drag(view, {0, 0}, {random.uniform(-400, 400), random.uniform(-400, 400)}, 800, 600);
        QVERIFY2(distance(view.camera(800, 600).eye, eye) < 1e-9 * view.distance, seeded(k));
    }
}

void ViewTest::panFollowsThePointer() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        View view = randomView(random);
        const Vec3d before = view.target;
        const double dx = random.uniform(-200, 200), dy = random.uniform(-200, 200);
        view.pan(dx, dy, 600);
        const Vec3d at = view.camera(800, 600).project(before);
        QVERIFY2(std::abs(at.x - 400 - dx) < 1e-6 && std::abs(at.y - 300 - dy) < 1e-6, seeded(k));
    }
}

void ViewTest::zoomKeepsThePivotInPlace() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        View view = randomView(random);
        const auto before = view.camera(800, 600);
        const base::Rayd ray = before.ray(random.uniform(0, 800), random.uniform(0, 600));
        const Vec3d pivot = ray.at(random.uniform(0.5, 2) * view.distance);
        view.zoom(random.uniform(-5, 5), pivot);
        const Vec3d was = before.project(pivot), is = view.camera(800, 600).project(pivot);
        QVERIFY2(std::abs(was.x - is.x) < 1e-6 && std::abs(was.y - is.y) < 1e-6, seeded(k));
    }
    View view;
    view.zoom(1, view.target);
    QVERIFY(view.distance < 3);
}

void ViewTest::changingTheProjectionKeepsTheTargetsSize() {
    base::Random random(test::seed());
    for (int k = 0; k < 100; ++k) {
        View view = randomView(random);
        const Vec3d beside = view.target + view.turn(Vec3d{0.1, -0.2, 0} * view.distance);
        const Vec3d before = view.camera(800, 600).project(beside);
        view.parallel = !view.parallel;
        const Vec3d after = view.camera(800, 600).project(beside);
        QVERIFY2(std::abs(after.x - before.x) < 1e-6 && std::abs(after.y - before.y) < 1e-6, seeded(k));
    }
}

void ViewTest::pickingAPivotMovesNoPixel() {
    base::Random random(test::seed());
    for (int k = 0; k < 100; ++k) {
        View view = randomView(random);
        const render::Camera before = view.camera(800, 600);
        view.pivot = random.unitVector();
        QVERIFY(view.camera(800, 600) == before);
        // And the first pixel of a drag moves the picture by about a pixel.
        const Vec3d seen = before.project(view.target);
        navigation("turntable").drag(view, {0, 0}, {0, 0}, 800, 600);
        const Vec3d now = view.camera(800, 600).project(before.target);
        QVERIFY2(std::abs(now.x - seen.x) < 1e-6 && std::abs(now.y - seen.y) < 1e-6, seeded(k));
    }
}

void ViewTest::namedViewsLookAlongTheAxes() {
    const Vec3d expected[] = {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
    QCOMPARE(render::namedViews().size(), std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        const render::NamedView& row = render::namedViews()[i];
        View view;
        view.turnTo(row.toEye, row.up);
        QVERIFY(base::length(view.camera(100, 100).forward() - expected[i]) < 1e-12);
        QVERIFY(base::length(view.camera(100, 100).upright() - row.up) < 1e-12);
        QVERIFY(same(view, view.upright(), 1e-9));
    }
}

void ViewTest::everyAxisStandsAlike_data() {
    QTest::addColumn<int>("axis");
    for (const base::UpRow& row : base::upTable())
        QTest::newRow(row.id) << static_cast<int>(row.axis);
}

/// Whatever is done to a view of a model with y upwards, the same done to one of the turned model shows the same.
void ViewTest::everyAxisStandsAlike() {
    QFETCH(int, axis);
    const auto up = static_cast<base::UpAxis>(axis);
    const auto turned = [up](View view) {
        view.stand(up);
        view.target = fromStanding(up, view.target);
        if (view.pivot)
            view.pivot = fromStanding(up, *view.pivot);
        return view;
    };
    base::Random random(test::seed());
    for (int k = 0; k < 60; ++k) {
        View view = randomView(random);
        view.pivot = random.unitVector();
        View there = turned(view);
        const ImagePoint from{random.uniform(0, 800), random.uniform(0, 600)}, to{400, 300};
        for (const NavigationRow& row : navigationTable()) {
            row.drag(view, from, to, 800, 600);
            row.drag(there, from, to, 800, 600);
            QVERIFY2(same(turned(view), there, 1e-9), seeded(k));
        }
        QVERIFY2(same(turned(view.upright()), there.upright(), 1e-9), seeded(k));
        QVERIFY(std::abs(dot(there.upright().turn({1, 0, 0}), base::upRow(up).up)) < 1e-9); // a level horizon
        for (const render::NamedView& row : render::namedViews()) {
            view.turnTo(row.toEye, row.up);
            there.turnTo(row.of(up).toEye, row.of(up).up);
            QVERIFY2(same(turned(view), there, 1e-9), row.id);
        }
        Fly fly(view, 1), other(there, 1);
        for (Fly* each : {&fly, &other}) {
            each->press(Fly::Up);
            each->look(20, 30, 600);
            each->step(0.3);
        }
        QVERIFY2(same(turned(fly.view()), other.view(), 1e-9), seeded(k));
    }
    const base::Box3f cube[] = {{{-1, -1, -1}, {1, 1, 1}}};
    QVERIFY(same(turned(View::threeQuarter(cube, 800, 600, base::UpAxis::Y)), View::threeQuarter(cube, 800, 600, up),
                 1e-9));
}

void ViewTest::framingShowsTheWholeBox() {
    base::Random random(test::seed());
    const base::Box3f boxes[] = {{{-1, -2, 3}, {0, 5, 4}}, {{-1, -2, 3}, {4, 0, 7}}};
    for (int k = 0; k < 100; ++k) {
        View view = randomView(random);
        view.pivot = Vec3d{1, 2, 3};
        const Rotation turn = view.turn;
        view.frame(boxes, 800, 500);
        QVERIFY(view.turn == turn && !view.picked);
        QVERIFY(view.turningPoint() == (Vec3d{1.5, 1.5, 5})); // the middle, wherever it is seen
        double farthest = 0;                                  // from the middle, as a part of what fits
        double left = 1, right = -1, top = 1, bottom = -1;
        for (const base::Box3f& box : boxes)
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3d p{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                              corner & 4 ? box.hi.z : box.lo.z};
                const Vec3d at = view.camera(800, 500).project(p);
                farthest = std::max({farthest, std::abs(at.x - 400) / 400, std::abs(at.y - 250) / 250});
                left = std::min(left, at.x / 400 - 1), right = std::max(right, at.x / 400 - 1);
                top = std::min(top, at.y / 250 - 1), bottom = std::max(bottom, at.y / 250 - 1);
            }
        QVERIFY2(std::abs(left + right) < 3e-3 && std::abs(top + bottom) < 3e-3, seeded(k));
        QVERIFY2(std::abs(farthest - 0.92) < 1e-6, seeded(k));
    }
}

void ViewTest::savedViewsComeBackBitForBit() {
    base::Random random(test::seed());
    for (int k = 0; k < 300; ++k) {
        SavedView saved{"left wing, from below", randomView(random), random.unitVector() * 1e6};
        if (k % 3)
            saved.view.pivot = random.unitVector(), saved.view.picked = k % 3 == 1;
        const auto back = savedViewOf(textOf(saved));
        QVERIFY2(back && *back == saved, seeded(k));
        QVERIFY(back->forOrigin(saved.origin).camera(801, 603) == saved.view.camera(801, 603));
    }
}

void ViewTest::savedViewsFollowTheOrigin() {
    View view;
    view.target = {1, 2, 3};
    view.pivot = Vec3d{4, 5, 6};
    const SavedView saved{"a", view, {100, 0, 0}};
    const View there = saved.forOrigin({90, 0, 1});
    QVERIFY(there.target == (Vec3d{11, 2, 2}) && *there.pivot == (Vec3d{14, 5, 5}));
}

void ViewTest::brokenSavedViewsAreRefused() {
    const std::string good = textOf({"a", View{}, {}});
    QVERIFY(savedViewOf(good));
    for (const std::string& bad :
         {std::string(), good.substr(2), good.substr(0, good.size() - 1), "x" + good, std::string("0 0 0 nan ") + good})
        QVERIFY2(!savedViewOf(bad), bad.c_str());
}

/// The same keys for the same time, cut into frames in any way.
void ViewTest::flightDoesNotDependOnTheFrames() {
    base::Random random(test::seed());
    for (int k = 0; k < 50; ++k) {
        const View start = randomView(random);
        Fly smooth(start, 2), rough(start, 2);
        for (int part = 0; part < 3; ++part) {
            const auto key = static_cast<Fly::Key>(1u << random.below(7));
            const double seconds = random.uniform(0.05, 0.6);
            smooth.press(key), rough.press(key);
            for (int j = 0; j < 240; ++j)
                smooth.step(seconds / 240);
            const double cut = random.uniform(0, 1);
            rough.step(seconds * cut), rough.step(seconds * (1 - cut));
            if (random.below(2))
                smooth.release(key), rough.release(key);
        }
        QVERIFY2(distance(smooth.view().target, rough.view().target) < 1e-9, seeded(k));
    }
}

void ViewTest::flightGoesWhereTheKeysSay() {
    Fly fly(View{}, 1);
    fly.press(Fly::Forward);
    fly.step(10);
    QVERIFY(std::abs(fly.view().target.z + 10 - Fly::tau) < 1e-9); // the start took tau
    fly.release(Fly::Forward);
    fly.press(Fly::Right);
    QVERIFY(fly.moving());
    fly.step(5);
    QVERIFY(fly.view().target.x > 4.8);
    fly.release(Fly::Right);
    fly.step(2);
    QVERIFY(!fly.moving());
}

void ViewTest::transitionsLeadWhereTheyShould() {
    base::Random random(test::seed());
    Navigator navigator;
    const View from = randomView(random), to = randomView(random);
    navigator.set(from);
    QSignalSpy moved(&navigator, &Navigator::moved);
    navigator.goTo(to);
    QVERIFY(navigator.view() == to && navigator.inTransition()); // at once, for whoever asks
    QVERIFY(!(navigator.shown() == to));
    QTRY_VERIFY_WITH_TIMEOUT(!navigator.inTransition(), test::patience);
    QVERIFY(navigator.shown() == to);
    QVERIFY(moved.size() > 2 && moved.back().at(0).toBool() == false); // the last is at rest
    QVERIFY(between(from, to, 1) == to);
}

void ViewTest::whateverMovesTheViewEndsTheTransition() {
    Navigator navigator;
    View to;
    to.distance = 7;
    navigator.goTo(to);
    navigator.zoom(1, to.target);
    QVERIFY(!navigator.inTransition() && navigator.shown() == navigator.view() && navigator.view().distance < 7);
    navigator.goTo(to);
    navigator.finish();
    QVERIFY(!navigator.inTransition() && navigator.shown() == to);
}

static const test::Registered<ViewTest> registered;
#include "view_test.moc"
