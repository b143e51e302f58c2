#include "core/base/near_word.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <QTest>

using namespace base;

class NearWordTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void oneSlipIsFound();
    void whatIsFarIsNotSuggested();
    void theNearestOfManyWins();
    void randomSlipsAreUndone();
    void sentencesBeginWithTheSuggestion();
};

static const std::string tools = "draw, draw-sharp, clay, clay-strips, inflate, smooth, pinch, elastic-grab";

void NearWordTest::oneSlipIsFound() {
    for (const char* word : {"drwa", "darw", "drw", "drawn", "drow", "Draw", "DRAW"})
        QCOMPARE(nearWord(word, tools), std::string("draw"));
    QCOMPARE(nearWord("elastic_grab", tools), std::string("elastic-grab"));
    QCOMPARE(nearWord("smo", tools), std::string("smooth")); // it goes on
    QCOMPARE(nearWord("interesct", "info convert intersect"), std::string("intersect"));
}

void NearWordTest::whatIsFarIsNotSuggested() {
    for (const char* word : {"", "x", "paint", "wxyz", "dr", "clean", "ab"})
        QVERIFY2(nearWord(word, tools).empty(), word);
    QVERIFY(nearWord("draw", "").empty() && nearWord("w", "x, y, z").empty());
    QVERIFY(nearWord(std::string(100000, 'd'), tools).empty());
}

void NearWordTest::theNearestOfManyWins() {
    QCOMPARE(nearWord("clay-strip", tools), std::string("clay-strips"));
    QCOMPARE(nearWord("clai", tools), std::string("clay"));
    QCOMPARE(nearWord("bat", "cat bar"), std::string("cat")); // the first of equals
}

/// A word of six letters or more forgives two slips.
void NearWordTest::randomSlipsAreUndone() {
    Random random(test::seed());
    for (int round = 0; round < 300; ++round) {
        std::string word(6 + random.below(8), ' '), known;
        for (char& c : word)
            c = static_cast<char>('a' + random.below(26));
        for (int k = 0; k < 5; ++k)
            known += std::string(20, static_cast<char>('A' + k)) + ", ";
        known += word;
        std::string typed = word;
        for (int slip = 0; slip < 2; ++slip) {
            const std::size_t at = random.below(typed.size());
            switch (random.below(3)) {
            case 0:
                typed.erase(at, 1);
                break;
            case 1:
                typed.insert(at, 1, '-');
                break;
            default:
                typed[at] = '_';
            }
        }
        if (typed.size() >= 6)
            QVERIFY2(nearWord(typed, known) == word,
                     qPrintable(QString("%1 for %2, seed %3").arg(typed.c_str(), word.c_str()).arg(test::seed())));
    }
}

void NearWordTest::sentencesBeginWithTheSuggestion() {
    QCOMPARE(didYouMean("drwa", tools), std::string("did you mean 'draw'?"));
    QCOMPARE(didYouMeanOr("drwa", tools, "choose one"), std::string("did you mean 'draw'? choose one"));
    QCOMPARE(didYouMeanOr("wxyz", tools, "choose one"), std::string("choose one"));
    QCOMPARE(didYouMeanOr("drwa", tools, ""), std::string("did you mean 'draw'?"));
}

static const test::Registered<NearWordTest> registered;
#include "near_word_test.moc"
