// What bounds a solid has no rim, however thin it is; what has one keeps it, whatever else there is: random fins,
// plates, cups, wedges, and holes, halves, tubes, cut necks, folded cloths, sheets among solids.
#include "mesh/solids.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d, solids::Solid;

class ClosedRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void edgesThinnerThanTheSpacingAreNoRims_data();
    void edgesThinnerThanTheSpacingAreNoRims();
    void gapsAreRims_data();
    void gapsAreRims();
    void clothsKeepTheirRimsHoweverTheyAreFolded();
    void aSheetAmongThinSolidsIsOpen();
    void aHoleInOneOfManySolidsIsOne();
    void cutPiecesAreOpen();
    void unevenSolidsAreClosed();
    void solidsWithoutSidesAreClosed();
};

namespace {

constexpr double spacing = 0.03;

const solids::Sampling hows[] = {{spacing, 1, 0, 0, {}}, {spacing, 1, 0.1, 0, {}}, {spacing, 1, 0, 15, {}}};

void addHows() {
    QTest::addColumn<int>("how");
    QTest::newRow("even") << 0;
    QTest::newRow("noisy") << 1;
    QTest::newRow("strays") << 2;
}

float limitOf(surfel::SurfelList list) {
    return process::prepare(std::move(list), {}).definition().boundaryLimit;
}

Solid plates(double thickness, double gap) {
    Solid out;
    for (int i = 0; i < 3; ++i)
        out.parts.push_back(
            solids::box({-0.5, -0.4, i * (thickness + gap)}, {0.5, 0.4, i * (thickness + gap) + thickness}));
    return out;
}

Solid cup(double thickness) {
    return {{solids::ball({}, 0.5)}, {solids::ball({}, 0.5 - thickness), solids::box({-1, -1, 0.1}, {1, 1, 1})}};
}

Solid cylinder(double radius, double lo, double hi) {
    constexpr int sides = 48;
    std::vector<std::array<double, 2>> round;
    for (int i = 0; i < sides; ++i)
        round.push_back({radius * std::cos(2 * shapes::pi * i / sides), radius * std::sin(2 * shapes::pi * i / sides)});
    return {{solids::prism(round, lo, hi)}, {}};
}

Solid bottle(double neck) {
    return {{solids::ball({}, 0.3), cylinder(neck, 0, 0.5).parts[0]}, {}};
}

/// Spacings vary by up to 4.5, samples per area by 20.
solids::Sampling uneven(base::Random& random) {
    return {random.uniform(0.025, 0.045), std::exp(random.uniform(0, std::log(4.5))), random.uniform(0, 0.1), 0, {}};
}

/// Layers that far apart, folded to and fro, as one sheet.
surfel::SurfelList foldedCloth(double gap, base::Random& random) {
    constexpr int layers = 5;
    constexpr double side = 0.6;
    const double radius = gap / 2, turn = shapes::pi * radius, length = layers * side + (layers - 1) * turn;
    surfel::SurfelList out;
    out.layout = shapes::layout(true, true);
    solids::Spread flat({spacing, 1, 0, 0, {}});
    const auto draws = static_cast<int>(5 * length * side / (spacing * spacing));
    for (int i = 0; i < draws; ++i) {
        const double t = random.uniform(0, length), y = random.uniform(0, side);
        if (!flat.take({t, y, 0}, {0, 0, 1}))
            continue;
        const int layer = std::min(static_cast<int>(t / (side + turn)), layers - 1);
        const double u = t - layer * (side + turn), way = layer % 2 == 0 ? 1 : -1,
                     angle = std::max(0.0, (u - side) / radius);
        const double along = std::min(u, side) + radius * std::sin(angle);
        out.items.push_back(
            shapes::surfelAt({way > 0 ? along : side - along, y, layer * gap + radius * (1 - std::cos(angle))},
                             {-std::sin(angle), 0, way * std::cos(angle)}, 0));
    }
    return out;
}

} // namespace

void ClosedRimsTest::edgesThinnerThanTheSpacingAreNoRims_data() {
    addHows();
}

void ClosedRimsTest::edgesThinnerThanTheSpacingAreNoRims() {
    QFETCH(int, how);
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(2); ++round) {
        const double thickness = random.uniform(0.6, 1.6) * spacing, gap = random.uniform(1.5, 4) * spacing;
        const double angle = random.uniform(0.15, 0.6);
        const std::pair<const char*, Solid> all[] = {{"fins", solids::comb(thickness, gap)},
                                                     {"plates", plates(thickness, gap)},
                                                     {"cup", cup(thickness)},
                                                     {"slabs", solids::crossedSlabs(thickness)},
                                                     {"wedge", {{solids::wedge(angle, 0.8, 0.8)}, {}}}};
        for (const auto& [name, solid] : all) {
            const float limit = limitOf(solids::sampled(solid, hows[how], random));
            QVERIFY2(std::isinf(limit), QByteArray(name) + " thick " + QByteArray::number(thickness / spacing) +
                                            " gap " + QByteArray::number(gap / spacing) + " angle " +
                                            QByteArray::number(angle) + " seed " + QByteArray::number(test::seed()));
        }
    }
}

void ClosedRimsTest::gapsAreRims_data() {
    addHows();
}

void ClosedRimsTest::gapsAreRims() {
    QFETCH(int, how);
    base::Random random(test::seed());
    const Solid ball{{solids::ball({}, 0.5)}, {}}, box{{solids::box({-0.4, -0.3, -0.3}, {0.4, 0.3, 0.3})}, {}};
    const double hole = random.uniform(7, 11) * spacing, height = random.uniform(-0.35, 0.35);
    const double wall = random.uniform(3, 6) * spacing;
    struct Row {
        const char* name;
        Solid solid;
        std::function<bool(const Vec3d&)> kept;
    };
    const Row all[] = {
        {"hole in a ball", ball, [&](const Vec3d& p) { return p.z < 0 || std::hypot(p.x, p.y) > hole; }},
        {"hole in a box", box, [&](const Vec3d& p) { return p.z > -0.28 || std::hypot(p.x, p.y) > hole; }},
        {"part of a ball", ball, [&](const Vec3d& p) { return p.z < height; }},
        {"box without a bottom", box, [&](const Vec3d& p) { return p.z > -0.28; }},
        {"tube", box, [&](const Vec3d& p) { return std::abs(p.z) < 0.28; }},
        {"two walls", solids::shell(wall), [&](const Vec3d& p) { return p.z < 0.1; }},
        {"fins without a floor", solids::comb(wall, wall), [&](const Vec3d& p) { return p.z > -0.28; }},
    };
    for (const auto& [name, solid, kept] : all) {
        surfel::SurfelList list = solids::sampled(solid, hows[how], random);
        std::erase_if(list.items, [&](const surfel::Surfel& s) { return !kept(base::cast<double>(s.position)); });
        const float limit = limitOf(std::move(list));
        QVERIFY2(!std::isinf(limit), QByteArray(name) + " hole " + QByteArray::number(hole / spacing) + " height " +
                                         QByteArray::number(height) + " wall " + QByteArray::number(wall / spacing) +
                                         " seed " + QByteArray::number(test::seed()));
    }
}

/// From 1.5 spacings between the layers on: nearer, and with no surfel on their ends, plates are no different.
void ClosedRimsTest::clothsKeepTheirRimsHoweverTheyAreFolded() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(4); ++round) {
        const double gap = random.uniform(1.5, 6);
        QVERIFY2(!std::isinf(limitOf(foldedCloth(gap * spacing, random))),
                 QByteArray::number(gap) + " seed " + QByteArray::number(test::seed()));
    }
}

/// What is open is the sheet, a fiftieth of what looks like rims.
void ClosedRimsTest::aSheetAmongThinSolidsIsOpen() {
    constexpr double wide = 0.05;
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(2); ++round) {
        const double thickness = random.uniform(0.6, 1.2) * wide, gap = random.uniform(3, 5) * wide;
        const std::size_t count = test::sanitized ? 20 : 40 + random.below(12);
        Solid all;
        for (std::size_t i = 0; i < count; ++i) {
            const double z = static_cast<double>(i) * (thickness + gap);
            all.parts.push_back(solids::box({-0.5, -0.4, z}, {0.5, 0.4, z + thickness}));
        }
        const solids::Sampling sampling{wide, 1, 0.1 * static_cast<double>(round % 2), 0, {}};
        surfel::SurfelList list = solids::sampled(all, sampling, random);
        QVERIFY(std::isinf(limitOf(list)));
        solids::Spread spread(sampling);
        for (int i = 0; i < 2000; ++i) {
            const Vec3d p{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), -0.5};
            if (spread.take(p, {0, 0, 1}))
                list.items.push_back(shapes::surfelAt(p, {0, 0, 1}, 0));
        }
        QVERIFY2(!std::isinf(limitOf(std::move(list))),
                 QByteArray::number(thickness / wide) + " seed " + QByteArray::number(test::seed()));
    }
}

void ClosedRimsTest::aHoleInOneOfManySolidsIsOne() {
    base::Random random(test::seed());
    const double hole = random.uniform(7, 11) * spacing;
    surfel::SurfelList list;
    for (int i = 0; i < (test::sanitized ? 8 : 20); ++i) {
        surfel::SurfelList one = solids::sampled({{solids::ball({}, 0.5)}, {}}, hows[i % 2], random);
        if (i == 0)
            std::erase_if(one.items, [&](const surfel::Surfel& s) {
                return s.position.z > 0 && std::hypot(s.position.x, s.position.y) < static_cast<float>(hole);
            });
        list.layout = one.layout;
        for (surfel::Surfel& s : one.items) {
            s.position.x += 1.5f * static_cast<float>(i);
            list.items.push_back(s);
        }
    }
    QVERIFY2(!std::isinf(limitOf(std::move(list))),
             QByteArray::number(hole / spacing) + " seed " + QByteArray::number(test::seed()));
}

/// At any angle; necks no wider than 5 spacings, whose opening winding numbers hardly see.
void ClosedRimsTest::cutPiecesAreOpen() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(15); ++round) {
        const solids::Sampling sampling = uneven(random);
        const bool upright = round % 3 > 1;
        const double radius = random.uniform(0.12, 0.25);
        const Solid solid = round % 3 == 0   ? Solid{{solids::ball({}, 0.5)}, {}}
                            : round % 3 == 1 ? cylinder(radius, -0.5, 0.5)
                                             : bottle(std::max(0.12, 2.6 * sampling.spacing));
        const Vec3d across = upright ? base::normalized(Vec3d{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1})
                                     : random.unitVector();
        const double height = upright ? random.uniform(0.36, 0.42) : random.uniform(-0.2, 0.2);
        surfel::SurfelList list = solids::sampled(solid, sampling, random);
        std::erase_if(list.items,
                      [&](const surfel::Surfel& s) { return dot(base::cast<double>(s.position), across) > height; });
        QVERIFY2(!std::isinf(limitOf(std::move(list))), QByteArray::number(round) + " height " +
                                                            QByteArray::number(height) + " seed " +
                                                            QByteArray::number(test::seed()));
    }
}

void ClosedRimsTest::unevenSolidsAreClosed() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(6); ++round) {
        const solids::Sampling sampling = uneven(random);
        const std::pair<const char*, Solid> all[] = {
            {"bottle", bottle(3 * sampling.spacing)},
            {"cylinder", cylinder(0.25, -0.4, 0.4)},
            {"drilled", solids::drilled(0.15)},
            {"plates", plates(random.uniform(0.6, 1.2) * sampling.spacing, 5 * sampling.spacing)}};
        for (const auto& [name, solid] : all)
            QVERIFY2(std::isinf(limitOf(solids::sampled(solid, sampling, random))),
                     QByteArray(name) + " seed " + QByteArray::number(test::seed()));
    }
}

/// Nothing but runs tells there: what looks like a rim by chance stands alone.
void ClosedRimsTest::solidsWithoutSidesAreClosed() {
    base::Random random(test::seed());
    process::PrepareOptions options;
    options.definition.frame = surface::Frame::Hyperplanes;
    for (int round = 0; round < test::effort(4); ++round)
        for (const Solid& solid : {solids::tori(), solids::drilled(0.15), bottle(0.15)}) {
            surfel::SurfelList list = solids::sampled(solid, {spacing, 1, 0.1, 0, {}}, random);
            list.layout = shapes::layout(true, false);
            QVERIFY2(std::isinf(process::prepare(std::move(list), options).definition().boundaryLimit),
                     QByteArray::number(round) + " seed " + QByteArray::number(test::seed()));
        }
}

static const test::Registered<ClosedRimsTest> registered;
#include "closed_rims_test.moc"
