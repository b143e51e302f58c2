// Graded fields against their definition, sought plainly.
#include "core/process/estimation/graded_field.h"

#include "core/base/parallel.h"
#include "core/process/neighbours/cloud_neighbours.h"
#include "support/registry.h"
#include "uneven_sphere.h"

#include <QTest>

using namespace process;

namespace {

constexpr float slope = 0.5f;

/// Radii that differ everywhere, some by much.
std::vector<float> someRadii(std::size_t count, base::Random& random) {
    std::vector<float> out(count);
    for (float& h : out)
        h = static_cast<float>(0.1 * std::exp(1.5 * random.normal()));
    return out;
}

/// Lifted along one edge after the other until nothing is left to lift.
std::vector<float> plainlyRaised(std::vector<float> h, const NeighbourGraph& graph) {
    bool changed = true;
    const auto lift = [&](std::size_t i, float to) {
        changed |= h[i] < to;
        h[i] = std::max(h[i], to);
    };
    while (std::exchange(changed, false))
        for (std::size_t i = 0; i < graph.size(); ++i) {
            const NeighbourGraph::Row row = graph.row(i);
            for (std::size_t k = 0; k < graph.count(); ++k) {
                const float drop = slope * graph.distance(i, row[k]);
                lift(i, h[row[k]] - drop);
                lift(row[k], h[i] - drop);
            }
        }
    return h;
}

std::vector<float> negative(std::vector<float> values) {
    for (float& value : values)
        value = -value;
    return values;
}

} // namespace

class GradedFieldTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void FieldsAreThoseThatEdgesLiftedOneByOneEndAt_data();
    void FieldsAreThoseThatEdgesLiftedOneByOneEndAt();
};

void GradedFieldTest::FieldsAreThoseThatEdgesLiftedOneByOneEndAt_data() {
    QTest::addColumn<int>("points");
    for (const int points : {2, 5, 9, 12, 13, 14, 300, 6000}) // few have fewer neighbours than there are lanes
        QTest::addRow("%d points", points) << points;
}

/// To the bit, at any number of threads.
void GradedFieldTest::FieldsAreThoseThatEdgesLiftedOneByOneEndAt() {
    QFETCH(int, points);
    base::Random random(test::seed() + static_cast<std::uint64_t>(points));
    const surfel::SurfelList list = shapes::unevenSphere(static_cast<std::size_t>(points), random);
    const Cloud cloud(list.items);
    const NeighbourGraph graph(neighboursOf(cloud, 0, {}).table, cloud.positions());
    const std::vector<float> wanted = someRadii(cloud.size(), random);
    const std::vector<float> above = plainlyRaised(wanted, graph);
    const std::vector<float> below = negative(plainlyRaised(negative(wanted), graph));
    std::vector<float> mean(wanted.size());
    for (std::size_t i = 0; i < mean.size(); ++i)
        mean[i] = 0.5f * (above[i] + below[i]);
    const QString where = QString("seed %1").arg(test::seed());
    for (const int threads : {1, 0}) {
        base::setThreadCount(threads);
        std::vector<float> raised = wanted, graded = wanted;
        raise(raised, graph, slope, {});
        grade(graded, graph, slope, {});
        QVERIFY2(raised == above, qPrintable(where));
        QVERIFY2(graded == mean, qPrintable(where));
    }
    base::setThreadCount(0);
}

static const test::Registered<GradedFieldTest> registered;
#include "graded_field_test.moc"
