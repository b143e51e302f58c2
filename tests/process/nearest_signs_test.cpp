#include "core/process/estimation/orientation/nearest_signs.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

class NearestSignsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void signsThatMadeItAreFound();
    void noSingleTurnComesNearer();
    void threadsDoNotShow();
    void itEndsWhenCancelled();
};

using Numbers = std::vector<double>;

static Numbers randomNumbers(base::Random& random, std::size_t count, double most) {
    Numbers out(count);
    for (double& each : out)
        each = random.uniform(-most, most);
    return out;
}

/// b += A s, or what is missing to it.
static void add(const Numbers& a, const Numbers& signs, double factor, Numbers& b) {
    for (std::size_t k = 0; k < signs.size(); ++k)
        for (std::size_t i = 0; i < b.size(); ++i)
            b[i] += factor * signs[k] * a[k * b.size() + i];
}

static double missed(const Numbers& a, const Numbers& signs, Numbers b) {
    add(a, signs, -1, b);
    double sum = 0;
    for (const double each : b)
        sum += each * each;
    return sum;
}

void NearestSignsTest::signsThatMadeItAreFound() {
    base::Random random(test::seed());
    for (const std::size_t count : {1, 2, 95, 96, 97, 250}) {
        const Numbers a = randomNumbers(random, 2 * count * count, 1);
        Numbers signs(count), b = randomNumbers(random, 2 * count, 0.1);
        for (double& each : signs)
            each = random.uniform() < 0.5 ? -1 : 1;
        add(a, signs, 1, b);
        QVERIFY2(process::nearestSigns(a, b) == signs,
                 qPrintable(QString("%1 signs, seed %2").arg(count).arg(test::seed())));
    }
}

void NearestSignsTest::noSingleTurnComesNearer() {
    base::Random random(test::seed());
    const Numbers a = randomNumbers(random, std::size_t(100) * 200, 1); // fewer rows than columns: singular
    const Numbers b = randomNumbers(random, 100, 10);
    Numbers signs = process::nearestSigns(a, b);
    const double least = missed(a, signs, b);
    for (double& each : signs) {
        each = -each;
        QVERIFY2(missed(a, signs, b) > least * (1 - 1e-9), qPrintable(QString("seed %1").arg(test::seed())));
        each = -each;
    }
}

void NearestSignsTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const Numbers a = randomNumbers(random, std::size_t(300) * 300, 1), b = randomNumbers(random, 300, 10);
    const int threads = base::threadCount();
    base::setThreadCount(1);
    const Numbers one = process::nearestSigns(a, b);
    base::setThreadCount(threads);
    QVERIFY(process::nearestSigns(a, b) == one);
}

void NearestSignsTest::itEndsWhenCancelled() {
    base::Random random(test::seed());
    const Numbers a = randomNumbers(random, std::size_t(300) * 300, 1), b = randomNumbers(random, 300, 10);
    const std::atomic<bool> cancel = true;
    const base::CancelScope scope(&cancel);
    QVERIFY_THROWS_EXCEPTION(base::Cancelled, process::nearestSigns(a, b));
}

static const test::Registered<NearestSignsTest> registered;
#include "nearest_signs_test.moc"
