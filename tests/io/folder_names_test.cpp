// What a folder holds is all that is there, and nothing of a folder that is not.
#include "core/io/folder_names.h"
#include "support/registry.h"

#include <fstream>
#include <QTemporaryDir>
#include <QTest>
#include <set>

class FolderNamesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyNameComesOnce();
    void missingFoldersHoldNothing();
};

void FolderNamesTest::everyNameComesOnce() {
    QTemporaryDir dir;
    const std::filesystem::path folder = dir.path().toStdString();
    std::set<std::string> wanted{".hidden", "sub", "a b", "\xff\xfe"};
    std::filesystem::create_directory(folder / "sub");
    for (const char* name : {".hidden", "a b", "\xff\xfe", "sub/inner"})
        std::ofstream(folder / name) << "x";
    for (int k = 0; k < 300; ++k)
        std::ofstream(folder / *wanted.insert("file " + std::to_string(k)).first) << k;
    const std::vector<std::string> found = io::namesIn(folder);
    QCOMPARE(found.size(), wanted.size());
    QVERIFY(std::set<std::string>(found.begin(), found.end()) == wanted);
}

void FolderNamesTest::missingFoldersHoldNothing() {
    QTemporaryDir dir;
    const std::filesystem::path folder = dir.path().toStdString();
    QVERIFY(io::namesIn(folder).empty());
    QVERIFY(io::namesIn(folder / "none").empty());
    std::ofstream(folder / "file") << "x";
    QVERIFY(io::namesIn(folder / "file").empty());
}

static const test::Registered<FolderNamesTest> registered;
#include "folder_names_test.moc"
