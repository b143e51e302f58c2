// Discs at the creases of models with cells: none stands out, and together they still cover the faces.
#include "core/render/splats/label_cuts.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using base::Random, base::Vec3d, base::Vec3f;

class LabelCutsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void discsEndAtCreases_data();
    void discsEndAtCreases();
    void discsEndAtBends();
    void cornersHoldTheirDiscs_data();
    void cornersHoldTheirDiscs();
};

namespace {

constexpr double spacing = 0.1;
constexpr float radiusOfSupport = 0.35f;

/// Faces with corners of that angle, and an edge.
plane_solids::Solid prism(double degrees) {
    const double half = degrees * plane_solids::pi / 360, s = std::sin(half), c = std::cos(half);
    return plane_solids::intersection(
        {{{s, c, 0}, 0.9 * s}, {{s, -c, 0}, 0.9 * s}, {{-1, 0, 0}, 0.9}, {{0, 0, 1}, 0.5}, {{0, 0, -1}, 0.5}});
}

struct Disc {
    Vec3f centre, normal;
    float radius;
    render::DiscCut cut;

    bool covers(const Vec3f& x) const {
        const Vec3f way = x - centre, along = way - normal * dot(way, normal);
        const auto beyond = [&](const render::CutLine& line) {
            return line.part > 0 && dot(along, line.direction) > radius * line.part;
        };
        return length(along) <= radius * cut.radius && !beyond(cut) && !beyond(cut.second);
    }
};

std::vector<Disc> discsOf(const tree::SurfelTree& model) {
    render::LabelCuts cuts(model, *cells::LabelLayout::of(*model.layout()), radiusOfSupport);
    std::vector<Disc> out;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        render::CutCodes codes{};
        cuts.cut(block, codes);
        for (int slot = 0; slot < block.size(); ++slot)
            out.push_back(
                {block.position(slot), block.normal(slot), radiusOfSupport * block.support(slot),
                 render::discCut(block.normal(slot), block.support(slot), codes[static_cast<std::size_t>(slot)])});
    });
    return out;
}

/// How discs cover a solid's faces: random points of the discs, and those of them on the faces.
struct Cover {
    std::size_t places = 0, bare = 0; ///< on faces; that no disc shows
    std::size_t points = 0, out = 0;  ///< that are shown; off the faces by .15 of the radius

    QByteArray told() const {
        return QString("seed %1: %2 of %3 points stand out, %4 of %5 places bare")
            .arg(test::seed())
            .arg(out)
            .arg(points)
            .arg(bare)
            .arg(places)
            .toUtf8();
    }
};

Cover coverOf(const plane_solids::Solid& solid, const std::vector<Disc>& discs, Random& random) {
    Cover all;
    for (const Disc& disc : discs)
        for (int k = 0; k < 8; ++k) {
            const Vec3f u = base::perpendicular(disc.normal), v = cross(disc.normal, u);
            const auto angle = static_cast<float>(random.uniform(0, 2 * plane_solids::pi));
            const float far = disc.radius * static_cast<float>(std::sqrt(random.uniform()));
            const Vec3f x = disc.centre + (u * std::cos(angle) + v * std::sin(angle)) * far;
            if (length(disc.centre) > 2.1f) // samples of what is open end somewhere
                continue;
            const double height = solid.value(base::cast<double>(x));
            if (disc.covers(x)) {
                ++all.points;
                all.out += height > 0.15 * static_cast<double>(disc.radius) ? 1 : 0;
            }
            if (std::abs(height) > 1e-4 * spacing)
                continue;
            ++all.places;
            all.bare += std::none_of(discs.begin(), discs.end(),
                                     [&](const Disc& other) {
                                         return std::abs(dot(x - other.centre, other.normal)) < 1e-3f * other.radius &&
                                                other.covers(x);
                                     })
                            ? 1
                            : 0;
        }
    return all;
}

} // namespace

void LabelCutsTest::discsEndAtCreases_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("cube") << 0;
    QTest::newRow("L-block") << 1;
    QTest::newRow("blunt pyramid") << 2;
    QTest::newRow("slender pyramid") << 3;
    QTest::newRow("acute prism") << 4;
    QTest::newRow("acute wedge") << 5;
}

void LabelCutsTest::discsEndAtCreases() {
    QFETCH(int, kind);
    Random random(test::seed());
    const plane_solids::Solid solid = kind == 0   ? plane_solids::cube(0.8)
                                      : kind == 1 ? plane_solids::lBlock(0.9)
                                      : kind == 2 ? plane_solids::pyramid(6, 1, 0.4) // 40 degrees at the base
                                      : kind == 3 ? plane_solids::pyramid(4, 0.5, 1.8)
                                      : kind == 4 ? prism(20)
                                                  : prism(35);
    const auto s = plane_solids::sampled(solid, 2.4, spacing, random);
    const Cover all = coverOf(solid, discsOf(plane_solids::surfaceOf(s.surfels).tree()), random);
    const QByteArray told = all.told();
    QVERIFY2(all.places > 2000 && all.points > 2000, told);
    QVERIFY2(all.out <= all.points / 1000, told);
    QVERIFY2(all.bare <= all.places / (kind < 2 ? 400 : 200), told); // tips are narrower than a spacing
}

/// Faces that turn by less than what counts as a crease are one cell, and flat all the same.
void LabelCutsTest::discsEndAtBends() {
    Random random(test::seed());
    const plane_solids::Solid solid = plane_solids::intersection(
        {{{0, std::sin(0.25), std::cos(0.25)}, 0.5}, {{0, -std::sin(0.25), std::cos(0.25)}, 0.5}});
    plane_solids::SampledSolid s = plane_solids::sampled(solid, 2.4, spacing, random);
    std::vector<cells::Label> labels(s.surfels.size()); // all of one cell, without a crease
    cells::setLabels(s.surfels, labels);
    const Cover all = coverOf(solid, discsOf(plane_solids::surfaceOf(s.surfels).tree()), random);
    const QByteArray told = all.told();
    QVERIFY2(all.places > 2000 && all.points > 2000, told);
    QVERIFY2(all.out <= all.points / 1000, told);
    QVERIFY2(all.bare <= all.places / 1000, told);
}

void LabelCutsTest::cornersHoldTheirDiscs_data() {
    QTest::addColumn<double>("degrees");
    for (const double degrees : {35.0, 50.0, 60.0, 75.0})
        QTest::addRow("%g", degrees) << degrees;
}

/// Faces with corners of that angle: nothing of a disc is past an edge by more than a fifth of its radius or so.
void LabelCutsTest::cornersHoldTheirDiscs() {
    QFETCH(double, degrees);
    Random random(test::seed());
    int corners = 0, out = 0;
    for (int round = 0; round < 12; ++round) {
        const plane_solids::Solid solid = prism(degrees);
        const std::vector<Disc> discs =
            discsOf(plane_solids::surfaceOf(plane_solids::sampled(solid, 2.4, spacing, random).surfels).tree());
        for (const Disc& disc : discs) {
            int near = 0;
            for (const plane_solids::Plane& plane : solid.planes)
                near += plane.f(base::cast<double>(disc.centre)) > -spacing;
            if (near < 3)
                continue;
            ++corners;
            const Vec3f u = base::perpendicular(disc.normal), v = cross(disc.normal, u);
            double most = 0; // over the rim of what is drawn
            for (int k = 0; k < 64; ++k) {
                const auto angle = static_cast<float>(2 * plane_solids::pi * k / 64);
                const Vec3f way = (u * std::cos(angle) + v * std::sin(angle)) * disc.radius;
                for (float part = 0.02f; part <= 1; part += 0.02f)
                    if (const Vec3f x = disc.centre + way * part; disc.covers(x))
                        most = std::max(most, solid.value(base::cast<double>(x)));
            }
            out += most > 0.27 * static_cast<double>(disc.radius) ? 1 : 0;
        }
    }
    const QByteArray told = QString("seed %1: %2 of %3").arg(test::seed()).arg(out).arg(corners).toUtf8();
    QVERIFY2(corners > 50 && out <= corners / 200, told);
}

static const test::Registered<LabelCutsTest> registered;
#include "label_cuts_test.moc"
