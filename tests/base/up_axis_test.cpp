#include "core/base/up_axis.h"

#include "core/base/row_of_id.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using namespace base;

class UpAxisTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void framesAreRightHandedQuarterTurns();
    void theOrderGoesRoundThroughAll();
};

void UpAxisTest::framesAreRightHandedQuarterTurns() {
    const Vec3d odd{0.1, -2.7, 1e-9};
    for (const UpRow& row : upTable()) {
        QVERIFY2(&upRow(row.axis) == &row && findRow(upTable(), row.id) == &row, row.id);
        QCOMPARE(cross(row.right, row.up), row.front);
        QCOMPARE(lengthSq(row.right) * lengthSq(row.up), 1.0);
        QCOMPARE(fromStanding(row.axis, {0, 1, 0}), row.up);
        QCOMPARE(toStanding(row.axis, fromStanding(row.axis, odd)), odd); // no bit is lost
        const std::string_view id = row.id;
        QCOMPARE(row.up[std::size_t(id.back() - 'x')], id.starts_with('-') ? -1.0 : 1.0);
    }
    QCOMPARE(fromStanding(UpAxis::Y, odd), odd);
}

void UpAxisTest::theOrderGoesRoundThroughAll() {
    std::set<UpAxis> seen;
    UpAxis at = UpAxis::Y;
    for (; seen.insert(at).second; at = nextUp(at)) {
    }
    QCOMPARE(seen.size(), upTable().size());
    QVERIFY(at == UpAxis::Y && nextUp(at) == UpAxis::Z);
}

static const test::Registered<UpAxisTest> registered;
#include "up_axis_test.moc"
