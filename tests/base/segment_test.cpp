// The nearest place of a segment: none of it is nearer, and its ends are its ends.
#include "core/base/segment.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;

class SegmentTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void nothingOfTheSegmentIsNearer();
    void withoutLengthItIsItsBeginning();
};

void SegmentTest::nothingOfTheSegmentIsNearer() {
    base::Random random(test::seed());
    for (int i = 0; i < test::effort(500); ++i) {
        const Vec3d from = random.unitVector(), to = random.unitVector(), x = random.unitVector() * 2.0;
        const Vec3d found = nearestOnSegment(from, to, x);
        const double share = nearestShare(from, to, x), line = shareAlong(from, to, x);
        QVERIFY(share == (line < 0 ? 0 : line > 1 ? 1 : line));
        for (int k = 0; k <= 50; ++k)
            QVERIFY2(base::distance(found, x) <= base::distance(from + (to - from) * (k / 50.0), x) + 1e-14,
                     qPrintable(QString("seed %1").arg(test::seed())));
    }
}

void SegmentTest::withoutLengthItIsItsBeginning() {
    const Vec3d at{1, 2, 3};
    QVERIFY(nearestOnSegment(at, at, Vec3d{5, 5, 5}) == at);
    QVERIFY(nearestShare(at, at, Vec3d{}) == 0);
}

static const test::Registered<SegmentTest> registered;
#include "segment_test.moc"
