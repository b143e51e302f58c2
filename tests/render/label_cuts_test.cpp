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
        return length(along) <= radius * cut.radius && !(cut.part > 0 && dot(along, cut.direction) > radius * cut.part);
    }
};

std::vector<Disc> discsOf(const tree::SurfelTree& model) {
    render::LabelCuts cuts(model, *cells::LabelLayout::of(*model.layout()), radiusOfSupport);
    std::vector<Disc> out;
    model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        render::CutCodes codes{};
        cuts.cut(block, codes);
        for (int slot = 0; slot < block.size(); ++slot)
            out.push_back({block.position(slot), block.normal(slot), radiusOfSupport * block.support(slot),
                           render::discCut(block.normal(slot), codes[static_cast<std::size_t>(slot)])});
    });
    return out;
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
    const surface::Surface surface = plane_solids::surfaceOf(s.surfels);
    const std::vector<Disc> discs = discsOf(surface.tree());
    // places of the faces are those of discs, moved a little within the face
    std::size_t places = 0, bare = 0, points = 0, out = 0;
    for (const Disc& disc : discs)
        for (int k = 0; k < 8; ++k) {
            const Vec3f u = base::perpendicular(disc.normal), v = cross(disc.normal, u);
            const auto angle = static_cast<float>(random.uniform(0, 2 * plane_solids::pi));
            const float far = disc.radius * static_cast<float>(std::sqrt(random.uniform()));
            const Vec3f x = disc.centre + (u * std::cos(angle) + v * std::sin(angle)) * far;
            const double height = solid.value(base::cast<double>(x));
            if (disc.covers(x)) {
                ++points;
                out += height > 0.15 * static_cast<double>(disc.radius) ? 1 : 0;
            }
            if (std::abs(height) > 1e-4 * spacing)
                continue;
            ++places;
            bare += std::none_of(discs.begin(), discs.end(),
                                 [&](const Disc& other) {
                                     return std::abs(dot(x - other.centre, other.normal)) < 1e-3f * other.radius &&
                                            other.covers(x);
                                 })
                        ? 1
                        : 0;
        }
    const QByteArray told = QString("seed %1: %2 of %3 points stand out, %4 of %5 places bare")
                                .arg(test::seed())
                                .arg(out)
                                .arg(points)
                                .arg(bare)
                                .arg(places)
                                .toUtf8();
    QVERIFY2(places > 2000 && points > 2000, told);
    QVERIFY2(out <= points / 500, told);                     // a corner has two edges and a disc one cut
    QVERIFY2(bare <= places / (kind < 3 ? 200 : 100), told); // tips are narrower than a spacing
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
