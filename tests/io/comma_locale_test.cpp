// Readers and writers where a comma separates decimals: the same numbers, the same bytes.
#include "support/comma_locale.h"

#include "core/io/formats.h"
#include "support/registry.h"

#include <fstream>
#include <QTest>
#include <sstream>

class CommaLocaleTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void everyFormatIsTheSame();
};

static std::string bytesOf(const std::string& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

/// Text files as people have them, and what comes of each when it is read and written in every format.
static std::vector<std::string> results() {
    const QTemporaryDir folder;
    const auto path = [&](const std::string& name) { return folder.filePath(name.c_str()).toStdString(); };
    const std::pair<const char*, const char*> files[] = {
        {"a.xyz", "0.5 -1.25 2e-3 0 0 1\n1.5 .75 3.0625 0 0.6 0.8\n-0.001 1e3 4 1 0 0\n"},
        {"a.csv", "x,y,z\n0.5,1.25,2\n1.5,2.25,3\n0.125,1,7\n"},
        {"a.off", "OFF\n3 1 0\n0.5 0 0\n1.25 0 0\n0 1.75 0.5\n3 0 1 2\n"},
        {"a.obj", "v 0.5 0 0\nv 1.25 0 0\nv 0 1.75 0.5\nvn 0 0.6 0.8\nf 1//1 2//1 3//1\n"},
        {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0.5 0 0\nvertex 1.25 0 0\nvertex 0 1.75 0.5\n"
                  "endloop\nendfacet\nendsolid a\n"},
        {"a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty double y\nproperty float z\n"
                  "end_header\n0.5 1.25 -3e-2\n7.75 0.1 2\n"}};
    std::vector<std::string> out;
    for (const auto& [name, text] : files) {
        std::ofstream(path(name), std::ios::binary) << text;
        const io::FileModel model = io::read(path(name));
        for (const io::FormatRow& row : io::formatTable()) {
            const std::string extension = QString(row.extensions).section(' ', 0, 0).toStdString();
            if (!row.write || extension == "stl") // of faces alone
                continue;
            const std::string written = path(std::string(name) + "." + extension);
            io::write(written, model);
            out.push_back(bytesOf(written));
        }
    }
    return out;
}

void CommaLocaleTest::everyFormatIsTheSame() {
    const auto usual = results();
    QVERIFY(usual.size() >= 12);
    const test::CommaLocale comma;
    QVERIFY(comma.works());
    QVERIFY(results() == usual);
}

static const test::Registered<CommaLocaleTest> registered;
#include "comma_locale_test.moc"
