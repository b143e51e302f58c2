// What a journal brings back after a crash, and what it cannot.
#include "core/io/pictures/colour_png.h"
#include "journals.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QDir>
#include <QTest>

using nlohmann::json;
using test::lineCount;
using test::recovered;
using test::Workbench;
namespace fs = std::filesystem;

class RecoverTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void recoveryGivesTheLastCommandsModel();
    void aTornLastLineIsLeftOut();
    void aTornLastLineIsTold();
    void aLineThatIsNoCommandIsToldAndPassedOver();
    void aChangedFileIsNoticed();
    void savingOverTheSourceKeepsIt();
    void savingOverAnotherModelKeepsIt_data();
    void savingOverAnotherModelKeepsIt();
    void keptSourcesHaveTheirPictures();
    void recoveringKeepsTheSourceOfTheOldJournal();
    void leftJournalsAreThoseThatNobodyHolds();
};

void RecoverTest::recoveryGivesTheLastCommandsModel() {
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
    bench.run({{"op", "redo"}}); // nothing: nothing to record
    bench.run({{"op", "expect"}, {"hash", bench.hash()}});
    bench.run({{"op", "save"}, {"path", bench.path("a.ply").string()}});
    QCOMPARE(lineCount(journal.path()), lines);
}

void RecoverTest::aTornLastLineIsLeftOut() {
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
    Workbench told;
    session::recover(test::write(bench.path("torn.jsonl"), whole + "{"), told.context);
    QCOMPARE(told.context.messages.size(), std::size_t(1));
    QVERIFY(told.context.messages[0].find("torn.jsonl:3: ") != std::string::npos);
    test::write(bench.path("torn.jsonl"), whole.substr(0, 10));
    QVERIFY_EXCEPTION_THROWN(recovered(bench.path("torn.jsonl")), base::Error);
}

void RecoverTest::aTornLastLineIsTold() {
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

void RecoverTest::aLineThatIsNoCommandIsToldAndPassedOver() {
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

void RecoverTest::aChangedFileIsNoticed() {
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

    // Whoever takes it as it is has the same stroke on the other model.
    Workbench anyway;
    anyway.context.takesChangedFiles = true;
    QCOMPARE(session::recover(journal.path(), anyway.context).leftOut, 0);
    QVERIFY(anyway.size() < 2500 && anyway.document.canUndo());
    QVERIFY(anyway.context.messages.front().find("a.ply: the file is not the one") != std::string::npos);
}

void RecoverTest::savingOverTheSourceKeepsIt() {
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
    QCOMPARE(again.document.path().string(), file);
}

void RecoverTest::savingOverAnotherModelKeepsIt_data() {
    QTest::addColumn<QString>("line");
    QTest::newRow("register to") << R"({"op":"register","to":"b.ply"})";
    if (!test::sanitized) // half a minute there
        QTest::newRow("register moving") << R"({"op":"register","moving":["c.ply","b.ply"]})";
    QTest::newRow("measure") << R"({"op":"measure","to":"b.ply"})";
    QTest::newRow("solid") << R"({"op":"solid","path":"b.ply","position":"0.7,0,0"})";
    QTest::newRow("the opened one") << R"({"op":"measure","to":"a.ply"})";
}

/// By the journal, by its copy, and by the journal of who recovered it, when the old one is gone.
void RecoverTest::savingOverAnotherModelKeepsIt() {
    QFETCH(QString, line);
    Workbench bench;
    bench.context.folder = bench.dir.path().toStdString();
    for (const char* name : {"b.ply", "c.ply", "a.ply"}) {
        bench.run(test::newSphere(800));
        bench.run(test::strokeAt(name[0] == 'a' ? 0.1 : 0));
        bench.run({{"op", "save"}, {"path", name}});
    }
    auto journal = std::make_unique<session::Journal>(bench.path("j.jsonl"));
    bench.context.journal = journal.get();
    bench.run({{"op", "open"}, {"path", "a.ply"}});
    for (int k = 0; k < 2; ++k) { // the second time the line reads what the first save wrote
        bench.run(json::parse(line.toStdString()));
        bench.run(test::strokeAt(0.2 + 0.1 * k));
        for (const char* name : {"b.ply", "a.ply"})
            bench.run({{"op", "save"}, {"path", name}});
    }
    journal->copyTo(bench.path("copy.jsonl"));
    Workbench next;
    session::Journal after(bench.path("after.jsonl"));
    next.context.journal = &after;
    session::recover(journal->path(), next.context);
    QCOMPARE(next.hash(), bench.hash());
    journal->discard();
    bench.context.journal = nullptr;
    QCOMPARE(recovered(after.path()), bench.hash());
    QCOMPARE(recovered(bench.path("copy.jsonl")), bench.hash());
}

/// A model saved over itself: the copy that the journal reads is in another folder than its picture.
void RecoverTest::keptSourcesHaveTheirPictures() {
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

void RecoverTest::recoveringKeepsTheSourceOfTheOldJournal() {
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

void RecoverTest::leftJournalsAreThoseThatNobodyHolds() {
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

static const test::Registered<RecoverTest> registered;
#include "recover_test.moc"
