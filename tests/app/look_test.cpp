// render's options of looks: every row of the tables, and what is no use together.
#include "core/render/shading/shading_table.h"
#include "program.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using test::Outcome;
using test::Program;

class LookTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyShadingIsListedAndDrawn();
    void aRangeChangesThePicture();
    void modelsWithColoursAreShownInThem();
    void whatDoesNotGoTogetherIsWrongUsage();
};

void LookTest::everyShadingIsListedAndDrawn() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    const Program program;
    const std::string help = program.run({"render", "--help"}).out;
    std::string values = "ply\nformat ascii 1.0\nelement vertex 400\nproperty float x\nproperty float y\n"
                         "property float z\nproperty float heat\nend_header\n";
    for (int i = 0; i < 400; ++i)
        values += std::to_string(i % 20) + " " + std::to_string(i / 20) + " 0 " + std::to_string(i) + "\n";
    program.write("values.ply", values);
    for (const render::ShadingRow& row : render::shadingTable()) {
        const char* id = row.id;
        QVERIFY2(help.find(std::string(id) + ":") != std::string::npos, id);
        QStringList arguments{"render", "sample:torus:2000", "-o", "a.png", "--size", "64x48", "--shading", id};
        if (std::string(id) == "deviation")
            arguments << "--reference"
                      << "sample:torus:2500";
        if (std::string(id) == "attribute")
            arguments[1] = "values.ply", arguments << "--attribute"
                                                   << "heat";
        for (const char* mode : {"splats", "raycast"}) {
            const Outcome outcome = program.run(arguments + QStringList{"--mode", mode});
            QVERIFY2(outcome.code == 0, outcome.err.c_str());
        }
    }
}

void LookTest::aRangeChangesThePicture() {
    const Program program;
    const auto picture = [&](const char* range) {
        const Outcome outcome = program.run({"render", "sample:sphere:2000", "-o", "a.png", "--size", "64x48",
                                             "--shading", "curvature", QString("--range=") + range});
        return outcome.code == 0 ? program.read("a.png") : outcome.err;
    };
    QVERIFY(picture("-2,2") != picture("-200,200"));
    QVERIFY(picture("-2,2") == picture("-2,2"));
}

void LookTest::modelsWithColoursAreShownInThem() {
    const Program program;
    const auto write = [&](const char* name, bool same) {
        std::string text = "# x y z red green blue\n";
        for (int i = 0; i < 30; ++i)
            for (int k = 0; k < 30; ++k)
                text += std::to_string(i) + " " + std::to_string(k) + " 0 " +
                        (same     ? "0 0 0"
                         : i < 15 ? "250 0 0"
                                  : "0 0 250") +
                        "\n";
        program.write(name, text);
    };
    write("coloured.txt", false);
    write("black.txt", true);
    const auto picture = [&](const char* model, const QStringList& options) {
        const QStringList arguments{"render", model, "-o", "a.png", "--size", "64x48"};
        return program.run(arguments + options).code == 0 ? program.read("a.png") : std::string();
    };
    QVERIFY(!picture("coloured.txt", {}).empty());
    QVERIFY(picture("coloured.txt", {}) == picture("coloured.txt", {"--shading", "colour"}));
    QVERIFY(picture("black.txt", {}) == picture("black.txt", {"--shading", "matcap"}));
    QVERIFY(!picture("coloured.txt", {"--mode", "raycast", "--material", "clay"}).empty());
}

void LookTest::whatDoesNotGoTogetherIsWrongUsage() {
    const Program program;
    const QList<QStringList> wrong{
        {"--range=-1,1"},           {"--shading", "curvature", "--range=1,1"}, {"--shading", "curvature", "--range=1"},
        {"--shading", "deviation"}, {"--reference", "sample:torus:500"},       {"--background", "plaid"}};
    for (const auto& options : wrong) {
        const Outcome outcome = program.run(QStringList{"render", "sample:sphere:500", "-o", "a.png"} + options);
        QVERIFY2(outcome.code == 2 && !outcome.err.empty(), qPrintable(options.front()));
    }
}

static const test::Registered<LookTest> registered;
#include "look_test.moc"
