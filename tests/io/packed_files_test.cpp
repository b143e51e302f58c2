// Files packed with gzip, of every format, and archives: what comes out, and what is refused.
#include "core/io/packed/inflate.h"
#include "core/io/packed/zip_archive.h"

#include "io/io_support.h"
#include "support/crc32.h"
#include "support/registry.h"

#include <QByteArray>

class PackedFilesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFormatComesOutOfGzip();
    void membersFollowEachOther();
    void messagesNameThePackedFile();
    void damagedGzipIsRefused();
    void whatBecomesTooLongIsRefused();
    void archivesBringTheirEntriesBack();
};

namespace {

/// RFC 1952 around Qt's DEFLATE, which has 4 bytes of Qt's and 2 of zlib's before, and 4 behind.
std::string gzip(const std::string& bytes, bool checked = true) {
    const QByteArray packed = qCompress(QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())));
    std::string out("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);
    out += bytes.empty() ? std::string("\3\0", 2) : packed.mid(6, packed.size() - 10).toStdString();
    for (const std::uint32_t word : {checked ? test::crc32(bytes) : 0u, static_cast<std::uint32_t>(bytes.size())})
        out.append(reinterpret_cast<const char*>(&word), sizeof word);
    return out;
}

} // namespace

void PackedFilesTest::everyFormatComesOutOfGzip() {
    base::Random random(test::seed());
    const test::Folder folder;
    const io::FileModel model = test::randomModel(random, 40);
    int tried = 0;
    for (const io::FormatRow& row : io::formatTable()) {
        const std::string extension = QString(row.extensions).section(' ', 0, 0).toStdString();
        if (!row.write || !row.read)
            continue;
        io::write(folder.path("a." + extension), model);
        const io::FileModel plain = io::read(folder.path("a." + extension));
        const auto packed =
            folder.write("b." + extension + ".gz", gzip(test::contentOf(folder.path("a." + extension))));
        const io::FileModel out = io::read(packed);
        QVERIFY2(test::sameBits(plain, out), row.id);
        QCOMPARE(out.format, plain.format);
        ++tried;
    }
    QVERIFY(tried >= 6);
}

void PackedFilesTest::membersFollowEachOther() {
    const test::Folder folder;
    const io::FileModel model = io::read(folder.write("a.xyz.gz", gzip("1 2 3\n4 5 6\n") + gzip("7 8 9\n")));
    QCOMPARE(model.points.size(), std::size_t(3));
    QVERIFY(model.points.items[2].position == (base::Vec3f{7, 8, 9}));
}

void PackedFilesTest::messagesNameThePackedFile() {
    const test::Folder folder;
    const auto path = folder.write("a.obj.gz", gzip("v 1 2 3\nv 1 2\n"));
    const std::string message = test::refusal(path);
    QVERIFY2(test::contains(message, path.string() + ", line 2: needs three numbers"), message.c_str());
}

void PackedFilesTest::damagedGzipIsRefused() {
    const test::Folder folder;
    const std::string text = "1 2 3\n4 5 6\n", whole = gzip(text);
    for (std::size_t size = 3; size < whole.size(); ++size)
        QVERIFY(!test::refusal(folder.write("a.xyz.gz", whole.substr(0, size))).empty());
    QVERIFY(test::contains(test::refusal(folder.write("a.xyz.gz", gzip(text, false))), "are damaged"));
    QVERIFY(test::contains(test::refusal(folder.write("a.xyz.gz", gzip(whole))), "gzip twice over"));
    QVERIFY(test::contains(test::refusal(folder.write("a.xyz.gz", gzip(""))), "holds nothing"));
}

void PackedFilesTest::whatBecomesTooLongIsRefused() {
    const test::Folder folder;
    const auto path = folder.write("a.xyz.gz", gzip(std::string(std::size_t(75) << 20, '\n'), false));
    QVERIFY(io::mostInflated(std::filesystem::file_size(path)) < std::size_t(75) << 20);
    QVERIFY(test::contains(test::refusal(path), "when it is unpacked"));
}

void PackedFilesTest::archivesBringTheirEntriesBack() {
    base::Random random(test::seed());
    const test::Folder folder;
    std::vector<std::string> contents{"", "a"};
    for (int i = 0; i < 6; ++i) {
        std::string& text = contents.emplace_back();
        for (std::size_t k = random.below(300000); k > 0; --k)
            text += static_cast<char>(random.below(i % 2 == 0 ? 256 : 3));
    }
    {
        io::SafeFile file(folder.path("a.zip"));
        io::ZipWriter zip(file);
        for (std::size_t i = 0; i < contents.size(); ++i) {
            zip.begin("folder/" + std::to_string(i));
            zip.write(std::string_view(contents[i]).substr(0, contents[i].size() / 3));
            zip.write(std::string_view(contents[i]).substr(contents[i].size() / 3));
            zip.end();
        }
        zip.finish();
        file.commit();
    }
    const io::FileBytes bytes(folder.path("a.zip"));
    const std::vector<io::ZipEntry> entries = io::zipEntries(bytes);
    QCOMPARE(entries.size(), contents.size());
    for (std::size_t i = 0; i < contents.size(); ++i) {
        QCOMPARE(entries[i].name, "folder/" + std::to_string(i));
        QCOMPARE(entries[i].checksum, test::crc32(contents[i]));
        QVERIFY(io::unpackedEntry(bytes, entries[i], {}) == contents[i]);
    }
}

static const test::Registered<PackedFilesTest> registered;
#include "packed_files_test.moc"
