// Subcommands that are one command of a session: what it does, and nothing beside it.
#include "core/session/command.h"
#include "program.h"
#include "support/registry.h"

#include <QTest>

using test::json;
using test::Outcome;
using test::Program;

class ModelCommandsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void theyDoWhatTheCommandDoes_data();
    void theyDoWhatTheCommandDoes();
    void listsThatAreNoneAreWrongUsage();
    void helpWritesListsAsAShellDoes();
};

void ModelCommandsTest::theyDoWhatTheCommandDoes_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("line");
    QTest::newRow("rectangle") << QStringList{"trim",   "--eye",   "0,0,9",       "--target",       "0,0,0",
                                              "--size", "800,600", "--rectangle", "350,250,420,330"}
                               << R"({"op":"trim","eye":[0,0,9],"target":[0,0,0],"size":[800,600],
                                      "rectangle":[350,250,420,330]})";
    QTest::newRow("lasso") << QStringList{"trim",     "--eye",     "0,0,9",
                                          "--target", "0,0,0",     "--size",
                                          "800,600",  "--polygon", "300,200 420,210 380,390",
                                          "--keep",   "inside"}
                           << R"({"op":"trim","eye":[0,0,9],"target":[0,0,0],"size":[800,600],
                                  "polygon":[[300,200],[420,210],[380,390]],"keep":"inside"})";
    QTest::newRow("tube") << QStringList{"tube", "--along", "0.9,0,-0.4 1.5,0,0 0.9,0,0.4", "--radius", "0.1"}
                          << R"({"op":"tube","along":[[0.9,0,-0.4],[1.5,0,0],[0.9,0,0.4]],"radius":0.1})";
    QTest::newRow("merge") << QStringList{"merge"} << R"({"op":"merge"})";
}

void ModelCommandsTest::theyDoWhatTheCommandDoes() {
    QFETCH(QStringList, arguments);
    QFETCH(QString, line);
    const Program program;
    program.write("s.jsonl", "{\"op\":\"new\",\"sample\":\"sphere\",\"count\":3000}\n" +
                                 json::parse(line.toStdString()).dump() + "\n");
    const Outcome one = program.run({"run", "s.jsonl", "-o", "a.ply"});
    QVERIFY2(one.code == 0, one.err.c_str());
    arguments.insert(1, "sample:sphere:3000");
    arguments += {"-o", "b.ply"};
    const Outcome other = program.run(arguments);
    QVERIFY2(other.code == 0, other.err.c_str());
    QVERIFY(program.hash("a.ply") == program.hash("b.ply"));
}

void ModelCommandsTest::listsThatAreNoneAreWrongUsage() {
    const Program program;
    const Outcome text = program.run({"tube", "sample:sphere:500", "-o", "o.ply", "--radius", "1", "--along", "here"});
    QCOMPARE(text.code, 2);
    QVERIFY2(text.err.find("--along") != std::string::npos, text.err.c_str());
    QCOMPARE(program.run({"tube", "sample:sphere:500", "-o", "o.ply", "--radius", "1"}).code, 2);
    QCOMPARE(program.run({"trim", "sample:sphere:500", "-o", "o.ply", "--eye", "0,0,9"}).code, 2);
}

void ModelCommandsTest::helpWritesListsAsAShellDoes() {
    const Program program;
    const std::string trim = program.run({"trim", "--help"}).out, tube = program.run({"tube", "--help"}).out;
    for (const char* words : {"--eye x,y,z REQUIRED", "--polygon 'x,y x,y ...'", "--rectangle x0,y0,x1,y1",
                              "a lasso: what it goes round", " place that the camera looks at"})
        QVERIFY2(trim.find(words) != std::string::npos, (words + ("\n" + trim)).c_str());
    QVERIFY2(tube.find("--along 'x,y,z x,y,z ...' REQUIRED") != std::string::npos, tube.c_str());
    QVERIFY(trim.find("[x,y") == std::string::npos && tube.find("[x,y") == std::string::npos);
}

static const test::Registered<ModelCommandsTest> registered;
#include "model_commands_test.moc"
