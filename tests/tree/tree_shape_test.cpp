#include "core/tree/tree_shape.h"

#include "support/registry.h"
#include "tree/random_edits.h"

#include <QTest>

using namespace tree;

class TreeShapeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void listAndShapeBringBackTheTree_data();
    void listAndShapeBringBackTheTree();
    void theEmptyTreeHasNoShape();
    void otherSurfelsAreBuiltAnew();
    void noClaimMakesABrokenTree();
};

static QString round(int k) {
    return QString("round %1, seed %2").arg(k).arg(test::seed());
}

void TreeShapeTest::listAndShapeBringBackTheTree_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("one block") << 20;
    QTest::newRow("one level") << 500;
    QTest::newRow("three levels") << 20000;
}

void TreeShapeTest::listAndShapeBringBackTheTree() {
    QFETCH(int, count);
    test::EditedModel model(static_cast<std::size_t>(count), test::seed());
    bool differs = false;
    for (int k = 0; k < test::effort(60); ++k) {
        const SurfelTree& tree = model.tree();
        if (!tree.empty()) {
            const SurfelTree again = SurfelTree::build(tree.surfels(), tree.shape());
            again.validate();
            QVERIFY2(test::sameStructure(tree, again), qPrintable(round(k)));
            QVERIFY2(again.shape() == tree.shape(), qPrintable(round(k)));
            differs |= !test::sameStructure(tree, SurfelTree::build(tree.surfels()));
        }
        model.apply(model.randomEdit());
    }
    QVERIFY2(differs || count < 100, "a history of edits is seen in the tree, or this shows nothing");
}

void TreeShapeTest::theEmptyTreeHasNoShape() {
    QVERIFY(SurfelTree().shape().empty());
    QVERIFY(SurfelTree::build({}, TreeShape()).empty());
}

void TreeShapeTest::otherSurfelsAreBuiltAnew() {
    base::Random random(test::seed());
    test::EditedModel model(3000, test::seed());
    for (int k = 0; k < 10; ++k)
        model.apply(model.randomEdit());
    const TreeShape shape = model.tree().shape();
    for (int k = 0; k < 20; ++k) {
        surfel::SurfelList other = model.tree().surfels();
        const std::size_t i = random.below(other.size());
        switch (k % 5) {
        case 0:
            other.items[i].position.x += 0.01f;
            break;
        case 1:
            other.items.pop_back(), other.extra.pop_back();
            break;
        case 2:
            other.items[i].support *= 2;
            break;
        case 3:
            other.extra[i] += 1;
            break;
        default: // surfels of other blocks
            std::swap(other.items.front(), other.items.back());
            std::swap(other.extra.front(), other.extra.back());
        }
        const SurfelTree built = SurfelTree::build(other, shape);
        QVERIFY2(test::sameStructure(built, SurfelTree::build(other)), qPrintable(round(k)));
    }
}

/// Numbers as a damaged file may hold them, also such that the check agrees with.
void TreeShapeTest::noClaimMakesABrokenTree() {
    base::Random random(test::seed());
    const surfel::SurfelList list = test::bumpySphere(900, random);
    const SurfelTree plain = SurfelTree::build(list);
    const surfel::SurfelList inOrder = plain.surfels();
    int taken = 0;
    for (int k = 0; k < test::effort(2000); ++k) {
        TreeShape claim = plain.shape();
        std::vector<std::uint8_t>& numbers = random.below(2) == 0 ? claim.blocks : claim.nodes;
        for (std::size_t n = random.below(3) + 1; n > 0 && !numbers.empty(); --n) {
            const std::size_t i = random.below(numbers.size());
            switch (random.below(4)) {
            case 0:
                numbers[i] = static_cast<std::uint8_t>(random.below(256));
                break;
            case 1:
                numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(i));
                break;
            case 2:
                numbers.insert(numbers.begin() + static_cast<std::ptrdiff_t>(i), static_cast<std::uint8_t>(n));
                break;
            default:
                std::swap(numbers[i], numbers[random.below(numbers.size())]);
            }
        }
        const SurfelTree built = SurfelTree::build(inOrder, claim);
        built.validate();
        QVERIFY2(built.contentHash() == plain.contentHash(), qPrintable(round(k)));
        taken += built.shape() == claim ? 1 : 0;
    }
    QVERIFY2(taken > 0, "some claims about nodes alone are as good as ours");
}

static const test::Registered<TreeShapeTest> registered;
#include "tree_shape_test.moc"
