#include "core/io/safe_file.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

class SafeFileTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void targetIsUntouchedUntilCommit();
    void withoutCommitNothingIsLeft();
    void linksStayLinksAndPermissionsStay();
    void newFilesHaveOrdinaryPermissions();
    void impossibleTargetsAreRefused();
    void pipesAreWrittenDirectly();
    void writeProtectedTargetsStay();
    void whatKilledProcessesBeganGoes();
    void otherNamesAreKnown();
};

void SafeFileTest::targetIsUntouchedUntilCommit() {
    const test::Folder folder;
    const fs::path target = folder.write("a.txt", "old");
    io::SafeFile file(target);
    file.write("new ");
    file.write("content");
    QCOMPARE(test::contentOf(target), std::string("old"));
    file.commit();
    QCOMPARE(test::contentOf(target), std::string("new content"));
    QCOMPARE(folder.entries(), std::size_t(1));
}

void SafeFileTest::withoutCommitNothingIsLeft() {
    const test::Folder folder;
    try {
        io::SafeFile file(folder.path("a.txt"));
        file.write(std::string(1 << 20, 'x'));
        QCOMPARE(folder.entries(), std::size_t(1));
        throw base::Cancelled();
    } catch (const base::Cancelled&) {
    }
    QCOMPARE(folder.entries(), std::size_t(0));
}

void SafeFileTest::linksStayLinksAndPermissionsStay() {
    const test::Folder folder;
    const fs::path real = folder.write("real.txt", "old"), link = folder.path("link.txt");
    fs::create_symlink(real, link);
    fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
    io::writeFile(link, "new");
    QVERIFY(fs::is_symlink(link));
    QCOMPARE(test::contentOf(real), std::string("new"));
    QVERIFY(fs::status(real).permissions() == (fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read));
}

void SafeFileTest::newFilesHaveOrdinaryPermissions() {
    const test::Folder folder;
    io::writeFile(folder.path("safe"), "a");
    const fs::path plain = folder.write("plain", "a");
    QVERIFY(fs::status(folder.path("safe")).permissions() == fs::status(plain).permissions());
}

void SafeFileTest::impossibleTargetsAreRefused() {
    const test::Folder folder;
    QVERIFY_EXCEPTION_THROWN(io::SafeFile(folder.path("")), base::Error);
    QVERIFY_EXCEPTION_THROWN(io::SafeFile(folder.path("nowhere") / "a.ply"), base::Error);
    QVERIFY_EXCEPTION_THROWN(io::SafeFile(folder.write("file", "x") / "a.ply"), base::Error);
}

void SafeFileTest::pipesAreWrittenDirectly() {
    QVERIFY(fs::exists("/dev/null"));
    io::writeFile("/dev/null", "into nothing");
    QVERIFY(fs::is_character_file("/dev/null"));
}

void SafeFileTest::writeProtectedTargetsStay() {
    const test::Folder folder;
    const fs::path target = folder.write("a.txt", "old");
    fs::permissions(target, fs::perms::owner_read);
    try {
        io::writeFile(target, "new");
        QFAIL("a write-protected file was replaced");
    } catch (const base::Error& error) {
        QVERIFY2(error.message().find("a.txt: is write-protected") != std::string::npos, error.what());
    }
    QCOMPARE(test::contentOf(target), std::string("old"));
    QCOMPARE(folder.entries(), std::size_t(1));
}

void SafeFileTest::whatKilledProcessesBeganGoes() {
    const test::Folder folder;
    const pid_t child = ::fork();
    if (child == 0)
        ::_exit(0);
    ::waitpid(child, nullptr, 0); // a number that no process has
    const std::string gone = std::to_string(child), alive = std::to_string(::getpid());
    folder.write(".a.txt." + gone + "-0", "half");
    folder.write(".a.txt." + gone + "-17", "half");
    for (const std::string& other : {".a.txt." + alive + "-999", ".b.txt." + gone + "-0", ".a.txt." + gone + "-x",
                                     ".a.txt." + gone, std::string("a.txt.1-0")})
        folder.write(other, "stays");
    io::writeFile(folder.path("a.txt"), "new");
    QCOMPARE(folder.entries(), std::size_t(6));
    QVERIFY(!fs::exists(folder.path(".a.txt." + gone + "-0")));
    QVERIFY(!fs::exists(folder.path(".a.txt." + gone + "-17")));
}

void SafeFileTest::otherNamesAreKnown() {
    const test::Folder folder;
    const fs::path one = folder.write("one.txt", "old"), two = folder.path("two.txt");
    QVERIFY(!io::hasOtherNames(one));
    QVERIFY(!io::hasOtherNames(two));
    fs::create_hard_link(one, two);
    QVERIFY(io::hasOtherNames(one));
    io::writeFile(two, "new");
    QCOMPARE(test::contentOf(one), std::string("old"));
    QVERIFY(!io::hasOtherNames(one));
}

static const test::Registered<SafeFileTest> registered;
#include "safe_file_test.moc"
