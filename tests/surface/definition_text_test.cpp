#include "core/surface/definition_text.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/surface/definition_options.h"
#include "support/registry.h"

#include <bit>
#include <QTest>

using namespace surface;

class DefinitionTextTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void namesComeBackAsTheirValues();
    void wordsBringBackTheSameBits();
    void boundaryIsAWordOrANumber();
    void errorsNameTheKnownOnes();
    void valuesOutOfRangeAreRefused();
};

void DefinitionTextTest::namesComeBackAsTheirValues() {
    for (const auto& row : frameNames())
        QVERIFY(parseFrame(nameOf(row.value)) == row.value);
    for (const auto& row : weightNames())
        QVERIFY(parseWeight(nameOf(row.value)) == row.value);
    for (const auto& row : projectorNames())
        QVERIFY(parseProjector(nameOf(row.value)) == row.value);
    QCOMPARE(nameOf(Frame::CovarianceAtCentroid), "covariance-at-centroid");
    QCOMPARE(nameOf(Boundary::None), "none");
}

void DefinitionTextTest::wordsBringBackTheSameBits() {
    QVERIFY(definitionFromWords(toWords({})) == SurfaceDefinition{});
    QVERIFY(definitionFromWords("") == SurfaceDefinition{});
    base::Random random(test::seed());
    for (int i = 0; i < 2000; ++i) {
        SurfaceDefinition d;
        d.frame = frameNames()[random.below(4)].value;
        d.weight = weightNames()[random.below(2)].value;
        d.boundary = boundaryNames()[random.below(3)].value;
        d.support = random.below(2) ? 0 : std::bit_cast<float>(static_cast<std::uint32_t>(random.next() % 0x7f800000u));
        d.neighbours = 3 + static_cast<int>(random.below(100));
        if (d.boundary != Boundary::None)
            d.boundaryLimit = static_cast<float>(random.uniform(0.01, 2));
        d.shrinkFree = random.below(2);
        d.oneSheet = random.below(2);
        QVERIFY2(definitionFromWords(toWords(d)) == d, toWords(d).c_str());
    }
}

void DefinitionTextTest::boundaryIsAWordOrANumber() {
    SurfaceDefinition d;
    const DefinitionOption& boundary = definitionOption("boundary");
    setText(boundary, d, "0.25");
    QVERIFY(d.boundary == Boundary::Limit && d.boundaryLimit == 0.25f);
    QCOMPARE(textOf(boundary, d), std::string("0.25"));
    setText(boundary, d, "none");
    QVERIFY(d.boundary == Boundary::None && !std::isfinite(d.boundaryLimit));
    d = definitionFromWords("boundary=auto boundary-limit=0.3125");
    QVERIFY(d.boundary == Boundary::Auto && d.boundaryLimit == 0.3125f);
}

static std::string errorOf(const char* name, const char* value) {
    try {
        SurfaceDefinition d;
        setText(definitionOption(name), d, value);
    } catch (const base::Error& error) {
        return error.message();
    }
    return {};
}

void DefinitionTextTest::errorsNameTheKnownOnes() {
    QVERIFY(errorOf("frame", "normal").find("normals, hyperplanes, covariance") != std::string::npos);
    QVERIFY(errorOf("wait", "1").find("frame, weight, support") != std::string::npos);
    QVERIFY(errorOf("one-sheet", "yes").find("on, off") != std::string::npos);
    QVERIFY_EXCEPTION_THROWN(definitionFromWords("frame"), base::Error);
}

void DefinitionTextTest::valuesOutOfRangeAreRefused() {
    for (const auto& [name, value] : {std::pair{"support", "-1"},
                                      {"support", "inf"},
                                      {"support", "nan"},
                                      {"support", "1x"},
                                      {"support", ""},
                                      {"neighbours", "2"},
                                      {"neighbours", "7.5"},
                                      {"neighbours", "99999999999"},
                                      {"boundary", "0"},
                                      {"boundary", "-0.3"},
                                      {"boundary", "nan"},
                                      {"boundary", "limit"}})
        QVERIFY2(!errorOf(name, value).empty(), qPrintable(QString("%1=%2").arg(name, value)));
}

static const test::Registered<DefinitionTextTest> registered;
#include "definition_text_test.moc"
