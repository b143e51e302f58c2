// Every option of a surface definition, whatever its kind: through a session line and through the words of PLY comments
// it comes back the same; what is out of range is refused by name.
#include "core/base/random.h"
#include "core/session/surface_options.h"
#include "core/surface/definition_text.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using surface::DefinitionOption;
using surface::SurfaceDefinition;

class DefinitionOptionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyRowSurvivesSessionLineAndWords();
    void everyRowRefusesWhatIsBeyondItsEnds();
    void exclusiveOptionsAreRefusedTogether();
    void aRowIsAParameterOfEveryCommandWithASurface();
};

/// A float of the range, its exponent drawn evenly where the range has no end to speak of.
static json numberOf(const surface::DefinitionRange& range, base::Random& random) {
    const double value =
        range.max < 1e6 ? random.uniform(range.min, range.max) : std::pow(10.0, random.uniform(-30, 30));
    return std::clamp(static_cast<float>(value), static_cast<float>(range.min), static_cast<float>(range.max));
}

/// Values that the option takes, as session lines hold them: all choices, both ends, some within.
static std::vector<json> valuesOf(const DefinitionOption& option, base::Random& random) {
    std::vector<json> out;
    std::istringstream choices(surface::choicesOf(option));
    for (std::string choice; choices >> choice;)
        out.push_back(choice);
    if (std::holds_alternative<bool SurfaceDefinition::*>(option.field))
        out.insert(out.end(), {true, false, "on", "off"});
    if (!(option.range.max > option.range.min))
        return out;
    const bool whole = std::holds_alternative<int SurfaceDefinition::*>(option.field);
    out.push_back(option.range.min);
    out.push_back(std::isfinite(option.range.max) ? json(option.range.max) : json("inf"));
    for (int k = 0; k < 100; ++k)
        out.push_back(numberOf(option.range, random));
    if (whole)
        for (json& value : out)
            value = static_cast<int>(value.get<double>());
    return out;
}

/// As words of PLY comments have it.
static std::string wordOf(const json& value) {
    return value.is_boolean() ? value ? "on" : "off" : value.is_string() ? value.get<std::string>() : value.dump();
}

static bool isParameter(const DefinitionOption& option) {
    return option.chosenBy == surface::ChosenBy::Person;
}

void DefinitionOptionsTest::everyRowSurvivesSessionLineAndWords() {
    base::Random random(test::seed());
    for (const DefinitionOption& option : surface::definitionOptionTable())
        for (const json& value : valuesOf(option, random)) {
            SurfaceDefinition set;
            if (isParameter(option))
                set = session::changed({}, session::complete({{"op", "surface"}, {option.id, value}})).definition;
            else
                surface::setText(option, set, wordOf(value));
            const std::string told = std::string(option.id) + " " + value.dump() + ", seed " +
                                     std::to_string(test::seed()) + ": " + surface::toWords(set);
            QVERIFY2(surface::definitionFromWords(surface::toWords(set)) == set, told.c_str());
            const std::string word = surface::textOf(option, set);
            if (value.is_number())
                QVERIFY2(json::parse(word).get<float>() == value.get<float>(), told.c_str());
            else
                QVERIFY2(word == wordOf(value), told.c_str());
        }
}

static std::string refusal(const DefinitionOption& option, const json& value) {
    try {
        if (isParameter(option))
            session::complete({{"op", "surface"}, {option.id, value}});
        else {
            SurfaceDefinition definition;
            surface::setText(option, definition, value.dump());
        }
    } catch (const base::Error& error) {
        return error.message();
    }
    return {};
}

void DefinitionOptionsTest::everyRowRefusesWhatIsBeyondItsEnds() {
    for (const DefinitionOption& option : surface::definitionOptionTable()) {
        std::vector<json> wrong{"perhaps", json::array()};
        if (option.range.max > option.range.min)
            wrong.insert(
                wrong.end(),
                {option.range.min == 0 ? -1 : 0.9 * option.range.min - 1e-3,
                 option.range.max >= surface::DefinitionRange::largest ? json("nan") : json(1.1 * option.range.max)});
        for (const json& value : wrong) {
            const std::string message = refusal(option, value);
            QVERIFY2(message.find(option.id) != std::string::npos,
                     (std::string(option.id) + " " + value.dump() + ": " + message).c_str());
        }
    }
}

void DefinitionOptionsTest::exclusiveOptionsAreRefusedTogether() {
    int pairs = 0;
    for (const DefinitionOption& option : surface::definitionOptionTable())
        if (option.excludes) {
            const DefinitionOption& other = surface::definitionOption(option.excludes);
            const json both = session::complete({{"op", "surface"}, {option.id, 20}, {other.id, 20}});
            QVERIFY_EXCEPTION_THROWN(session::changed({}, both), base::Error);
            ++pairs;
        }
    QVERIFY(pairs > 0);
}

void DefinitionOptionsTest::aRowIsAParameterOfEveryCommandWithASurface() {
    for (const char* op : {"open", "new", "surface"})
        for (const DefinitionOption& option : surface::definitionOptionTable()) {
            const auto parameters = session::command(op).parameters;
            const auto found = std::count_if(parameters.begin(), parameters.end(),
                                             [&](const auto& p) { return p.id == std::string_view(option.id); });
            QCOMPARE(found, isParameter(option) ? 1 : 0);
        }
}

static const test::Registered<DefinitionOptionsTest> registered;
#include "definition_options_test.moc"
