#include "core/session/place_text.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

class PlaceTextTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void placesAreToldToAHundredth();
    void placesReadWell();
};

/// At any distance from the origin.
void PlaceTextTest::placesAreToldToAHundredth() {
    base::Random random(test::seed());
    for (int i = 0; i < 1000; ++i) {
        const double size = std::pow(10, random.uniform(-6, 4));
        const base::Vec3d place = random.unitVector() * std::pow(10, random.uniform(-6, 7));
        std::istringstream in(session::placeText(place, size));
        base::Vec3d read;
        in >> read.x >> read.y >> read.z;
        QVERIFY2(distance(read, place) <= 0.01 * size + 1e-9, session::placeText(place, size).c_str());
    }
}

void PlaceTextTest::placesReadWell() {
    QCOMPARE(session::placeText({1e6 + 0.946, 12, -3.1}, 2), std::string("1000000.95 12.00 -3.10"));
    QCOMPARE(session::placeText({4500000, -7000000, 3}, 500), std::string("4500000 -7000000 3"));
}

static const test::Registered<PlaceTextTest> registered;
#include "place_text_test.moc"
