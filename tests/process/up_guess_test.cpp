#include "core/process/estimation/up_guess.h"

#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "support/registry.h"

#include <functional>
#include <numbers>
#include <QTest>

using base::Random;
using base::UpAxis;
using base::Vec3d;
using process::guessedUp;

class UpGuessTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void statuesStandOnTheirBaseAlongEveryAxis();
    void whatIsCutOffStandsOnTheCut();
    void terrainsLie();
    void scannedGroundIsSeenFromAbove();
    void housesAreSeenFromAbove();
    void oneRangeScanTellsNothing();
    void roomsHaveTheirFloorBelow();
    void ballsTellNothing();
    void feetBearATable();
    void whatIsBuiltHeadDownStandsAsUsual();
    void theUsualAxisWinsAmongEquals();
    void emptyAndFlatModelsTellWhatTheyCan();
};

namespace {

/// A place that stands with y up, with its normal.
struct Place {
    Vec3d position, normal;
};

/// Points of a shape, noisy, uneven, with strays, turned so that `up` is upwards, far from the origin.
struct Weather {
    double noise = 0, strays = 0, offset = 0;
    bool normals = true;
};

tree::SurfelTree modelOf(const std::function<Place(Random&)>& shape, std::size_t count, UpAxis up,
                         const Weather& weather, Random& random) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = weather.normals;
    out.layout = layout;
    for (std::size_t i = 0; i < count; ++i) {
        Place place = shape(random);
        for (std::size_t k = 0; k < 3; ++k)
            place.position[k] +=
                weather.noise * (random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1));
        if (random.uniform() < weather.strays)
            place.position += Vec3d{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
        surfel::Surfel s;
        const Vec3d far = Vec3d{1, -1, 0.5} * weather.offset; // what the float position loses is the offset's fault
        s.position = base::cast<float>(fromStanding(up, place.position) + far);
        if (weather.normals)
            s.normal = base::cast<float>(fromStanding(up, place.normal));
        out.items.push_back(s);
    }
    surface::SurfaceDefinition definition;
    definition.boundary = surface::Boundary::None; // not looked at
    return process::prepare(std::move(out), {definition}).tree();
}

UpAxis guess(const tree::SurfelTree& tree, UpAxis usual = UpAxis::Y) {
    return guessedUp(process::upEvidence(tree), usual);
}

/// A lumpy body of revolution on a flat, round base: heights 0 to `tall`, its base as wide as `base`.
class Statue {
  public:
    explicit Statue(Random& random, bool hollow = false)
        : m_tall(random.uniform(1.2, 3.5)), m_base(random.uniform(0.5, 0.8)), m_hollow(hollow) {
        for (double& lump : m_lumps)
            lump = random.uniform(-0.12, 0.12);
        m_phase = random.uniform(0, 6);
    }
    /// Area by rejection would be exact; strips of the profile are close enough to it to be an uneven scan.
    Place operator()(Random& random) const {
        const double side = m_base * m_tall * 1.5, flat = 0.5 * m_base * m_base;
        const double turn = random.uniform(0, 2 * std::numbers::pi), c = std::cos(turn), s = std::sin(turn);
        if (!m_hollow && random.uniform() < flat / (flat + side)) {
            const double r = m_base * std::sqrt(random.uniform());
            return {{r * c, 0, r * s}, {0, -1, 0}};
        }
        const double t = random.uniform(), h = 1e-4, r = radius(t, turn);
        const double slope = (radius(t + h, turn) - radius(t - h, turn)) / (2 * h * m_tall);
        return {{r * c, t * m_tall, r * s}, base::normalized(Vec3d{c, -slope, s})};
    }

  private:
    double radius(double t, double turn) const {
        double out = std::sqrt(std::max(0.0, 1 - t * t)) * (1 - 0.4 * t);
        for (std::size_t k = 0; k < std::size(m_lumps); ++k)
            out += m_lumps[k] * std::sin(std::numbers::pi * double(k + 1) * t) *
                   (1 + 0.4 * std::sin(turn * double(k % 3) + m_phase));
        return m_base * std::max(0.02, out);
    }
    double m_tall, m_base, m_lumps[5], m_phase;
    bool m_hollow; ///< the base is missing
};

/// Hills as high as a part of their width.
class Terrain {
  public:
    Terrain(Random& random, double high) : m_high(high) {
        for (auto& wave : m_waves)
            wave = {random.uniform(-7, 7), random.uniform(-7, 7), random.uniform(0, 6)};
    }
    Place operator()(Random& random) const {
        const double x = random.uniform(-1, 1), z = random.uniform(-1, 1), h = 1e-4;
        const Vec3d slope{(height(x + h, z) - height(x - h, z)) / (2 * h), -1,
                          (height(x, z + h) - height(x, z - h)) / (2 * h)};
        return {{x, height(x, z), z}, base::normalized(-slope)};
    }

  private:
    double height(double x, double z) const {
        double out = 0;
        for (const Vec3d& w : m_waves)
            out += m_high * std::sin(w.x * x + w.y * z + w.z) / (1 + 0.3 * length(w));
        return out;
    }
    double m_high;
    Vec3d m_waves[6];
};

/// Floor, ceiling and walls seen from inside, with boxes that hide some of the floor, windows in the walls.
Place room(Random& random, const Vec3d& size) {
    const double areas[3] = {size.y * size.z, size.x * size.z, size.x * size.y};
    for (;;) {
        double pick = random.uniform() * (areas[0] + areas[1] + areas[2]);
        std::size_t k = 0;
        while (k < 2 && pick > areas[k])
            pick -= areas[k++];
        const bool high = random.uniform() < 0.5;
        Vec3d p{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
        p[k] = high ? 0.5 : -0.5;
        if (k != 1 && high && std::abs(p.y) < 0.3)
            continue; // a window
        if (k == 1 && !high && p.x > 0.1 && p.z > 0.1)
            p.y += 0.2; // a table
        Vec3d normal;
        normal[k] = high ? -1 : 1;
        for (std::size_t a = 0; a < 3; ++a)
            p[a] *= size[a];
        return {p, normal};
    }
}

/// A wide slab with a tower on it, by area.
Place block(Random& random) {
    for (;;) {
        const bool tower = random.uniform() < 0.23;
        const Vec3d half = tower ? Vec3d{0.4, 0.4, 0.4} : Vec3d{1, 0.2, 1}, middle{0, tower ? 0.8 : 0.2, 0};
        const double areas[3] = {half.y * half.z, half.x * half.z, half.x * half.y};
        double pick = random.uniform() * (areas[0] + areas[1] + areas[2]);
        std::size_t k = 0;
        while (k < 2 && pick > areas[k])
            pick -= areas[k++];
        Vec3d p, normal;
        for (std::size_t a = 0; a < 3; ++a)
            p[a] = middle[a] + half[a] * random.uniform(-1, 1);
        normal[k] = random.uniform() < 0.5 ? -1 : 1;
        p[k] = middle[k] + half[k] * normal[k];
        const bool inside =
            k == 1 && (tower ? normal.y < 0 : normal.y > 0 && std::abs(p.x) < 0.4 && std::abs(p.z) < 0.4);
        if (!inside)
            return {p, normal};
    }
}

Place ball(Random& random) {
    const double y = random.uniform(-1, 1), turn = random.uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - y * y);
    const Vec3d p{r * std::cos(turn), y, r * std::sin(turn)};
    return {p, p};
}

} // namespace

void UpGuessTest::statuesStandOnTheirBaseAlongEveryAxis() {
    for (int k = 0; k < test::effort(8); ++k)
        for (const base::UpRow& row : base::upTable()) {
            Random random(test::seed() + static_cast<unsigned>(k));
            const Weather weather{k % 2 * 0.003, k % 3 == 2 ? 0.002 : 0, k % 4 == 3 ? 1e3 : 0, k % 4 != 1};
            const auto tree = modelOf(Statue(random), 6000, row.axis, weather, random);
            for (const UpAxis usual : {UpAxis::Y, UpAxis::Z})
                QVERIFY2(guess(tree, usual) == row.axis,
                         qPrintable(QString("seed %1 up %2").arg(test::seed() + static_cast<unsigned>(k)).arg(row.id)));
        }
}

void UpGuessTest::whatIsCutOffStandsOnTheCut() {
    for (int k = 0; k < test::effort(4); ++k)
        for (const base::UpRow& row : base::upTable()) {
            Random random(test::seed() + static_cast<unsigned>(k));
            const auto tree = modelOf(Statue(random, true), 6000, row.axis, {k % 2 * 0.002, 0, 0, k % 3 != 0}, random);
            QVERIFY2(guess(tree) == row.axis,
                     qPrintable(QString("seed %1 up %2").arg(test::seed() + static_cast<unsigned>(k)).arg(row.id)));
        }
}

void UpGuessTest::terrainsLie() {
    for (int k = 0; k < test::effort(12); ++k)
        for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
            Random random(test::seed() + static_cast<unsigned>(k));
            const double high = random.uniform(0.01, 0.12);
            const auto tree = modelOf(Terrain(random, high), 6000, up, {k % 2 * 0.002, 0.001, 0, k % 3 != 0}, random);
            for (const UpAxis usual : {UpAxis::Y, UpAxis::Z})
                QVERIFY2(guess(tree, usual) == up,
                         qPrintable(QString("seed %1").arg(test::seed() + static_cast<unsigned>(k))));
        }
}

/// Normals that somebody saw tell which end of a sheet is up, along any axis; of what is no sheet they tell nothing.
void UpGuessTest::scannedGroundIsSeenFromAbove() {
    for (int k = 0; k < test::effort(6); ++k)
        for (const base::UpRow& row : base::upTable()) {
            Random random(test::seed() + static_cast<unsigned>(k));
            const auto tree = modelOf(Terrain(random, random.uniform(0.01, 0.12)), 6000, row.axis,
                                      {k % 2 * 0.002, 0.001, 0, true}, random);
            const auto seen = process::upEvidence(tree, process::KnownSides::Yes);
            QVERIFY2(guessedUp(seen, UpAxis::Y) == row.axis,
                     qPrintable(QString("seed %1 up %2").arg(test::seed() + static_cast<unsigned>(k)).arg(row.id)));
            const auto statue = modelOf(Statue(random), 6000, row.axis, {}, random);
            QVERIFY(guessedUp(process::upEvidence(statue, process::KnownSides::Yes), UpAxis::Y) == guess(statue));
        }
}

namespace {

/// A roof of two pitches on walls, of which a drone saw each as much as it liked, and nothing from below.
class House {
  public:
    explicit House(Random& random)
        : m_size{random.uniform(1, 3), random.uniform(0.6, 1.2), random.uniform(0.8, 1)},
          m_pitch(random.uniform(0.15, 0.55)) {
        for (double& wall : m_seen)
            wall = random.uniform(0.2, 1);
        m_roof = random.uniform(0.8, 1.2);
    }
    Place operator()(Random& random) const {
        const double ends = 2 * m_size.z * m_size.y, sides = 2 * m_size.x * m_size.y, roof = 2 * m_size.x * m_size.z;
        for (;;) {
            const double pick = random.uniform() * (ends + sides + roof * m_roof), a = random.uniform(-1, 1);
            const double h = random.uniform();
            const bool far = random.uniform() < 0.5;
            const double side = far ? 1 : -1;
            if (pick > ends + sides)
                return {{a * m_size.x, m_size.y + m_pitch * (1 - h) * m_size.z, side * h * m_size.z},
                        base::normalized(Vec3d{0, 1, side * m_pitch})};
            const bool end = pick < ends;
            if (random.uniform() > m_seen[2 * std::size_t(end) + std::size_t(far)])
                continue;
            return end ? Place{{side * m_size.x, h * m_size.y, a * m_size.z}, {side, 0, 0}}
                       : Place{{a * m_size.x, h * m_size.y, side * m_size.z}, {0, 0, side}};
        }
    }

  private:
    Vec3d m_size;
    double m_pitch, m_seen[4], m_roof;
};

} // namespace

/// Whichever wall is the largest plane: what looks up is there, what looks down is not.
void UpGuessTest::housesAreSeenFromAbove() {
    for (int k = 0; k < test::effort(3); ++k)
        for (const base::UpRow& row : base::upTable()) {
            Random random(test::seed() + static_cast<unsigned>(k));
            const House house(random);
            const auto scanned = [&](Random& r) { // no scan is exact
                Place out = house(r);
                out.normal = base::normalized(out.normal + r.unitVector() * 0.05);
                return out;
            };
            const auto tree = modelOf(scanned, 3000, row.axis, {k % 2 * 0.005, 0.001, 0, true}, random);
            QVERIFY2(guessedUp(process::upEvidence(tree, process::KnownSides::Yes), UpAxis::Y) == row.axis,
                     qPrintable(QString("seed %1 up %2").arg(test::seed() + static_cast<unsigned>(k)).arg(row.id)));
        }
}

/// All that one scanner sees faces it, whichever way that is.
void UpGuessTest::oneRangeScanTellsNothing() {
    for (const base::UpRow& row : base::upTable()) {
        Random random(test::seed());
        const auto half = [](Random& r) {
            for (;;) {
                const Place out = ball(r);
                if (r.uniform() < out.normal.y) // as many as the scanner has rays for
                    return out;
            }
        };
        const auto seen = process::upEvidence(modelOf(half, 6000, row.axis, {}, random), process::KnownSides::Yes);
        const auto told = process::upEvidence(modelOf(half, 6000, row.axis, {}, random));
        QVERIFY2(guessedUp(seen, UpAxis::Y) == guessedUp(told, UpAxis::Y), row.id);
    }
}

void UpGuessTest::roomsHaveTheirFloorBelow() {
    for (int k = 0; k < test::effort(6); ++k)
        for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
            Random random(test::seed() + static_cast<unsigned>(k));
            const Vec3d size{random.uniform(4, 8), random.uniform(2.2, 2.8), random.uniform(3.8, 6)};
            const auto tree =
                modelOf([&](Random& r) { return room(r, size); }, 6000, up, {0.01, 0.002, 0, k % 2 == 0}, random);
            QVERIFY2(guess(tree) == up, qPrintable(QString("seed %1").arg(test::seed() + static_cast<unsigned>(k))));
        }
}

void UpGuessTest::ballsTellNothing() {
    for (int k = 0; k < test::effort(4); ++k) {
        Random random(test::seed() + static_cast<unsigned>(k));
        const auto tree = modelOf(ball, 8000, UpAxis::Y, {k * 0.004, 0.001, k == 3 ? 1e3 : 0, k != 1}, random);
        for (const base::UpRow& row : base::upTable())
            QVERIFY2(guess(tree, row.axis) == row.axis, row.id);
    }
}

void UpGuessTest::feetBearATable() {
    Random random(test::seed());
    const auto table = [](Random& r) -> Place {
        const double pick = r.uniform();
        if (pick < 0.8) { // the top, above and below
            const bool above = pick < 0.4;
            return {{r.uniform(-1, 1), above ? 1.0 : 0.95, r.uniform(-1, 1)}, {0, above ? 1.0 : -1.0, 0}};
        }
        const double turn = r.uniform(0, 2 * std::numbers::pi), c = std::cos(turn), s = std::sin(turn);
        const Vec3d leg{r.uniform() < 0.5 ? -0.9 : 0.9, 0, r.uniform() < 0.5 ? -0.9 : 0.9};
        return {leg + Vec3d{0.05 * c, 0.95 * r.uniform(), 0.05 * s}, {c, 0, s}};
    };
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z, UpAxis::X})
        QCOMPARE(guess(modelOf(table, 6000, up, {0.002, 0, 0, true}, random)), up);
}

/// A machine part hangs from its largest plane as often as it stands on it; a scan of it lies as it was scanned.
void UpGuessTest::whatIsBuiltHeadDownStandsAsUsual() {
    Random random(test::seed());
    for (const base::UpRow& row : base::upTable()) {
        const bool headDown = row.up.x + row.up.y + row.up.z < 0;
        const auto built = modelOf(block, 6000, row.axis, {}, random);
        const auto scanned = modelOf(block, 6000, row.axis, {0.004, 0, 0, false}, random);
        for (const UpAxis usual : {UpAxis::Y, UpAxis::Z}) {
            QVERIFY2(guess(built, usual) == (headDown ? usual : row.axis), row.id);
            QVERIFY2(guess(scanned, usual) == row.axis, row.id);
        }
    }
}

void UpGuessTest::theUsualAxisWinsAmongEquals() {
    Random random(test::seed());
    const auto tree = modelOf([](Random& r) { return room(r, {1, 1, 1}); }, 6000, UpAxis::Y, {}, random);
    const auto evidence = process::upEvidence(tree);
    for (const base::UpRow& row : base::upTable())
        QVERIFY2(guessedUp(evidence, row.axis) == row.axis, row.id);
}

void UpGuessTest::emptyAndFlatModelsTellWhatTheyCan() {
    QVERIFY(guess({}, UpAxis::Z) == UpAxis::Z);
    Random random(test::seed());
    const auto plate = [](Random& r) { return Place{{r.uniform(), 0, r.uniform()}, {0, 1, 0}}; };
    QVERIFY(guess(modelOf(plate, 500, UpAxis::Z, {}, random)) == UpAxis::Z);
    const auto line = [](Random& r) { return Place{{r.uniform(), 0, 0}, {0, 1, 0}}; };
    QVERIFY(guess(modelOf(line, 500, UpAxis::Y, {}, random)) == UpAxis::Y);
}

static const test::Registered<UpGuessTest> registered;
#include "up_guess_test.moc"
