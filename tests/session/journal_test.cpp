#include "core/session/journal.h"

#include "core/io/colour_png.h"
#include "support/registry.h"
#include "workbench.h"

#include <QTest>

using nlohmann::json;
using test::Workbench;
namespace fs = std::filesystem;

class JournalTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void recoveryGivesTheLastCommandsModel();
    void aTornLastLineIsLeftOut();
    void aLineThatIsNoCommandIsToldWithItsNumber();
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

void JournalTest::aLineThatIsNoCommandIsToldWithItsNumber() {
    Workbench bench;
    const auto file =
        test::write(bench.path("j.jsonl"), test::newSphere().dump() + "\n{\"op\":\n" + test::strokeAt(0).dump() + "\n");
    try {
        session::recover(file, bench.context);
        QFAIL("a torn line in the middle was passed over");
    } catch (const base::Error& error) {
        QVERIFY2(error.message().find("j.jsonl:2: ") != std::string::npos, error.what());
    }
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

static const test::Registered<JournalTest> registered;
#include "journal_test.moc"
