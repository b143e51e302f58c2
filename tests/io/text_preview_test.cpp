// What a text's columns are, told by a person or seen in advance.
#include "core/io/text/text_preview.h"
#include "io/io_support.h"
#include "support/registry.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <sstream>

using io::FileModel, io::TextPreview;

class TextPreviewTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void namesOfSurveyorsAreUnderstood_data();
    void namesOfSurveyorsAreUnderstood();
    void columnsThatAreToldAreTakenInAnyOrder();
    void rowsOfOtherLengthsOpenWhenColumnsAreNamed();
    void coloursAreNoNormals();
    void whatDoesNotFitIsRefused();
    void namesAreCheckedBeforeTheFile();
    void previewsSayWhatOpeningTakes();
    void onlyTextHasAPreview();
    void longFilesAreSeenByTheirBeginning();
};

void TextPreviewTest::namesOfSurveyorsAreUnderstood_data() {
    QTest::addColumn<QString>("names");
    QTest::addColumn<QString>("values");
    QTest::newRow("east first") << "East;North;Height"
                                << "1;2;3";
    QTest::newRow("north first") << "northing,easting,elevation"
                                 << "2,1,3";
    QTest::newRow("behind others") << "Id;Intensity;E;N;H"
                                   << "7;9;1;2;3";
    QTest::newRow("units in brackets") << "X [m];Y [m];Z [m]"
                                       << "1;2;3";
    QTest::newRow("units without a blank") << "x(mm) y(mm) z(mm)"
                                           << "1 2 3";
    QTest::newRow("of ParaView") << "\"Points:0\",\"Points:1\",\"Points:2\""
                                 << "1,2,3";
    QTest::newRow("in German") << QString::fromUtf8("Rechtswert;Hochwert;H\xc3\xb6he") << "1;2;3";
    QTest::newRow("height beside z") << "height,x,y,z"
                                     << "9,1,2,3";
}

void TextPreviewTest::namesOfSurveyorsAreUnderstood() {
    QFETCH(QString, names);
    QFETCH(QString, values);
    const test::Folder folder;
    const auto path = folder.write("a.csv", (names + "\n" + values + "\n" + values + "\n").toStdString());
    const FileModel model = io::read(path);
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QVERIFY(!test::anyContains(model.messages, "first three"));
    const auto preview = io::previewText(path);
    QVERIFY(preview && preview->sure);
    const bool height = !names.contains('z', Qt::CaseInsensitive) && !names.contains("Points");
    QCOMPARE(model.up, height ? std::optional(base::UpAxis::Z) : std::nullopt); // which nothing has to guess
}

/// A cloud with normals, colours and a measure, its columns shuffled and some of them left out.
void TextPreviewTest::columnsThatAreToldAreTakenInAnyOrder() {
    base::Random random(test::seed());
    const std::vector<std::string> all{"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "quality"};
    for (int round = 0; round < 30; ++round) {
        std::vector<std::size_t> order(all.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        for (std::size_t k = order.size(); k-- > 1;)
            std::swap(order[k], order[random.below(k + 1)]);
        const bool named = random.uniform() < 0.5, colours = random.uniform() < 0.7;
        std::vector<std::string> told;
        for (const std::size_t k : order)
            told.push_back(k >= 6 && k < 9 && !colours ? "-" : all[k]);
        std::ostringstream text;
        if (named)
            text << "a,b,c,d,e,f,g,h,i,j\n";
        std::vector<base::Vec3f> positions;
        for (int i = 0; i < 20; ++i) {
            const base::Vec3d p = random.unitVector() * 8.0, n{0, 0, 1};
            const std::vector<double> values{p.x, p.y, p.z, n.x, n.y, n.z, 10, 20, 30, 0.5 * i};
            positions.push_back(base::cast<float>(p));
            for (std::size_t k = 0; k < order.size(); ++k)
                text << (k ? "," : "") << std::setprecision(17) << values[order[k]];
            text << '\n';
        }
        const test::Folder folder;
        const auto path = folder.write("a.csv", text.str());
        const FileModel model = io::readColumns(path, told);
        const QString where = QString("round %1, seed %2").arg(round).arg(test::seed());
        QVERIFY2(model.points.size() == 20 && model.points.layout->normals, qPrintable(where));
        QVERIFY2(model.points.layout->colours == colours, qPrintable(where));
        for (std::size_t i = 0; i < 20; ++i)
            QVERIFY2(model.points.items[i].position == positions[i] &&
                         model.points.items[i].normal == base::Vec3f({0, 0, 1}) &&
                         (!colours || model.points.items[i].colour == surfel::rgba(10, 20, 30)),
                     qPrintable(where));
        QVERIFY2(model.points.layout->find("quality"), qPrintable(where));
        const auto preview = io::previewText(path, told);
        QVERIFY2(preview && preview->columns == told && preview->rows.size() == 8, qPrintable(where));
    }
}

void TextPreviewTest::rowsOfOtherLengthsOpenWhenColumnsAreNamed() {
    const test::Folder folder;
    const std::string text = "1 2 3 7\n4 5 6\n7 8 9 10 11\n1 1\n";
    const auto path = folder.write("a.xyz", text);
    QVERIFY(test::contains(test::refusal(path), "line 2: holds 3 values where 4"));
    const FileModel model = io::readColumns(path, {"x", "y", "z", "dose"}, {});
    QCOMPARE(model.points.size(), std::size_t(3));
    QCOMPARE(model.dropped, std::size_t(1)); // has no z
    QCOMPARE(model.points.items[1].position, base::Vec3f({4, 5, 6}));
    QCOMPARE(model.points.items[2].position, base::Vec3f({7, 8, 9}));
    QVERIFY(test::anyContains(model.messages, "3 rows do not have the 4 columns"));
    QCOMPARE(io::readColumns(path, {"x", "y", "z"}, {}).points.size(), std::size_t(3));
    const auto shorter = folder.write("b.xyz", "1 2 3\n4 5 6 7 8\n"); // the first row is the short one
    QCOMPARE(io::readColumns(shorter, {"x", "y", "z", "a", "b"}, {}).points.size(), std::size_t(2));
    const auto even = folder.write("c.xyz", "1 2 3 4\n4 5 6 7\n");
    QVERIFY_EXCEPTION_THROWN(io::readColumns(even, {"x", "y", "z"}, {}), base::Error);
}

void TextPreviewTest::coloursAreNoNormals() {
    const test::Folder folder;
    const auto path = folder.write("a.xyz", "1 2 3 255 0 10\n4 5 6 12 30 40\n");
    const std::vector<std::string> wrong = {"x", "y", "z", "nx", "ny", "nz"};
    try {
        io::readColumns(path, wrong, {});
        QFAIL("colours were taken for normals");
    } catch (const base::Error& error) {
        QVERIFY2(test::contains(error.what(), "from 0 to 255, as colours do"), error.what());
    }
    QVERIFY(io::readColumns(path, {"x", "y", "z", "red", "green", "blue"}, {}).points.layout->colours);
    const auto whole = folder.write("b.xyz", "1 2 3 1 0 0\n4 5 6 0 0 1\n"); // axes are directions
    QCOMPARE(io::readColumns(whole, wrong, {}).points.size(), std::size_t(2));
    const auto named = folder.write("c.csv", "x,y,z,nx,ny,nz\n1,2,3,255,0,10\n4,5,6,12,30,40\n");
    QVERIFY(test::anyContains(io::read(named).messages, "as colours are"));
}

void TextPreviewTest::whatDoesNotFitIsRefused() {
    const test::Folder folder;
    const auto refusal = [](const std::filesystem::path& path, const std::vector<std::string>& columns) {
        try {
            io::readColumns(path, columns);
        } catch (const base::Error& error) {
            return error.message();
        }
        return std::string();
    };
    const auto four = folder.write("a.xyz", "1 2 3 4\n5 6 7 8\n");
    QVERIFY(test::contains(refusal(four, {"x", "y", "z"}), "holds 4 columns, and 3 are named"));
    const auto words = folder.write("w.csv", "a,b,c,d\n1,2,ok,4\n5,6,ok,8\n");
    QVERIFY(test::contains(refusal(words, {"x", "y", "z", "q"}), "columns of numbers"));
    QVERIFY(refusal(words, {"x", "y", "q", "z"}).empty());
    const auto off = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    QVERIFY(test::contains(refusal(off, {"x", "y", "z"}), "tells itself"));
}

void TextPreviewTest::namesAreCheckedBeforeTheFile() {
    QCOMPARE(io::columnNames(" x, y;z  -\t- q"), std::vector<std::string>({"x", "y", "z", "-", "-", "q"}));
    QCOMPARE(io::columnNames("Z,Y,X").size(), std::size_t(3));
    for (const char* wrong : {"", "x,y", "x,y,z,q,q", "x,y,w"})
        QVERIFY_EXCEPTION_THROWN(io::columnNames(wrong), base::Error);
}

/// Whatever programs write: the preview's names bring the same model as opening alone.
void TextPreviewTest::previewsSayWhatOpeningTakes() {
    const test::Folder folder;
    for (const char* text : {"1 2 3\n4 5 7\n", "3\n1 2 3 10 20 30\n4 5 6 10 20 30\n7 8 8 1 2 3\n",
                             "x;y;z;q\n1,5;2,5;3,25;7\n2,5;2,5;3,25;7\n", "//X Y Z I\n1 2 3 4\n5 6 7 8\n",
                             "p,q,r\n1,2,3\n4,5,6\n", "name,x,y,z\na,1,2,3\nb,4,5,6\n"}) {
        const auto path = folder.write("a.txt", text);
        const auto preview = io::previewText(path);
        QVERIFY(preview);
        QCOMPARE(preview->sure, !test::contains(text, "p,q,r"));
        const FileModel alone = io::read(path), told = io::readColumns(path, preview->columns);
        QCOMPARE(told.points.size(), alone.points.size());
        QCOMPARE(told.points.layout->names(), alone.points.layout->names());
        for (std::size_t i = 0; i < alone.points.size(); ++i)
            QCOMPARE(told.points.items[i].position, alone.points.items[i].position);
    }
}

void TextPreviewTest::onlyTextHasAPreview() {
    const test::Folder folder;
    QVERIFY(!io::previewText(folder.path("none.xyz")) && !io::previewText(folder.path("")));
    QVERIFY(!io::previewText(folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")));
    QVERIFY(!io::previewText(folder.write("e.xyz", "")));
}

/// A count that the beginning alone does not reach is no fault of it, and half a line is no row.
void TextPreviewTest::longFilesAreSeenByTheirBeginning() {
    std::string text = "30000\n";
    for (int i = 0; i < 30000; ++i)
        text += std::to_string(i % 100) + ".25 " + std::to_string(i % 7) + " 3.5 200 100 50\n";
    const test::Folder folder;
    const auto preview = io::previewText(folder.write("a.pts", text));
    QVERIFY(preview && preview->sure && preview->messages.empty());
    QCOMPARE(preview->columns, std::vector<std::string>({"x", "y", "z", "red", "green", "blue"}));
    QVERIFY(preview->extent == base::Vec3d({99, 6, 0}));
}

static const test::Registered<TextPreviewTest> registered;
#include "text_preview_test.moc"
