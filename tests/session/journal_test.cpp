#include "core/session/journal.h"

#include "core/io/colour_png.h"
#include "support/registry.h"
#include "workbench.h"

#include <QDir>
#include <QTest>

using nlohmann::json;
using test::Workbench;
namespace fs = std::filesystem;

class JournalTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void recoveryGivesTheLastCommandsModel();
    void aTornLastLineIsLeftOut();
    void aTornLastLineIsTold();
    void aLineThatIsNoCommandIsToldAndPassedOver();
    void openAndNewBeginAnew();
    void aChangedFileIsNoticed();
    void savingOverTheSourceKeepsIt();
    void keptSourcesHaveTheirPictures();
    void recoveringKeepsTheSourceOfTheOldJournal();
    void leftJournalsAreThoseThatNobodyHolds();
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
    void pathsThatAreNotUtf8Survive();
    void leftoversOfKilledProcessesGo();
    void leftoversOfANamedJournalGo();
    void foldersThatOthersWriteToAreRefused();
};

static std::string recovered(const fs::path& journal) {
    Workbench bench;
    session::recover(journal, bench.context);
    return bench.hash();
}

static int lineCount(const fs::path& file) {
    const std::string content = test::contentOf(file);
    return static_cast<int>(std::count(content.begin(), content.end(), '\n'));
}

void JournalTest::recoveryGivesTheLastCommandsModel() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    for (const json& command :
         {test::strokeAt(0), test::strokeAt(0.2, "smooth"), json{{"op", "undo"}}, test::strokeAt(-0.2, "clay"),
          json{{"op", "undo"}}, json{{"op", "redo"}}, json{{"op", "surface"}, {"neighbours", 30}}}) {
        bench.run(command);
        QCOMPARE(recovered(journal.path()), bench.hash());
    }
    const int lines = lineCount(journal.path());
    QVERIFY(!bench.refusal({{"op", "redo"}}).empty());
    bench.run({{"op", "expect"}, {"hash", bench.hash()}});
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    QCOMPARE(lineCount(journal.path()), lines);
}

void JournalTest::aTornLastLineIsLeftOut() {
    Workbench bench;
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    const std::string whole = test::contentOf(journal.path()), before = bench.hash();
    bench.run(test::strokeAt(0.2));
    const std::string more = test::contentOf(journal.path());
    QVERIFY(more.starts_with(whole));
    for (const std::size_t length :
         {whole.size() + 1, whole.size() + 9, (whole.size() + more.size()) / 2, more.size() - 2, more.size() - 1})
        QCOMPARE(recovered(test::write(bench.path("torn.jsonl"), more.substr(0, length))), before);
    QCOMPARE(recovered(test::write(bench.path("torn.jsonl"), whole + std::string(100, '\0') + "\n")), before);
    QCOMPARE(recovered(test::write(bench.path("torn.jsonl"), more)), bench.hash());
    test::write(bench.path("torn.jsonl"), whole.substr(0, 10));
    QVERIFY_EXCEPTION_THROWN(recovered(bench.path("torn.jsonl")), base::Error);
}

void JournalTest::aTornLastLineIsTold() {
    const std::string first = test::newSphere().dump() + "\n", stroke = test::strokeAt(0).dump() + "\n";
    for (const bool torn : {false, true}) {
        Workbench bench;
        const auto file = test::write(bench.path("j.jsonl"), first + stroke + (torn ? stroke.substr(0, 40) : ""));
        const session::Recovery found = session::recover(file, bench.context);
        QCOMPARE(found.commands, 2);
        QCOMPARE(found.leftOut, 0);
        QCOMPARE(bench.context.messages.size(), std::size_t(torn ? 1 : 0));
        QVERIFY(!torn || bench.context.messages[0].find("j.jsonl:3: ") != std::string::npos);
    }
}

void JournalTest::aLineThatIsNoCommandIsToldAndPassedOver() {
    Workbench bench, whole;
    const std::string first = test::newSphere().dump() + "\n", stroke = test::strokeAt(0).dump() + "\n";
    whole.run(test::newSphere());
    whole.run(test::strokeAt(0));
    const auto file = test::write(bench.path("j.jsonl"), first + "{\"op\":\n" + stroke + "{\"op\":\"dance\"}\n{}\n");
    QCOMPARE(session::recover(file, bench.context).leftOut, 3);
    QCOMPARE(bench.hash(), whole.hash());
    QCOMPARE(bench.context.messages.size(), std::size_t(3));
    for (const int k : {0, 1, 2})
        QVERIFY(bench.context.messages[std::size_t(k)].find("j.jsonl:" + std::to_string(k == 0 ? 2 : k + 3) + ": ") !=
                std::string::npos);
    test::write(file, "{\"op\":\n" + first + stroke); // nothing to go on from
    QVERIFY_EXCEPTION_THROWN(recovered(file), base::Error);
}

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

void JournalTest::aChangedFileIsNoticed() {
    Workbench bench;
    bench.run(test::newSphere());
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", bench.path("a.ply").string()}});
    bench.run(test::strokeAt(0));
    Workbench other;
    other.run(test::newSphere(2000));
    other.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    QVERIFY_EXCEPTION_THROWN(recovered(journal.path()), base::Error);
}

void JournalTest::savingOverTheSourceKeepsIt() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string file = bench.path("a.ply").string();
    bench.run({{"op", "save"}, {"path", file}});
    session::Journal journal(bench.path("j.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", file}});
    for (const double y : {0.0, 0.2}) {
        bench.run(test::strokeAt(y));
        bench.run({{"op", "save"}, {"path", file}});
        QCOMPARE(recovered(journal.path()), bench.hash());
    }
    bench.run({{"op", "undo"}});
    bench.run({{"op", "undo"}});
    QCOMPARE(recovered(journal.path()), bench.hash());
    Workbench again;
    session::recover(journal.path(), again.context);
    QCOMPARE(again.document.provenance().path.string(), file);
}

/// A model saved over itself: the copy that the journal reads is in another folder than its picture.
void JournalTest::keptSourcesHaveTheirPictures() {
    Workbench bench;
    const std::uint32_t red[] = {0xff0000ff};
    test::write(bench.path("m.png"), io::encodePng(red, 1, 1, ""));
    const auto file = test::write(
        bench.path("a.ply"),
        "ply\nformat ascii 1.0\ncomment TextureFile m.png\nelement vertex 4\nproperty float x\nproperty "
        "float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\nproperty list "
        "uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 6 0 0 1 0 1 1\n3 0 1 3 6 0 0 1 "
        "0 1 1\n3 0 3 2 6 0 0 1 0 1 1\n3 1 2 3 6 0 0 1 0 1 1\n");
    fs::create_directory(bench.path("state"));
    session::Journal journal(bench.path("state/j.jsonl"));
    bench.context.journal = &journal;
    bench.run({{"op", "open"}, {"path", file.string()}, {"sample_count", 2000}});
    QVERIFY(bench.document.surface().tree().layout()->colours);
    bench.run({{"op", "save"}, {"path", file.string()}});
    bench.run({{"op", "up"}, {"axis", "z"}});
    QCOMPARE(recovered(journal.path()), bench.hash());
}

void JournalTest::recoveringKeepsTheSourceOfTheOldJournal() {
    Workbench bench;
    bench.run(test::newSphere());
    const std::string file = bench.path("a.ply").string();
    bench.run({{"op", "save"}, {"path", file}});
    {
        session::Journal journal(bench.path("old.jsonl"));
        bench.context.journal = &journal;
        bench.run({{"op", "open"}, {"path", file}});
        bench.run(test::strokeAt(0));
        bench.run({{"op", "save"}, {"path", file}});
        bench.run(test::strokeAt(0.2));
    }
    Workbench next;
    session::Journal journal(bench.path("new.jsonl"));
    next.context.journal = &journal;
    session::recover(bench.path("old.jsonl"), next.context);
    QCOMPARE(next.hash(), bench.hash());
    session::removeJournal(bench.path("old.jsonl"));
    next.run(test::strokeAt(-0.2));
    QCOMPARE(recovered(journal.path()), next.hash());
    journal.discard();
    QCOMPARE(QDir(bench.dir.path()).entryList(QDir::Files), QStringList{"a.ply"});
}

void JournalTest::leftJournalsAreThoseThatNobodyHolds() {
    Workbench bench;
    const fs::path folder = bench.dir.path().toStdString();
    QVERIFY(session::findLeftJournals(folder).empty());
    QVERIFY(session::findLeftJournals(folder / "nowhere").empty());
    test::write(folder / "notes.txt", "");
    test::write(folder / "journal-1.jsonl", "");
    auto journal = std::make_unique<session::Journal>(folder / "journal-2.jsonl");
    bench.context.journal = journal.get();
    bench.run(test::newSphere());
    bench.run(test::strokeAt(0));
    bench.run(test::strokeAt(0.2));
    QVERIFY(session::isJournalHeld(journal->path()));
    QVERIFY(session::findLeftJournals(folder).empty());
    journal.reset();
    const auto left = session::findLeftJournals(folder);
    QCOMPARE(left.size(), std::size_t(1));
    QCOMPARE(left[0].path.string(), (folder / "journal-2.jsonl").string());
    QCOMPARE(left[0].commands, 2);
    QVERIFY(left[0].model.empty());
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
