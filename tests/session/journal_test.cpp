// The journal as a file: whose it is, what it keeps, and what goes.
#include "journals.h"
#include "support/registry.h"

#include <QDir>
#include <QTest>

using nlohmann::json;
using test::lineCount;
using test::recovered;
using test::Workbench;
namespace fs = std::filesystem;

class JournalTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void openAndNewBeginAnew();
    void twoJournalsOfOneProcessHaveTwoFiles();
    void aJournalInUseIsRefused();
    void discardLeavesNothing();
    void aDiskThatRefusesIsToldOnce();
    void theJournalGoesOnWhenTheDiskDoes();
    void whatIsNoJournalIsNeverWrittenOver();
    void aSessionThatDidNotEndIsNotWrittenOver();
    void noModelTakesTheJournalsPlace();
    void linksAreNotFollowed();
    void stampsAreKeptByTheirContent();
    void copiesStandAlone();
    void pathsThatAreNotUtf8Survive();
    void leftoversOfKilledProcessesGo();
    void leftoversOfANamedJournalGo();
    void foldersThatOthersWriteToAreRefused();
};

void JournalTest::openAndNewBeginAnew() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    bench.context.folder = bench.dir.path().toStdString();
    bench.run({{"op", "open"}, {"path", "a.ply"}, {"frame", "covariance"}});
    QCOMPARE(lineCount(journal.path()), 1);
    const json first = json::parse(test::contentOf(journal.path()));
    QCOMPARE(first.at("path").get<std::string>(), bench.path("a.ply").string());
    QCOMPARE(first.at("hash").get<std::string>(), bench.hash());
    QCOMPARE(first.at("frame").get<std::string>(), std::string("covariance"));
    QCOMPARE(recovered(journal.path()), bench.hash());
}

/// Sets the state folder for as long as it lives.
struct StateFolder {
    explicit StateFolder(const fs::path& path) { qputenv("XDG_STATE_HOME", path.c_str()); }
    ~StateFolder() { qunsetenv("XDG_STATE_HOME"); }
};

void JournalTest::twoJournalsOfOneProcessHaveTwoFiles() {
    Workbench bench;
    const StateFolder state(bench.dir.path().toStdString());
    QCOMPARE(session::stateFolder().string(), bench.path("pointclay").string());
    session::Journal one, two;
    const std::string name = "journal-" + std::to_string(QCoreApplication::applicationPid());
    QCOMPARE(one.path().string(), bench.path("pointclay/" + name + ".jsonl").string());
    QVERIFY(two.path() != one.path());
    bench.context.journal = &two;
    bench.run(test::newSphere());
    QCOMPARE(recovered(two.path()), bench.hash());
    QCOMPARE(lineCount(one.path()), 0);
}

void JournalTest::aJournalInUseIsRefused() {
    Workbench bench;
    const session::Journal journal(bench.path("j.jsonl"));
    QVERIFY_EXCEPTION_THROWN(session::Journal(bench.path("j.jsonl")), base::Error);
    QVERIFY_EXCEPTION_THROWN(session::Journal(bench.path("nowhere/j.jsonl")), base::Error);
    QVERIFY_EXCEPTION_THROWN(session::Journal("/dev/null"), base::Error);
}

void JournalTest::discardLeavesNothing() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    QVERIFY(fs::exists(journal.path()));
    journal.discard();
    bench.run(test::strokeAt(0));
    QVERIFY(QDir(bench.dir.path()).isEmpty());
}

void JournalTest::aDiskThatRefusesIsToldOnce() {
    Workbench bench;
    fs::create_directory(bench.path("gone"));
    session::Journal journal(bench.path("gone/j.jsonl"));
    bench.context.journal = &journal;
    fs::remove_all(bench.path("gone"));
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    QVERIFY(bench.document.canUndo());
    QCOMPARE(bench.context.messages.size(), std::size_t(1));
    QVERIFY(bench.context.messages[0].find("j.jsonl") != std::string::npos);
}

void JournalTest::theJournalGoesOnWhenTheDiskDoes() {
    Workbench bench;
    fs::create_directory(bench.path("there"));
    session::Journal journal(bench.path("there/j.jsonl"));
    bench.context.journal = &journal;
    for (int k = 0; k < 2; ++k) { // with a model that it could not begin with, and then with the next
        fs::rename(bench.path("there"), bench.path("away"));
        bench.run(test::newSphere(3000 + k));
        bench.run(test::strokeAt(0));
        fs::rename(bench.path("away"), bench.path("there"));
        bench.run(test::strokeAt(0.2));
        QCOMPARE(recovered(journal.path()), bench.hash());
        QCOMPARE(bench.context.messages.size(), std::size_t(2 * k + 2));
    }
}

void JournalTest::whatIsNoJournalIsNeverWrittenOver() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    test::write(bench.path("s.jsonl"), test::newSphere().dump() + "\n");
    for (const char* name : {"a.ply", "s.jsonl"}) {
        const std::string before = test::contentOf(bench.path(name));
        QVERIFY_EXCEPTION_THROWN(session::Journal(bench.path(name)), base::Error);
        QCOMPARE(test::contentOf(bench.path(name)), before);
    }
    test::write(bench.path("empty"), "");
    {
        session::Journal fresh(bench.path("empty"));
        bench.context.journal = &fresh;
        bench.run(test::newSphere());
        QCOMPARE(lineCount(fresh.path()), 1);
    }
    session::Journal again(bench.path("empty")); // one that was left
    QCOMPARE(lineCount(again.path()), 0);
    bench.context.journal = nullptr;
}

void JournalTest::aSessionThatDidNotEndIsNotWrittenOver() {
    Workbench bench;
    const fs::path file = bench.path("j.jsonl");
    const auto record = [&](bool stroke, bool end) {
        session::Journal journal(file);
        bench.context.journal = &journal;
        if (end)
            journal.end(bench.context); // of nothing: leaves nothing
        bench.run(test::newSphere());
        if (stroke)
            bench.run(test::strokeAt(0));
        if (end)
            journal.end(bench.context);
        bench.context.journal = nullptr;
    };
    record(true, true);
    QCOMPARE(recovered(file), bench.hash());
    record(false, false); // takes the place of one that ended, and holds nothing that could be lost
    record(true, false);
    const std::string before = test::contentOf(file);
    try {
        record(true, true);
        QFAIL("a session is lost");
    } catch (const base::Error& error) {
        QVERIFY2(error.message().find("did not come to its end") != std::string::npos, error.what());
        QVERIFY2(std::string(error.what()).find("pointclay recover j.jsonl") != std::string::npos, error.what());
    }
    QCOMPARE(test::contentOf(file), before);
    QCOMPARE(recovered(file), bench.hash());
}

void JournalTest::noModelTakesTheJournalsPlace() {
    Workbench bench;
    session::Journal journal(bench.path("j.ply"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    const std::string before = test::contentOf(journal.path());
    const std::string told = bench.refusal({{"op", "save"}, {"path", bench.path("./j.ply").string()}});
    QVERIFY2(told.find("is the journal of this session") != std::string::npos, told.c_str());
    QCOMPARE(test::contentOf(journal.path()), before);
}

void JournalTest::linksAreNotFollowed() {
    Workbench bench;
    const fs::path precious = test::write(bench.path("precious"), "");
    fs::create_symlink(precious, bench.path("j.jsonl"));
    QVERIFY_EXCEPTION_THROWN(session::Journal(bench.path("j.jsonl")), base::Error);
    fs::remove(bench.path("j.jsonl"));
    fs::create_symlink(precious, bench.path("j.jsonl.source.ply"));
    bench.run(test::newSphere());
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
    bench.run(test::strokeAt(0));
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}}); // keeps the source
    QCOMPARE(recovered(journal.path()), bench.hash());
    QVERIFY(test::contentOf(precious).empty());
    QVERIFY(fs::status(journal.path()).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

void JournalTest::stampsAreKeptByTheirContent() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    // White, 8 x 8, but for one pixel.
    const char* black =
        "iVBORw0KGgoAAAANSUhEUgAAAAgAAAAICAAAAADhZOFXAAAAE0lEQVR42mP4DwUMWBkMuKVQGQDO6T7Cro2t4gAAAABJRU5ErkJggg==";
    const char* grey =
        "iVBORw0KGgoAAAANSUhEUgAAAAgAAAAICAAAAADhZOFXAAAAE0lEQVR42mP4DwUMWBlRuKVQGQDdUz8cEHLtPwAAAABJRU5ErkJggg==";
    for (const char* image : {black, grey}) { // two of one name
        test::write(bench.path("stamp.png"), QByteArray::fromBase64(image).toStdString());
        json stroke = test::strokeAt(0);
        stroke["stamp"] = bench.path("stamp.png").string();
        bench.run(stroke);
    }
    fs::remove(bench.path("stamp.png"));
    QCOMPARE(recovered(journal.path()), bench.hash());
    journal.discard();
    QVERIFY(QDir(bench.dir.path()).isEmpty());
}

void JournalTest::copiesStandAlone() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
    bench.run(test::strokeAt(0));
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}}); // what it was is kept beside the journal
    const std::string lines = test::contentOf(journal.path());
    QVERIFY_EXCEPTION_THROWN(journal.copyTo(journal.path()), base::Error);
    QVERIFY_EXCEPTION_THROWN(journal.copyTo(bench.path("nowhere/copy.jsonl")), base::Error);
    QCOMPARE(test::contentOf(journal.path()), lines);
    journal.copyTo(bench.path("copy.jsonl"));
    journal.discard();
    QCOMPARE(recovered(bench.path("copy.jsonl")), bench.hash());
}

void JournalTest::pathsThatAreNotUtf8Survive() {
    Workbench bench;
    bench.run(test::newSphere());
    const fs::path odd = bench.dir.path().toStdString() + "/sk\xfclptur 100%.ply";
    bench.run({{"op", "save"}, {"path", odd.string()}});
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", odd.string()}});
    bench.run(test::strokeAt(0));
    QCOMPARE(recovered(journal.path()), bench.hash());
}

void JournalTest::leftoversOfKilledProcessesGo() {
    Workbench bench;
    const StateFolder state(bench.dir.path().toStdString());
    fs::create_directories(session::stateFolder());
    fs::permissions(session::stateFolder(), fs::perms::owner_all);
    const auto put = [](const char* name) { return test::write(session::stateFolder() / name, "x"); };
    const std::vector<fs::path> gone = {put("journal-9.jsonl.new-9-0"), put("journal-8.jsonl.source.ply"),
                                        put("journal-7.jsonl.source.ply.new-7-1")};
    const std::vector<fs::path> kept = {put("journal-7.jsonl"), put("journal-7.jsonl.source.ply"), put("notes.txt")};
    const session::Journal journal;
    for (const fs::path& each : gone)
        QVERIFY2(!fs::exists(each), each.c_str());
    for (const fs::path& each : kept)
        QVERIFY2(fs::exists(each), each.c_str());
}

void JournalTest::leftoversOfANamedJournalGo() {
    Workbench bench;
    const auto put = [&](const char* name) { return test::write(bench.path(name), "x"); };
    const std::vector<fs::path> gone = {put("a.jsonl.new-9-0"), put("a.jsonl.source.ply.new-9-1")};
    const std::vector<fs::path> kept = {put("b.jsonl.new-9-0"), put("a.jsonl.source.ply"), put("a.jsonl.newer")};
    const session::Journal journal(bench.path("a.jsonl"));
    for (const fs::path& each : gone)
        QVERIFY2(!fs::exists(each), each.c_str());
    for (const fs::path& each : kept)
        QVERIFY2(fs::exists(each), each.c_str());
}

void JournalTest::foldersThatOthersWriteToAreRefused() {
    Workbench bench;
    const StateFolder state(bench.dir.path().toStdString());
    fs::create_directories(session::stateFolder());
    fs::permissions(session::stateFolder(), fs::perms::all);
    QVERIFY_EXCEPTION_THROWN(session::Journal(), base::Error);
    fs::permissions(session::stateFolder(), fs::perms::owner_all);
    QCOMPARE(lineCount(session::Journal().path()), 0);
}

static const test::Registered<JournalTest> registered;
#include "journal_test.moc"
