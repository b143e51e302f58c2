// E57 written: what is read from it again.
#include "io/io_support.h"
#include "support/registry.h"

class E57WriterTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void modelsComeBack();
    void manyPointsComeBack();
    void namesThatXmlMakesOneStayApart();
};

/// Whole numbers come back wider, other fields as they were.
void E57WriterTest::modelsComeBack() {
    base::Random random(test::seed());
    const test::Folder folder;
    const auto path = folder.path("a.e57");
    for (int round = 0; round < 40; ++round) {
        const io::FileModel model = test::randomModel(random, 1 + random.below(60));
        io::write(path, model);
        const io::FileModel back = io::read(path);
        QCOMPARE(back.points.size(), model.points.size());
        QCOMPARE(back.hasSupports, model.hasSupports);
        QCOMPARE(back.points.layout->attributes().size(), model.points.layout->attributes().size());
        const bool far = !(model.origin == base::Vec3d{});
        for (std::size_t i = 0; i < model.points.size(); ++i) {
            const surfel::Surfel &a = model.points.items[i], &b = back.points.items[i];
            const base::Vec3d was = base::cast<double>(a.position) + model.origin;
            QVERIFY(far || test::sameBits(a.position, b.position));
            QVERIFY(base::distance(was, base::cast<double>(b.position) + back.origin) <= 1e-6 * (1 + length(was)));
            QVERIFY(test::sameBits(a.normal, b.normal) && test::sameBits(a.support, b.support));
            QVERIFY(a.colour << 8 == b.colour << 8 && test::sameBits(a.mask, b.mask)); // without transparency
            for (const surfel::Attribute& attribute : model.points.layout->attributes()) {
                const surfel::Attribute* found = back.points.layout->find(attribute.name);
                QVERIFY2(found, attribute.name.c_str());
                QCOMPARE(surfel::read(*found, back.points.extraOf(i)),
                         surfel::read(attribute, model.points.extraOf(i)));
            }
        }
    }
}

/// Of several packets and pages, with names that E57 has of its own.
void E57WriterTest::manyPointsComeBack() {
    base::Random random(test::seed());
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->colours = true;
    layout->add("intensity", surfel::ScalarType::UInt16);
    layout->add("row", surfel::ScalarType::Int32);
    layout->add("time", surfel::ScalarType::Float64);
    layout->add("a b/c", surfel::ScalarType::Int8);
    model.points.layout = layout;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        surfel::Surfel s;
        s.position = base::cast<float>(random.unitVector());
        s.colour = surfel::rgba(i & 255, i >> 8, 7);
        std::vector<std::uint32_t> words(layout->words());
        for (const surfel::Attribute& attribute : layout->attributes())
            surfel::write(attribute, words, static_cast<double>(i % 250) - (attribute.name == "intensity" ? 0 : 120));
        model.points.append(s, words);
    }
    const test::Folder folder;
    io::write(folder.path("a.e57"), model);
    QCOMPARE(std::filesystem::file_size(folder.path("a.e57")) % 1024, std::uintmax_t(0));
    const io::FileModel back = io::read(folder.path("a.e57"));
    QCOMPARE(back.points.size(), model.points.size());
    const char* const names[] = {"intensity", "row", "time", "a_b_c"};
    for (std::size_t i = 0; i < model.points.size(); ++i) {
        QVERIFY(test::sameBits(back.points.items[i].position, model.points.items[i].position));
        QCOMPARE(back.points.items[i].colour, model.points.items[i].colour);
        for (std::size_t k = 0; k < 4; ++k)
            QCOMPARE(surfel::read(*back.points.layout->find(names[k]), back.points.extraOf(i)),
                     surfel::read(layout->attributes()[k], model.points.extraOf(i)));
    }
}

/// Readers know columns by their names without prefixes.
void E57WriterTest::namesThatXmlMakesOneStayApart() {
    const char* const names[] = {"dist+", "dist*", "time", "timeStamp"};
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    for (const char* name : names)
        layout->add(name, surfel::ScalarType::Float32);
    model.points.layout = layout;
    for (int i = 0; i < 5; ++i) {
        surfel::Surfel s;
        s.position.x = static_cast<float>(i);
        std::vector<std::uint32_t> words(layout->words());
        for (std::size_t k = 0; k < 4; ++k)
            surfel::write(layout->attributes()[k], words, static_cast<double>(10 * i) + static_cast<double>(k));
        model.points.append(s, words);
    }
    const test::Folder folder;
    io::write(folder.path("a.e57"), model);
    const io::FileModel back = io::read(folder.path("a.e57"));
    QCOMPARE(back.points.layout->attributes().size(), std::size_t(4));
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            QCOMPARE(surfel::read(back.points.layout->attributes()[k], back.points.extraOf(i)),
                     static_cast<double>(10 * i + k));
}

static const test::Registered<E57WriterTest> registered;
#include "e57_writer_test.moc"
