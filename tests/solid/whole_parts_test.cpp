// Parts that go as a whole when models are put together, against formulas: shapes of every kind and density, and balls.
#include "core/base/random.h"
#include "core/solid/seam_labels.h"
#include "placed_shapes.h"
#include "support/registry.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <QTest>

using base::Vec3d;
using solid::Operation;
using test::placed;

class WholePartsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void partsThatGoWholeAreCounted();
    void nobodyCountsUnasked();
};

namespace {

/// Shapes that stand apart, on a lattice, each with its own spacing.
class Parts {
  public:
    void add(const char* id, const solid::Size& size, double spacing, const solid::Pose& pose) {
        const solid::PrimitiveRow& row = solid::primitive(id);
        m_parts.push_back(placed(solid::surfelsOf(row, size, spacing, {}), pose));
        m_sides.push_back(std::make_unique<solid::PrimitiveSide>(row, size, pose));
    }
    surface::Surface surface() const {
        surfel::SurfelList all;
        for (const surfel::SurfelList& part : m_parts) // balls have no labels
            if (part.layout->words() >= all.layout->words())
                all.layout = part.layout;
        for (const surfel::SurfelList& part : m_parts) {
            solid::Translation translation(*part.layout, *all.layout);
            for (std::size_t i = 0; i < part.size(); ++i)
                all.append(part.items[i], translation(part.extraOf(i)));
        }
        return {tree::SurfelTree::build(all), {}};
    }
    /// With all of it grown by `by`.
    bool contains(const base::Vec3f& x, double by) const {
        return std::any_of(m_sides.begin(), m_sides.end(),
                           [&](const auto& side) { return side->at(base::cast<double>(x)).value < by; });
    }
    /// Parts with all surfels inside of `other`, or outside of it; none where a surfel decides that is near the other's
    /// surface: there samples do not tell.
    std::optional<std::size_t> wholly(bool inside, const Parts& other) const {
        constexpr double near = 0.08; // half of the widest spacing
        const auto count = [&](double by) {
            return static_cast<std::size_t>(std::count_if(m_parts.begin(), m_parts.end(), [&](const auto& part) {
                return std::all_of(part.items.begin(), part.items.end(),
                                   [&](const surfel::Surfel& s) { return other.contains(s.position, by) == inside; });
            }));
        };
        const std::size_t least = count(-near);
        return least == count(near) ? std::optional(least) : std::nullopt;
    }

  private:
    std::vector<surfel::SurfelList> m_parts;
    std::vector<std::unique_ptr<solid::PrimitiveSide>> m_sides;
};

Parts latticeOf(base::Random& random, int count, double smallest, double largest, const Vec3d& offset) {
    constexpr double apart = 4;
    Parts out;
    for (int k = 0; k < count; ++k) {
        const double r = random.uniform(smallest, largest);
        const Vec3d at = offset + Vec3d{apart * (k % 3), apart * (k / 3), random.uniform(-0.3, 0.3)};
        const solid::Pose pose = solid::poseAlong(at, random.unitVector());
        const double spacing = r * random.uniform(0.09, 0.15);
        const double kind = random.uniform();
        if (kind < 0.4)
            out.add("ball", {r, 0, 0}, spacing, pose);
        else if (kind < 0.6)
            out.add("box", {r, 1.2 * r, 1.1 * r}, spacing, pose);
        else if (kind < 0.8)
            out.add("box", {1.2 * r, 1.2 * r, 3 * spacing}, spacing, pose); // a plate
        else
            out.add("cone", {0.5 * r, 1.5 * r, 0}, spacing, pose);
    }
    return out;
}

} // namespace

void WholePartsTest::partsThatGoWholeAreCounted() {
    std::size_t all = 0;
    for (int k = 0; k < test::effort(10) || (all == 0 && k < 100); ++k) {
        base::Random random(1000 * test::seed() + static_cast<unsigned>(k));
        const Parts model = latticeOf(random, 6, 0.3, 0.6, {}),
                    other = latticeOf(random, 6, 0.9, 1.3, {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0});
        const surface::Surface a = model.surface(), b = other.surface();
        for (const Operation operation : {Operation::Union, Operation::Difference, Operation::Intersection}) {
            solid::CombineOptions options;
            options.parts = true;
            const auto gone = model.wholly(operation != Operation::Intersection, other),
                       otherGone = other.wholly(operation == Operation::Union, model);
            if (!gone || !otherGone || (*gone == 6 && operation != Operation::Union))
                continue; // nothing may be left
            const solid::Combined result =
                solid::combine(a, {solid::SurfaceSide(b), b.tree().surfels()}, operation, options);
            const QByteArray what = QString("model %1, operation %2, seed %3")
                                        .arg(k)
                                        .arg(static_cast<int>(operation))
                                        .arg(test::seed())
                                        .toUtf8();
            QVERIFY2(result.partsGone == *gone,
                     what + ": " + QByteArray::number(result.partsGone) + " for " + QByteArray::number(*gone));
            QVERIFY2(result.otherPartsGone == *otherGone, what +
                                                              ", other: " + QByteArray::number(result.otherPartsGone) +
                                                              " for " + QByteArray::number(*otherGone));
            all += *gone + *otherGone;
        }
    }
    QVERIFY(all > 0);
}

void WholePartsTest::nobodyCountsUnasked() {
    const surface::Surface small = test::shapeAt("ball", {0.3, 0, 0}, 0.05),
                           large = test::shapeAt("ball", {1, 0, 0}, 0.1);
    const solid::Combined result =
        solid::combine(small, {solid::SurfaceSide(large), large.tree().surfels()}, Operation::Union);
    QVERIFY(result.removed == small.tree().size() && result.partsGone == 0);
}

static const test::Registered<WholePartsTest> registered;
#include "whole_parts_test.moc"
