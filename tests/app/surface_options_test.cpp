// Every option of a surface definition on the command line: what is given there is what the definition has.
#include "app/options/surface_options.h"

#include "core/base/random.h"
#include "core/session/surface_options.h"
#include "support/registry.h"

#include <algorithm>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <QTest>
#include <sstream>

using surface::DefinitionOption;
using surface::SurfaceDefinition;

class SurfaceOptionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyRowIsTakenAsItIsWritten();
    void everyRowRefusesWhatIsOutside();
    void whatExcludesIsRefused();
};

/// A word that the option takes: a choice, or a number in its range.
static std::string wordOf(const DefinitionOption& option, base::Random& random) {
    if (std::holds_alternative<bool SurfaceDefinition::*>(option.field))
        return random.below(2) ? "on" : "off";
    std::vector<std::string> words;
    std::istringstream choices(surface::choicesOf(option));
    for (std::string choice; choices >> choice;)
        words.push_back(choice);
    if (option.range.max > option.range.min) {
        const auto value = static_cast<float>(random.uniform(option.range.min, std::min(option.range.max, 1e3)));
        words.push_back(std::holds_alternative<int SurfaceDefinition::*>(option.field)
                            ? std::to_string(3 + random.below(9998))
                            : QString::number(value, 'g', 9).toStdString());
    }
    return words[random.below(words.size())];
}

/// The definition that these arguments ask for; throws what the command line says against them.
static SurfaceDefinition parsed(std::vector<std::string> arguments) {
    CLI::App command;
    const auto options = app::addSurfaceOptions(command, false);
    std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
    command.parse(arguments);
    nlohmann::json line = options->parameters();
    line["op"] = "surface";
    return session::changed({}, session::complete(line)).definition;
}

void SurfaceOptionsTest::everyRowIsTakenAsItIsWritten() {
    base::Random random(test::seed());
    for (const DefinitionOption& option : surface::definitionOptionTable())
        for (int k = 0; k < (option.chosenBy == surface::ChosenBy::Person ? 50 : 0); ++k) {
            const std::string word = wordOf(option, random), name = std::string("--") + option.id;
            SurfaceDefinition wanted;
            surface::setText(option, wanted, word);
            const SurfaceDefinition found = parsed({name, word});
            const std::string told = name + " " + word + ", seed " + std::to_string(test::seed());
            QVERIFY2(found == wanted, told.c_str());
            QVERIFY2(parsed({name, surface::textOf(option, found)}) == found, told.c_str());
        }
}

void SurfaceOptionsTest::everyRowRefusesWhatIsOutside() {
    for (const DefinitionOption& option : surface::definitionOptionTable()) {
        const std::string name = std::string("--") + option.id;
        try {
            parsed({name + "=-1"});
            QVERIFY2(false, name.c_str());
        } catch (const CLI::ParseError& error) {
            QVERIFY2(std::string(error.what()).find(option.id) != std::string::npos, error.what());
        }
    }
}

void SurfaceOptionsTest::whatExcludesIsRefused() {
    for (const DefinitionOption& option : surface::definitionOptionTable())
        if (option.excludes)
            QVERIFY_EXCEPTION_THROWN(
                parsed({"--" + std::string(option.id), "20", "--" + std::string(option.excludes), "20"}),
                CLI::ParseError);
}

static const test::Registered<SurfaceOptionsTest> registered;
#include "surface_options_test.moc"
