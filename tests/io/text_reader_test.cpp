// Points as text in every custom that the programs of the field have.
#include "core/base/parallel.h"
#include "io/io_support.h"
#include "support/registry.h"
#include "support/threads.h"

using io::FileModel;

class TextReaderTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void delimitersAndCommentsAreUnderstood_data();
    void delimitersAndCommentsAreUnderstood();
    void columnsTellWhatTheyAre_data();
    void columnsTellWhatTheyAre();
    void namesOfColumnsAreBelieved();
    void queryTablesKeepNumbersAndLeaveOutWords();
    void wordsMayComeBeforeTheNumbers();
    void decimalCommasAreReadAndTold_data();
    void decimalCommasAreReadAndTold();
    void commasForPointsAndBetweenFieldsAreRefused_data();
    void commasForPointsAndBetweenFieldsAreRefused();
    void commasThatPartFieldsStaySeparators_data();
    void commasThatPartFieldsStaySeparators();
    void countsBeforeScansAreNoPoints();
    void countsThatAreNotThePointsAreTold();
    void oldPwnHasItsNormalsBelow();
    void wholeNumbersAndTimesKeepTheirValue();
    void damagedFilesAreRefusedInOneSentence_data();
    void damagedFilesAreRefusedInOneSentence();
    void writtenTextReadsTheSame_data();
    void writtenTextReadsTheSame();
    void longTextIsTheSameAtAnyThreadCount();
};

static FileModel readText(const std::string& name, const std::string& content) {
    const test::Folder folder;
    return io::read(folder.write(name, content));
}

void TextReaderTest::delimitersAndCommentsAreUnderstood_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("Fortran exponents") << "1.0D+00 2d0 0.03D+2\n400D-2 5.D0 6\n";
    QTest::newRow("blanks") << "1 2 3\n4 5 6\n";
    QTest::newRow("no last line end") << "1 2 3\n4 5 6";
    QTest::newRow("tabs and leading blanks") << "\t1\t2\t3\n  4  5  6  \n";
    QTest::newRow("commas") << "1,2,3\n4,5,6\n";
    QTest::newRow("commas and blanks") << "1, 2, 3,\n4 , 5 , 6\n";
    QTest::newRow("semicolons") << "1;2;3\n4;5;6\n";
    QTest::newRow("CRLF") << "1 2 3\r\n4 5 6\r\n";
    QTest::newRow("CR") << "1 2 3\r4 5 6\r";
    QTest::newRow("comments") << "# scan\n// more\n1 2 3 # first\n\n% other\n4 5 6\n";
    QTest::newRow("byte order mark") << QString::fromUtf8("\xef\xbb\xbf"
                                                          "1 2 3\n4 5 6\n");
    QTest::newRow("count") << "2\n1 2 3\n4 5 6\n";
    QTest::newRow("names") << "x y z\n1 2 3\n4 5 6\n";
    QTest::newRow("count and names") << "2\nX Y Z\n1 2 3\n4 5 6\n";
    QTest::newRow("names in a comment") << "//X Y Z\n1 2 3\n4 5 6\n";
    QTest::newRow("quoted names") << "\"x\",\"y\",\"z\"\n1,2,3\n4,5,6\n";
    QTest::newRow("quoted numbers") << "\"x\",\"y\",\"z\"\n\"1\",\" 2 \",3\n\"4.0\", \"5\" ,\"6e0\"\n";
    QTest::newRow("quoted numbers without names") << "\"1\";\"2\";\"3\"\n\"4\";\"5\";\"6\"\n";
    QTest::newRow("names in other order") << "z,y,x\n3,2,1\n6,5,4\n";
}

void TextReaderTest::delimitersAndCommentsAreUnderstood() {
    QFETCH(QString, text);
    for (const char* name : {"a.xyz", "a.txt", "a.csv", "a.asc", "a.pts", "a.pwn", "unknown"}) {
        const FileModel model = readText(name, text.toStdString());
        QCOMPARE(model.points.size(), std::size_t(2));
        QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
        QCOMPARE(model.points.items[1].position, base::Vec3f({4, 5, 6}));
        QVERIFY(model.points.layout->attributes().empty() && model.messages.empty());
    }
}

void TextReaderTest::columnsTellWhatTheyAre_data() {
    QTest::addColumn<QString>("rows");
    QTest::addColumn<QString>("names");
    QTest::newRow("intensity") << "1 2 3 0.5\n4 5 6 0.7\n"
                               << "position intensity";
    QTest::newRow("two more") << "1 2 3 0.5 7\n4 5 6 0.7 8\n"
                              << "position column_4 column_5";
    QTest::newRow("normals") << "1 2 3 0 0.6 0.8\n4 5 6 0 -1 0\n"
                             << "position normal";
    QTest::newRow("whole normals") << "1 2 3 0 0 1\n4 5 6 0 0 1\n"
                                   << "position normal";
    QTest::newRow("colours") << "1 2 3 10 20 255\n4 5 6 0 0 0\n"
                             << "position colour";
    QTest::newRow("share colours") << "1 2 3 0.1 0.2 1\n4 5 6 0.5 0 0\n"
                                   << "position colour";
    QTest::newRow("velocities") << "1 2 3 -5 2.5 300\n4 5 6 0 7 1\n"
                                << "position column_4 column_5 column_6";
    QTest::newRow("Leica") << "1 2 3 -1000 1 2 3\n4 5 6 -900 4 5 6\n"
                           << "position colour intensity";
    QTest::newRow("Leica, byte intensity") << "1 2 3 100 1 2 3\n4 5 6 90 4 5 6\n"
                                           << "position colour intensity";
    QTest::newRow("colours, intensity") << "1 2 3 1 2 3 0.5\n4 5 6 4 5 6 -7\n"
                                        << "position colour intensity";
    QTest::newRow("colours, normals") << "1 2 3 1 2 3 0 0 1\n4 5 6 4 5 6 1 0 0\n"
                                      << "position normal colour";
    QTest::newRow("normals, colours") << "1 2 3 0 0 1 1 2 3\n4 5 6 1 0 0 4 5 6\n"
                                      << "position normal colour";
}

void TextReaderTest::columnsTellWhatTheyAre() {
    QFETCH(QString, rows);
    QFETCH(QString, names);
    QString found;
    const FileModel model = readText("a.txt", rows.toStdString());
    for (const std::string& name : model.points.layout->names())
        found += (found.isEmpty() ? "" : " ") + QString::fromStdString(name);
    QCOMPARE(found, names);
    if (names.contains("colour"))
        QVERIFY(model.points.items[0].colour != model.points.items[1].colour);
    if (names.contains("normal"))
        QVERIFY(std::abs(base::length(model.points.items[0].normal) - 1) < 1e-6f);
}

void TextReaderTest::namesOfColumnsAreBelieved() {
    const FileModel model = readText("a.csv", "id;X;Y;Z;Red;Green;Blue;GPS Time\n7;1;2;3;10;20;30;123456789.125\n");
    QCOMPARE(model.points.layout->names(), std::vector<std::string>({"position", "colour", "id", "GPS_Time"}));
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QCOMPARE(model.points.items[0].colour, surfel::rgba(10, 20, 30));
    const FileModel unknown = readText("a.csv", "left,right,other\n1,2,3\n");
    QCOMPARE(unknown.points.items[0].position, base::Vec3f({1, 2, 3}));
    QVERIFY(test::anyContains(unknown.messages, "first three"));
}

void TextReaderTest::queryTablesKeepNumbersAndLeaveOutWords() {
    const FileModel model = readText("q.csv", "x,y,z,status,f,nx,ny,nz\n0,1,2,ok,0.25,0,0,1\n3,4,5,outside,,,,\n");
    QCOMPARE(model.points.size(), std::size_t(2));
    QCOMPARE(model.points.layout->names(), std::vector<std::string>({"position", "normal", "f"}));
    QCOMPARE(surfel::read(model.points.layout->attributes()[0], model.points.extraOf(0)), 0.25);
    QVERIFY(std::isnan(surfel::read(model.points.layout->attributes()[0], model.points.extraOf(1))));
    QCOMPARE(model.points.items[0].normal, base::Vec3f({0, 0, 1}));
    QCOMPARE(model.points.items[1].normal, base::Vec3f());
    QVERIFY(test::anyContains(model.messages, "'status'"));
}

void TextReaderTest::wordsMayComeBeforeTheNumbers() {
    const FileModel model = readText("w.csv", "name,x,y,z,height\np1,0,1,2,7\np2,3,4,5,8\np3,6,7,9,9\n");
    QCOMPARE(model.points.size(), std::size_t(3));
    QCOMPARE(model.points.items[0].position, base::Vec3f({0, 1, 2}));
    QCOMPARE(model.points.layout->names(), std::vector<std::string>({"position", "height"}));
    QVERIFY(test::anyContains(model.messages, "'name'"));
}

void TextReaderTest::decimalCommasAreReadAndTold_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("semicolons") << "1,5;2,5;3,25\n4;-5,5;6e1\n";
    QTest::newRow("blanks") << "1,5 2,5 3,25\n4 -5,5 6,0e1\n";
    QTest::newRow("tabs, names") << "x\ty\tz\n1,5\t2,5\t3,25\n4,0\t-5,5\t60\n";
    QTest::newRow("names") << "x;y;z\r\n1,5;2,5;3,25\r\n4,0;-5,5;60\r\n";
    QTest::newRow("first row whole") << "x;z;y\n4;60;-5,5\n1,5;3,25;2,5\n";
    QTest::newRow("count") << "2\n1,5 2,5 3,25\n4 -5,5 60\n";
}

void TextReaderTest::decimalCommasAreReadAndTold() {
    QFETCH(QString, text);
    const FileModel model = readText("a.csv", text.toStdString());
    QCOMPARE(model.points.size(), std::size_t(2));
    const bool turned = text.startsWith("x;z");
    QCOMPARE(model.points.items[turned ? 1 : 0].position, base::Vec3f({1.5f, 2.5f, 3.25f}));
    QCOMPARE(model.points.items[turned ? 0 : 1].position, base::Vec3f({4, -5.5f, 60}));
    QVERIFY(model.points.layout->attributes().empty());
    QVERIFY(test::anyContains(model.messages, "decimal commas"));
}

void TextReaderTest::commasForPointsAndBetweenFieldsAreRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("four digits") << "20,2236,20,0000,1,5000\n-3,1250,7,1234,0,9999\n";
    QTest::newRow("blanks, too") << "20,2236, 20,0000, 1,5000\n-3,1250, 7,1234, 0,9999\n";
    QTest::newRow("normals") << "20,22,20,05,1,50,0,00,0,00,1,00\n";
    QTest::newRow("names") << "x,y,z\n20,2236,20,5,1,75\n";
    QTest::newRow("late") << QString("20,22,20,15,1,50\n").repeated(99) + "20,22,20,05,1,50\n";
}

void TextReaderTest::commasForPointsAndBetweenFieldsAreRefused() {
    QFETCH(QString, text);
    const test::Folder folder;
    const std::string told = test::refusal(folder.write("a.csv", text.toStdString()));
    QVERIFY2(test::contains(told, "'20,22") && test::contains(told, "semicolons"), told.c_str());
}

void TextReaderTest::commasThatPartFieldsStaySeparators_data() {
    QTest::addColumn<QString>("row");
    // Colours of three digits, ids with zeros, and names for all of six fields are what they seem.
    for (const char* row : {"1,2,3,255,128,100", "1,2,3,255,007,100", "1,2,3,040,5,060", "1,2,3,4,5,06",
                            "1.0,2,3,04,5,06", "1,2,3,4,5,6", "1, 2, 3, 4, 5, 6", "1 ,2 ,3 ,4 ,5 ,6", "1,2,3 4,5,6",
                            "1,2,3;4,5,6", "1,2 3,4,5 6,", "1;2;3;4;5;6", "1,2,3,4 5 6"})
        QTest::newRow(row) << row;
}

void TextReaderTest::commasThatPartFieldsStaySeparators() {
    QFETCH(QString, row);
    const FileModel model = readText("a.csv", row.toStdString() + "\n" + row.toStdString() + "\n");
    QCOMPARE(model.points.items[0].position, base::Vec3f({1, 2, 3}));
    QVERIFY(model.messages.empty() && model.points.layout->names().size() > 1);
}

void TextReaderTest::countsBeforeScansAreNoPoints() {
    const FileModel model = readText("a.pts", "2\n1 2 3\n4 5 6\n1\n7 8 9\n");
    QCOMPARE(model.points.size(), std::size_t(3));
    QCOMPARE(model.points.items[2].position, base::Vec3f({7, 8, 9}));
    QVERIFY(model.messages.empty());
}

void TextReaderTest::countsThatAreNotThePointsAreTold() {
    for (const auto& [text, told] : {std::pair{"2\n1 2 3\n4 5 6\n7 8 9\n", "counts 2 points but holds 3"},
                                     {"1\n1 2 3\n4 5 6\n1\n7 8 9\n", "counts 2 points but holds 3"},
                                     {"2\n1 2 3\n4 5 6\n2 # here\n7 8 9\n", "counts 4 points but holds 3"},
                                     {"0\n1 2 3\n99999999999999999999\n1 2 4\n", "counts "}}) {
        const FileModel model = readText("a.pts", text);
        QCOMPARE(model.messages.size(), std::size_t(1));
        QVERIFY2(model.messages[0].find(told) != std::string::npos, model.messages[0].c_str());
    }
}

void TextReaderTest::oldPwnHasItsNormalsBelow() {
    const FileModel model = readText("a.pwn", "2\n1 2 3\n4 5 6\n0 0 1\n0 1 0\n");
    QCOMPARE(model.points.size(), std::size_t(2));
    QVERIFY(model.points.layout->normals);
    QCOMPARE(model.points.items[1].position, base::Vec3f({4, 5, 6}));
    QCOMPARE(model.points.items[1].normal, base::Vec3f({0, 1, 0}));
}

void TextReaderTest::wholeNumbersAndTimesKeepTheirValue() {
    const FileModel model = readText("a.txt", "1 2 3 2147483647 123456789.125\n1 2 4 -5 123456790.5\n");
    const auto& attributes = model.points.layout->attributes();
    QVERIFY(attributes[0].type == surfel::ScalarType::Int32);
    QVERIFY(attributes[1].type == surfel::ScalarType::Float64);
    const FileModel large = readText("a.txt", "1 2 3 4294967295 -4294967295\n1 2 4 0 123456789\n");
    QVERIFY(large.points.layout->attributes()[0].type == surfel::ScalarType::UInt32);
    QVERIFY(large.points.layout->attributes()[1].type == surfel::ScalarType::Float64);
    QCOMPARE(surfel::read(attributes[0], model.points.extraOf(0)), 2147483647.0);
    QCOMPARE(surfel::read(attributes[1], model.points.extraOf(0)), 123456789.125);
}

void TextReaderTest::damagedFilesAreRefusedInOneSentence_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("part");
    QTest::newRow("blank") << QByteArray("\n \n\t\n") << "holds no points";
    QTest::newRow("comments only") << QByteArray("# x y z\n# nothing\n") << "holds no points";
    QTest::newRow("count only") << QByteArray("5\n") << "holds no points";
    QTest::newRow("counts only") << QByteArray("0\n1\n2\n") << "only lines of one number";
    QTest::newRow("counts and names only") << QByteArray("0\nx y z\n1\n") << "only lines of one number";
    QTest::newRow("names only") << QByteArray("x y z\n") << "holds no points";
    QTest::newRow("two columns") << QByteArray("1 2\n3 4\n") << "x, y and z";
    QTest::newRow("two columns with names")
        << QByteArray("x y\n1 2\n3 4\n") << "line 2: holds 2 columns where x, y and z";
    QTest::newRow("prose") << QByteArray("It was a dark night.\nAnd stormy it was too.\nSo there.\n")
                           << "is not a number";
    QTest::newRow("binary") << QByteArray("1 2 3\n\0\1\2", 9) << "is binary";
    QTest::newRow("Expe") << QByteArray("[Expe/PointSet/Binary/0.1]\nproperty") << "Expe";
    QTest::newRow("one value") << QByteArray("1 2 3\n4 5 6\n7\n") << "line 3: holds 1 value where 3";
    QTest::newRow("short row") << QByteArray("1 2 3\n4 5 6\n7 8\n") << "line 3: holds 2 values where 3";
    QTest::newRow("long row") << QByteArray("1 2 3\n4 5 6 7\n") << "line 2: holds more than the 3";
    QTest::newRow("word") << QByteArray("1 2 3\n4 five 6\n") << "line 2: 'five' is not a number";
    QTest::newRow("cut off") << QByteArray("4000000000\n1 2 3\n") << "promises 4000000000 points, but 1 follow";
    QTest::newRow("wide first row") << QByteArray(2000, '1').replace("1", "1 ").append("\n2\n") << "1000 columns";
    QTest::newRow("wide names")
        << QByteArray("x y z ").append(QByteArray(900, 'a').replace("a", "a ")).append("\n1 2 3\n") << "values";
    QTest::newRow("only nan") << QByteArray("nan nan nan\ninf 0 0\n") << "no finite points";
    QTest::newRow("thousands") << QByteArray("1,234.5;2,000.0;3\n") << "'1,234.5' holds separators of thousands";
    QTest::newRow("thousands of millions") << QByteArray("1,234,567;2;3\n") << "'1,234,567' holds separators";
    QTest::newRow("points for thousands") << QByteArray("x;y;z\n1.234,5;2,0;3,0\n") << "line 2: '1.234,5' holds";
    QTest::newRow("blanks for thousands") << QByteArray("x,y,z\n1 000,2,3\n") << "'1 000' holds separators";
    QTest::newRow("UTF-16") << QByteArray("\xff\xfe"
                                          "1\0 \0",
                                          6)
                            << "UTF-16";
    QTest::newRow("UTF-16, other order") << QByteArray("\xfe\xff\0"
                                                       "1\0 ",
                                                       6)
                                         << "UTF-16";
    QTest::newRow("LAS") << QByteArray("LASF\0\0\0\0", 8) << "LAS";
}

void TextReaderTest::damagedFilesAreRefusedInOneSentence() {
    QFETCH(QByteArray, content);
    QFETCH(QString, part);
    const test::Folder folder;
    const auto path = folder.write("a.txt", content.toStdString());
    const std::string message = test::refusal(path);
    QVERIFY2(test::contains(message, part.toStdString()), message.c_str());
    QVERIFY2(test::contains(message, path.string()), message.c_str());
    QVERIFY2(!test::contains(message, "\n") && message.size() < path.string().size() + 250, message.c_str());
}

void TextReaderTest::writtenTextReadsTheSame_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.xyz", "a.txt", "a.asc", "a.csv", "a.pts", "a.pwn", "a.obj"})
        QTest::newRow(name) << name;
}

/// Text does not tell whether reals were doubles; small ones come back as floats.
static bool sameInText(double written, double read) {
    return read == written || read == static_cast<double>(static_cast<float>(written));
}

/// Float positions, normals and colours come back to the bit; the formats with names bring back everything.
void TextReaderTest::writtenTextReadsTheSame() {
    QFETCH(QString, name);
    const test::Folder folder;
    base::Random random(test::seed());
    const bool named = name == "a.csv" || name == "a.txt" || name == "a.asc";
    for (int k = 0; k < 40; ++k) {
        FileModel model = test::randomModel(random, 20 + random.below(200));
        model.origin = {};
        const auto path = folder.path(name.toStdString());
        io::write(path, model);
        const FileModel read = io::read(path);
        const QString where = QString("round %1, seed %2").arg(k).arg(test::seed());
        QVERIFY2(read.points.size() == model.points.size(), qPrintable(where));
        const auto& layout = *read.points.layout;
        const bool keepsNormals = name != "a.pts", keepsColours = name != "a.pwn";
        QVERIFY2(layout.normals == (model.points.layout->normals && keepsNormals), qPrintable(where));
        QVERIFY2(layout.colours == (model.points.layout->colours && keepsColours), qPrintable(where));
        for (std::size_t i = 0; i < read.points.size(); ++i) {
            const surfel::Surfel &a = model.points.items[i], &b = read.points.items[i];
            QVERIFY2(test::sameBits(a.position, b.position), qPrintable(where));
            QVERIFY2(!layout.normals || test::sameBits(a.normal, b.normal), qPrintable(where));
            QVERIFY2(!layout.colours || (a.colour & 0xffffff) == (b.colour & 0xffffff), qPrintable(where));
            QVERIFY2(!named || (test::sameBits(a.mask, b.mask) && test::sameBits(a.support, b.support)),
                     qPrintable(where));
            for (const surfel::Attribute& attribute : model.points.layout->attributes())
                QVERIFY2(!named || sameInText(surfel::read(attribute, model.points.extraOf(i)),
                                              surfel::read(*layout.find(attribute.name), read.points.extraOf(i))),
                         qPrintable(where));
        }
    }
}

void TextReaderTest::longTextIsTheSameAtAnyThreadCount() {
    const test::Folder folder;
    base::Random random(test::seed());
    std::string text;
    for (int i = 0; i < 100000; ++i) { // some megabytes: several chunks
        text += std::to_string(random.uniform()) + " " + std::to_string(i) + "\t" + std::to_string(i % 7) + "\r\n";
        if (random.below(50) == 0)
            text += "\n   \n# between\n";
    }
    const auto path = folder.write("a.xyz", text);
    const auto work = [&] { return io::read(path); };
    const FileModel one = test::onThreads(1, work), all = work();
    QCOMPARE(one.points.size(), std::size_t(100000));
    for (std::size_t i = 0; i < one.points.size(); ++i)
        QCOMPARE(one.points.items[i].position.y + float(one.origin.y), float(i));
    QVERIFY(test::sameBits(one, all));
    // The first of two faults is named, whichever chunk is parsed first.
    const std::size_t early = text.find("\r\n", text.size() / 3), late = text.find("\r\n", text.size() / 2);
    text.replace(late, 1, "x").replace(early, 1, "x");
    base::setThreadCount(0);
    const std::string message = test::refusal(folder.write("a.xyz", text));
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(early), '\n') + 1;
    QVERIFY2(test::contains(message, "line " + std::to_string(line) + ":"), message.c_str());
}

static const test::Registered<TextReaderTest> registered;
#include "text_reader_test.moc"
