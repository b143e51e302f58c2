// Order statistics against sorting: random numbers of which many are equal, none, one.
#include "core/base/ranked.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

#include <span>
#include <vector>

class RankedTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theyAreWhatSortingBrings();
    void theAnswerPartsTheOthers();
    void ofNoneItIsNothing();
};

static std::vector<double> someNumbers(base::Random& random) {
    std::vector<double> out;
    const std::size_t n = 1 + random.below(90), different = 1 + random.below(60);
    for (std::size_t i = 0; i < n; ++i)
        out.push_back(static_cast<double>(random.below(different)) - 20);
    return out;
}

void RankedTest::theyAreWhatSortingBrings() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(500); ++round) {
        const std::vector<double> numbers = someNumbers(random);
        std::vector<double> up = numbers, down = numbers, given = numbers;
        std::ranges::sort(up);
        std::ranges::sort(down, std::greater<>());
        const std::size_t rank = random.below(numbers.size() + 3), kept = std::min(rank, numbers.size() - 1);
        const std::string where = "round " + std::to_string(round) + ", seed " + std::to_string(test::seed()) +
                                  ", rank " + std::to_string(rank);
        QVERIFY2(base::ranked(given, rank) == up[kept], where.c_str());
        QVERIFY2(base::ranked(given, rank, std::greater<>()) == down[kept], where.c_str());
        QVERIFY2(base::median(std::span(given)) == up[numbers.size() / 2], where.c_str());
        QVERIFY2(base::quantile(given, 0) == up.front() && base::quantile(given, 1) == up.back(), where.c_str());
        const double share = random.uniform();
        const double found = base::quantile(given, share);
        const auto below = std::ranges::count_if(numbers, [&](double v) { return v < found; });
        const auto notAbove = std::ranges::count_if(numbers, [&](double v) { return v <= found; });
        const double place = share * static_cast<double>(numbers.size() - 1);
        QVERIFY2(static_cast<double>(below) <= place && place < static_cast<double>(notAbove), where.c_str());
    }
}

void RankedTest::theAnswerPartsTheOthers() {
    base::Random random(test::seed() + 1);
    for (int round = 0; round < test::effort(100); ++round) {
        std::vector<double> numbers = someNumbers(random);
        const std::size_t rank = random.below(numbers.size());
        const double found = base::ranked(numbers, rank);
        QCOMPARE(numbers[rank], found);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            QVERIFY(i < rank ? numbers[i] <= found : numbers[i] >= found);
    }
}

void RankedTest::ofNoneItIsNothing() {
    std::vector<float> none;
    QCOMPARE(base::ranked(none, 3), 0.0F);
    QCOMPARE(base::median(none), 0.0F);
    QCOMPARE(base::quantile(none, 0.5), 0.0F);
}

static const test::Registered<RankedTest> registered;
#include "ranked_test.moc"
