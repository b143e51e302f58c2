#include "core/io/safe_file.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <sys/stat.h>

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

static const test::Registered<SafeFileTest> registered;
#include "safe_file_test.moc"
