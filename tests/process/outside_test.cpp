// Votes for the outer side, against the outermost points sought one direction after the other.
#include "core/process/estimation/orientation/outside.h"

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <cmath>
#include <numbers>
#include <QTest>

using namespace process;
using base::Vec3d;
using base::Vec3f;

namespace {

double plainVote(std::span<const Vec3f> positions, std::span<const Vec3f> normals,
                 std::span<const std::uint32_t> members) {
    constexpr int directions = 48;
    double sum = 0;
    for (int k = 0; k < directions; ++k) {
        const double z = 1 - (2 * static_cast<double>(k) + 1.0) / directions, r = std::sqrt(1 - z * z);
        const double angle = static_cast<double>(k) * std::numbers::pi * (3 - std::sqrt(5.0));
        const Vec3f way = base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), z});
        std::uint32_t top = members.front();
        for (const std::uint32_t i : members)
            if (dot(positions[i], way) > dot(positions[top], way))
                top = i;
        sum += static_cast<double>(dot(normals[top], way));
    }
    return sum / directions;
}

} // namespace

class OutsideTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void OfSeveralOutermostMembersTheFirstOneVotes_data();
    void OfSeveralOutermostMembersTheFirstOneVotes();
};

void OutsideTest::OfSeveralOutermostMembersTheFirstOneVotes_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<double>("step"); // of a lattice, whose corners stand in several places of the list
    QTest::newRow("one") << 1 << 0.0;
    QTest::newRow("few") << 50 << 0.0;
    QTest::newRow("many") << 50000 << 0.0;
    QTest::newRow("lattice") << 50000 << 0.25;
}

/// To the bit, at any number of threads, also far from zero.
void OutsideTest::OfSeveralOutermostMembersTheFirstOneVotes() {
    QFETCH(int, points);
    QFETCH(double, step);
    base::Random random(test::seed());
    for (const double away : {0.0, -1e5}) {
        std::vector<Vec3f> positions, normals;
        std::vector<std::uint32_t> members;
        for (int i = 0; i < points; ++i) {
            Vec3d p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
            for (std::size_t axis = 0; step > 0 && axis < 3; ++axis)
                p[axis] = std::round(p[axis] / step) * step;
            positions.push_back(base::cast<float>(p + Vec3d{away, away, away}));
            normals.push_back(base::cast<float>(random.unitVector()));
            if (random.uniform() < 0.9 || i == 0)
                members.push_back(static_cast<std::uint32_t>(i));
        }
        const double wanted = plainVote(positions, normals, members);
        for (const int threads : {1, 0}) {
            base::setThreadCount(threads);
            QVERIFY2(Outside(positions).vote(normals, members) == wanted,
                     qPrintable(QString("seed %1, %2 away").arg(test::seed()).arg(away)));
        }
    }
    base::setThreadCount(0);
}

static const test::Registered<OutsideTest> registered;
#include "outside_test.moc"
