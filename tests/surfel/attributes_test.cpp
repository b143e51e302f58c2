#include "core/surfel/attributes.h"

#include "core/surfel/surfel.h"
#include "support/registry.h"

#include <cmath>
#include <limits>
#include <QTest>

using namespace surfel;

class AttributesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void wordsFollowTheTypes();
    void valuesComeBackExactly();
    void valuesAreRoundedAndClamped();
    void namesListWhatHasMeaning();
    void layoutsCompareByContent();
    void listKeepsExtraWordsPerSurfel();
};

void AttributesTest::wordsFollowTheTypes() {
    AttributeLayout layout;
    QCOMPARE(layout.add("scan", ScalarType::UInt8), std::size_t(0));
    QCOMPARE(layout.add("time", ScalarType::Float64), std::size_t(1));
    QCOMPARE(layout.add("quality", ScalarType::Float32), std::size_t(2));
    QCOMPARE(layout.words(), std::size_t(4));
    QCOMPARE(layout.find("scan")->firstWord, std::size_t(0));
    QCOMPARE(layout.find("time")->firstWord, std::size_t(1));
    QCOMPARE(layout.find("quality")->firstWord, std::size_t(3));
    QVERIFY(layout.find("nothing") == nullptr);
    QVERIFY(isReal(ScalarType::Float32) && isReal(ScalarType::Float64) && !isReal(ScalarType::UInt32));
}

static double roundTrip(ScalarType type, double value) {
    AttributeLayout layout;
    layout.add("before", ScalarType::UInt32);
    layout.add("value", type);
    layout.add("after", ScalarType::UInt32);
    std::vector<std::uint32_t> words(layout.words(), 0xa5a5a5a5u);
    write(*layout.find("value"), words, value);
    if (words.front() != 0xa5a5a5a5u || words.back() != 0xa5a5a5a5u)
        return std::numeric_limits<double>::quiet_NaN(); // wrote into a neighbour
    return read(*layout.find("value"), words);
}

void AttributesTest::valuesComeBackExactly() {
    const std::pair<ScalarType, std::vector<double>> cases[] = {
        {ScalarType::Int8, {-128, -1, 0, 127}},
        {ScalarType::UInt8, {0, 1, 255}},
        {ScalarType::Int16, {-32768, -5, 32767}},
        {ScalarType::UInt16, {0, 65535}},
        {ScalarType::Int32, {-2147483648.0, -7, 2147483647.0}},
        {ScalarType::UInt32, {0, 4294967295.0}},
        {ScalarType::Float32, {0, -1.5, static_cast<double>(0.1f), 1e30f, std::numeric_limits<double>::infinity()}},
        {ScalarType::Float64, {0, 0.1, -1e300, 5e-324, -std::numeric_limits<double>::infinity()}},
    };
    for (const auto& [type, values] : cases)
        for (const double value : values)
            QVERIFY2(roundTrip(type, value) == value, qPrintable(QString::number(value)));
    QVERIFY(std::isnan(roundTrip(ScalarType::Float64, std::nan(""))));
}

void AttributesTest::valuesAreRoundedAndClamped() {
    QCOMPARE(roundTrip(ScalarType::UInt8, 300), 255.0);
    QCOMPARE(roundTrip(ScalarType::UInt8, -3), 0.0);
    QCOMPARE(roundTrip(ScalarType::UInt8, 6.6), 7.0);
    QCOMPARE(roundTrip(ScalarType::Int8, -200), -128.0);
    QCOMPARE(roundTrip(ScalarType::Int16, 1e9), 32767.0);
    QCOMPARE(roundTrip(ScalarType::UInt32, 1e30), 4294967295.0);
    QCOMPARE(roundTrip(ScalarType::Int32, -1e30), -2147483648.0);
    QCOMPARE(roundTrip(ScalarType::Int32, std::nan("")), 0.0);
    QCOMPARE(roundTrip(ScalarType::Float32, 0.1), static_cast<double>(0.1f));
}

void AttributesTest::namesListWhatHasMeaning() {
    AttributeLayout layout;
    QCOMPARE(layout.names(), std::vector<std::string>{"position"});
    layout.normals = layout.colours = layout.masks = true;
    layout.add("intensity", ScalarType::Float32);
    QCOMPARE(layout.names(), (std::vector<std::string>{"position", "normal", "colour", "mask", "intensity"}));
}

void AttributesTest::layoutsCompareByContent() {
    AttributeLayout a, b;
    a.add("x", ScalarType::Int8);
    QVERIFY(!(a == b));
    b.add("x", ScalarType::Int8);
    QVERIFY(a == b);
    b.oriented = true;
    QVERIFY(!(a == b));
    QVERIFY(*AttributeLayout::none() == AttributeLayout());
    QVERIFY(AttributeLayout::none() == AttributeLayout::none());
}

void AttributesTest::listKeepsExtraWordsPerSurfel() {
    auto layout = std::make_shared<AttributeLayout>();
    layout->add("time", ScalarType::Float64);
    SurfelList list;
    list.layout = layout;
    for (std::uint32_t i = 0; i < 10; ++i) {
        const std::uint32_t words[] = {i, 100 + i};
        list.append({}, words);
    }
    QCOMPARE(list.size(), std::size_t(10));
    QCOMPARE(list.extraOf(7).size(), std::size_t(2));
    QCOMPARE(list.extraOf(7)[0], 7u);
    QCOMPARE(list.extraOf(7)[1], 107u);
    QCOMPARE(rgba(1, 2, 3, 4), 0x04030201u);
}

static const test::Registered<AttributesTest> registered;
#include "attributes_test.moc"
