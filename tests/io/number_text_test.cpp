#include "core/io/number_text.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <cmath>

class NumberTextTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void printedNumbersReadBackToTheSameBits();
    void knownSpellingsAreUnderstood_data();
    void knownSpellingsAreUnderstood();
    void otherThingsAreNoNumbers();
    void parsingStopsBehindTheNumber();
};

void NumberTextTest::printedNumbersReadBackToTheSameBits() {
    base::Random random(test::seed());
    for (int round = 0; round < 20000; ++round) {
        const auto whole = std::bit_cast<double>(random.next());
        const auto half = std::bit_cast<float>(static_cast<std::uint32_t>(random.next()));
        if (!std::isfinite(whole) || !std::isfinite(half))
            continue;
        std::string a, b;
        io::appendNumber(a, whole);
        io::appendNumber(b, half);
        QCOMPARE(std::bit_cast<std::uint64_t>(*io::numberOf(a)), std::bit_cast<std::uint64_t>(whole));
        QVERIFY2(test::sameBits(static_cast<float>(*io::numberOf(b)), half), b.c_str());
    }
}

void NumberTextTest::knownSpellingsAreUnderstood_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("value");
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const auto row = [](const QByteArray& text, double value) {
        QTest::newRow(text.left(20).constData()) << text << value;
    };
    row("1.5", 1.5);
    row("+2", 2);
    row("-.5e-1", -0.05);
    row("1.", 1);
    row("1E5", 1e5);
    row("inf", inf);
    row("+INF", inf);
    row("-Infinity", -inf);
    row("NaN", nan);
    row("1e400", inf);
    row("-1e400", -inf);
    row("1e-400", 0);
    row("1.#INF", inf);
    row("-1.#INF00", -inf);
    row("1.#QNAN", nan);
    row("-1.#IND000", nan);
    row(QByteArray(400, '7'), inf);
    row("0." + QByteArray(400, '0') + "1", 0);
    row("3." + QByteArray(100, '3'), 10.0 / 3);
    row(QByteArray(100, '0') + "12", 12);
}

void NumberTextTest::knownSpellingsAreUnderstood() {
    QFETCH(QByteArray, text);
    QFETCH(double, value);
    const auto found = io::numberOf({text.constData(), static_cast<std::size_t>(text.size())});
    QVERIFY(found.has_value());
    QVERIFY(std::isnan(value) ? std::isnan(*found) : *found == value);
}

void NumberTextTest::otherThingsAreNoNumbers() {
    for (const char* text : {"", "+", "-", "+-1", "x", "1,5", "1 ", " 1", "0x10", "1e", "--1", "ply"})
        QVERIFY2(!io::numberOf(text).has_value(), text);
    for (const char* text : {"", "-1", "+1", "1.0", "18446744073709551616", "99999999999999999999999", "7 "})
        QVERIFY2(!io::countOf(text).has_value(), text);
    QCOMPARE(*io::countOf("18446744073709551615"), ~std::uint64_t(0));
}

void NumberTextTest::parsingStopsBehindTheNumber() {
    const std::string text = "12.5abc";
    double value = 0;
    QCOMPARE(io::parseNumber(text.data(), text.data() + text.size(), value), text.data() + 4);
    QCOMPARE(value, 12.5);
    QCOMPARE(io::parseNumber(text.data(), text.data() + 2, value), text.data() + 2); // not a byte further
    QCOMPARE(value, 12.0);
}

static const test::Registered<NumberTextTest> registered;
#include "number_text_test.moc"
