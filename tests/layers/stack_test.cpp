// The list of layers, and its lines in files.
#include "core/layers/stack.h"
#include "support/registry.h"

#include <QTest>

class StackTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void linesBringTheStackBack();
    void otherLinesStay();
    void idsAreNeverUsedTwiceInOneStack();
};

void StackTest::linesBringTheStackBack() {
    layers::Stack stack;
    for (const char* name : {"Wrinkles and pores", "F\xc3\xa4ltchen", "a"})
        stack.add(name);
    stack.layers[0].strength = 0.1f;
    stack.layers[1].strength = -1;
    stack.layers[1].visible = false;
    std::swap(stack.layers[0], stack.layers[2]);
    for (const std::uint32_t active : {0u, 1u, 3u}) {
        stack.active = active;
        std::vector<std::string> lines = layers::linesOf(stack);
        lines.insert(lines.begin() + 1, "made with love");
        QVERIFY(layers::takeLines(lines) == stack);
        QCOMPARE(lines, std::vector<std::string>{"made with love"});
    }
}

void StackTest::otherLinesStay() {
    const std::string good = "pointclay-layer 1 strength 1 visible 1 active 0 name x";
    for (const char* line : {"pointclay-layer", "pointclay-layer 0 strength 1 visible 1 active 0 name y",
                             "pointclay-layer 2 strength 3 visible 1 active 0 name y",
                             "pointclay-layer 2 strength nan visible 1 active 0 name y",
                             "pointclay-layer 2 strength 1 visible 2 active 0 name y",
                             "pointclay-layer 2 strength 1 visible 1 active 0 name ",
                             "pointclay-layer 2 strength 1 visible 1 active 0 name x", // taken
                             "pointclay-layer 1 strength 1 visible 1 active 0 name y",
                             "pointclay-layer 4294967295 strength 1 visible 1 active 0 name y"}) {
        std::vector<std::string> lines{good, line};
        QCOMPARE(layers::takeLines(lines).layers.size(), std::size_t(1));
        QCOMPARE(lines, std::vector<std::string>{line});
    }
}

void StackTest::idsAreNeverUsedTwiceInOneStack() {
    layers::Stack stack;
    stack.add("a"), stack.add("b"), stack.add("c");
    stack.layers.erase(stack.layers.begin());
    const std::uint32_t fresh = stack.add("d").id;
    QVERIFY(fresh != stack.layers[0].id && fresh != stack.layers[1].id);
    QCOMPARE(stack.target(), 2);
    QCOMPARE(stack.indexOf("d"), 2);
    stack.active = 0;
    QCOMPARE(stack.target(), -1);
}

static const test::Registered<StackTest> registered;
#include "stack_test.moc"
