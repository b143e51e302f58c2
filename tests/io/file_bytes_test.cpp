// Files that are no plain files, or change while they are read.
#include "core/io/file_bytes.h"

#include "io/io_support.h"
#include "support/registry.h"

#include <sys/stat.h>
#include <thread>

class FileBytesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void bytesAreThoseOfTheFile();
    void whatIsCutOffLaterStays();
    void aPipeIsReadOnce();
    void endlessInputEnds();
};

void FileBytesTest::bytesAreThoseOfTheFile() {
    const test::Folder folder;
    base::Random random(test::seed());
    for (const std::size_t size : {1u, 5u, 4194303u, 4194304u, 4194305u, 9000000u}) {
        std::string content(size, '\0');
        for (char& c : content)
            c = static_cast<char>(random.next());
        QVERIFY(io::FileBytes(folder.write("a", content)).bytes() == content);
    }
}

void FileBytesTest::whatIsCutOffLaterStays() {
    const test::Folder folder;
    const std::string content(100000, 'x');
    const auto path = folder.write("a", content);
    const io::FileBytes file(path);
    std::filesystem::resize_file(path, 10);
    QVERIFY(file.bytes() == content); // a mapped file would end the program here
}

void FileBytesTest::aPipeIsReadOnce() {
    const test::Folder folder;
    const auto pipe = folder.path("a.ply");
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] {
        std::ofstream(pipe) << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                               "end_header\n1 2\n";
    });
    const io::FileModel model = io::read(pipe);
    writer.join();
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 0}));
}

void FileBytesTest::endlessInputEnds() {
    const std::string message = test::refusal("/dev/zero");
    QVERIFY2(test::contains(message, "more than 1024 MiB"), message.c_str());
}

static const test::Registered<FileBytesTest> registered;
#include "file_bytes_test.moc"
