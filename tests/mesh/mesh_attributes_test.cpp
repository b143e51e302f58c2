// What vertices take over from surfels, against plain loops in double with each weight.
#include "core/mesh/finish/mesh_attributes.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using mesh::Mesh;
using surface::Weight;

Q_DECLARE_METATYPE(surface::Weight)

class MeshAttributesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void colouredByTheWeightOfTheModel_data();
    void colouredByTheWeightOfTheModel();
    void farFromAllTheNearestCounts();
};

namespace {

/// Two sheets a spacing apart that face away from each other, with colours and masks drawn at random.
surfel::SurfelList sheets(base::Random& random) {
    surfel::SurfelList out = shapes::plates(10, 0.1, 0.35, 0.1);
    auto layout = std::make_shared<surfel::AttributeLayout>(*out.layout);
    layout->colours = layout->masks = true;
    out.layout = layout;
    for (surfel::Surfel& s : out.items) {
        s.colour = static_cast<surfel::Colour>(random.next());
        s.mask = static_cast<float>(random.uniform(0, 1));
    }
    return out;
}

/// mesh/README 5
double theta(Weight weight, double r) {
    const double t = 1 - r;
    if (r >= 1)
        return 0;
    if (weight == Weight::Gaussian)
        return std::pow(1e-8, r * r);
    return weight == Weight::Wendland ? std::pow(t, 4) * (4 * r + 1) : std::pow(t, 6) * (35 * r * r + 18 * r + 3) / 3;
}

} // namespace

void MeshAttributesTest::colouredByTheWeightOfTheModel_data() {
    QTest::addColumn<Weight>("weight");
    QTest::newRow("wendland") << Weight::Wendland;
    QTest::newRow("wendland-c4") << Weight::WendlandC4;
    QTest::newRow("gaussian") << Weight::Gaussian;
}

void MeshAttributesTest::colouredByTheWeightOfTheModel() {
    QFETCH(const Weight, weight);
    base::Random random(test::seed());
    const surfel::SurfelList list = sheets(random);
    surface::SurfaceDefinition definition;
    definition.weight = weight;
    Mesh mesh;
    for (int v = 0; v < test::effort(300); ++v) {
        const double side = v % 2 ? 1 : -1;
        mesh.positions.push_back({random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), 0.05 * side});
        mesh.normals.push_back({0, 0, static_cast<float>(side)});
    }
    mesh::takeAttributes(mesh, surface::Surface(tree::SurfelTree::build(list), definition));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        double total = 0, mask = 0, channels[4] = {};
        for (const surfel::Surfel& s : list.items) {
            const double away = distance(base::cast<double>(s.position), mesh.positions[v]);
            const double w = dot(s.normal, mesh.normals[v]) > 0 ? theta(weight, away / double(s.support)) : 0;
            total += w, mask += w * double(s.mask);
            for (int k = 0; k < 4; ++k)
                channels[k] += w * double(s.colour >> 8 * k & 255u);
        }
        const QString where = QString("vertex %1, seed %2").arg(v).arg(test::seed());
        QVERIFY2(std::abs(double(mesh.masks[v]) - mask / total) < 1e-4, qPrintable(where));
        for (int k = 0; k < 4; ++k)
            QVERIFY2(std::abs(double(mesh.colours[v] >> 8 * k & 255u) - channels[k] / total) < 0.51, qPrintable(where));
    }
}

void MeshAttributesTest::farFromAllTheNearestCounts() {
    base::Random random(test::seed());
    surfel::SurfelList list = sheets(random);
    list.items[7].position = {20, 0, 0};
    Mesh mesh;
    mesh.positions = {{25, 0, 0}};
    mesh.normals = {{0, 0, -1}};
    mesh::takeAttributes(mesh, surface::Surface(tree::SurfelTree::build(list), {}));
    QCOMPARE(mesh.colours[0], list.items[7].colour);
    QCOMPARE(mesh.masks[0], list.items[7].mask);
}

static const test::Registered<MeshAttributesTest> registered;
#include "mesh_attributes_test.moc"
