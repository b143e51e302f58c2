// The fit's parts: one row against the product's surface and against differences, the solver against a dense one.
#include "core/reduce/fit_row.h"
#include "core/surfel/shape.h"

#include "core/base/random.h"
#include "core/surface/surface.h"
#include "support/registry.h"

#include <Eigen/Dense>
#include <numbers>
#include <QTest>

using namespace reduce;
using base::Vec3d;

class FitTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aRowIsTheValueOverTheGradientOfTheSurface();
    void derivativesAreThoseOfTheRow();
    void theSolutionIsThatOfADenseSolver();
    void aLargeRidgeKeepsEverythingWhereItBegan();
};

namespace {

constexpr int unknowns = unknownsOfEllipsoids;

/// Samples of a bent sheet around the origin, at random, with normals and heights that are off a little.
std::vector<FitSite> bentSheet(base::Random& random, int count) {
    std::vector<FitSite> out(static_cast<std::size_t>(count));
    for (FitSite& s : out) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        s.start = {x, y, 0.2 * (x * x - 0.5 * y * y) + random.uniform(-0.02, 0.02)};
        s.normal0 = normalized(Vec3d{-0.4 * x, 0.2 * y, 1} + random.unitVector() * 0.1);
        s.along[0] = perpendicular(s.normal0);
        s.along[1] = cross(s.normal0, s.along[0]);
        s.setShape((s.along[0] * random.uniform(-1.5, 1.5) + s.along[1] * random.uniform(-1.5, 1.5)),
                   random.uniform(1.1, 1.8));
        for (double& each : s.x)
            each = random.uniform(-0.02, 0.02);
    }
    return out;
}

struct Row {
    FitRow row;
    std::vector<std::array<float, mostUnknowns>> d;
};
Row rowOf(const std::vector<FitSite>& sites, const Vec3d& place, bool oriented = true) {
    Row out;
    out.d.resize(sites.size());
    std::vector<FitTerm> terms;
    for (std::size_t i = 0; i < sites.size(); ++i)
        terms.push_back({&sites[i], &out.d[i], {}, {}});
    out.row = fitRow(place, {0, 0, 1}, oriented, terms);
    return out;
}

} // namespace

void FitTest::aRowIsTheValueOverTheGradientOfTheSurface() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(100); ++k) {
        const std::vector<FitSite> sites = bentSheet(random, 25);
        surfel::SurfelList list;
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        surfel::addShape(*layout);
        list.layout = layout;
        for (const FitSite& s : sites) {
            surfel::Surfel each;
            each.position = base::cast<float>(s.position());
            each.normal = base::cast<float>(normalized(s.tilted()));
            each.support = static_cast<float>(s.reach());
            std::vector<std::uint32_t> words(3);
            surfel::putShape(words, 0, base::cast<float>(s.shape()));
            list.append(each, words);
        }
        const surface::Surface surface(tree::SurfelTree::build(list), {});
        const Vec3d place{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.03, 0.03)};
        const auto e = surface.evaluateReference(place);
        const FitRow row = rowOf(sites, place).row;
        QVERIFY(e.ok() && row.valid);
        const double expected = e.value / length(e.gradient);
        QVERIFY2(std::abs(row.residual - expected) < 1e-6,
                 qPrintable(QString("seed %1: %2 for %3").arg(test::seed()).arg(row.residual).arg(expected)));
    }
}

void FitTest::derivativesAreThoseOfTheRow() {
    base::Random random(test::seed() + 1);
    for (int k = 0; k < test::effort(50); ++k) {
        std::vector<FitSite> sites = bentSheet(random, 20);
        const bool oriented = k % 2 == 0;
        const Vec3d place{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.005, 0.005)};
        const Row row = rowOf(sites, place, oriented);
        QVERIFY(row.row.valid);
        for (std::size_t i = 0; i < sites.size(); ++i)
            for (std::size_t u = 0; u < unknowns; ++u) {
                constexpr double step = 1e-5;
                const double kept = sites[i].x[u];
                sites[i].x[u] = kept + step;
                const double more = rowOf(sites, place, oriented).row.residual;
                sites[i].x[u] = kept - step;
                const double less = rowOf(sites, place, oriented).row.residual;
                sites[i].x[u] = kept;
                // The gradient's length counts as constant: Gauss-Newton leaves f times its change out.
                const double allowed = 1e-5 + 2 * std::abs(row.row.residual);
                const double differs = std::abs((more - less) / (2 * step) - double(row.d[i][u]));
                QVERIFY2(differs < allowed, qPrintable(QString("seed %1, unknown %2: %3 by differences, %4")
                                                           .arg(test::seed())
                                                           .arg(u)
                                                           .arg((more - less) / (2 * step))
                                                           .arg(double(row.d[i][u]))));
            }
    }
}

namespace {

/// Rows with a few random entries each, in pieces of different sizes.
std::vector<FitPiece<unknowns>> randomPieces(base::Random& random, std::size_t sites, Eigen::MatrixXd& a,
                                             Eigen::VectorXd& r) {
    std::vector<FitPiece<unknowns>> out(5);
    const Eigen::Index rows = 5 * 40;
    a = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(sites * unknowns));
    r = Eigen::VectorXd::Zero(rows);
    Eigen::Index at = 0;
    for (FitPiece<unknowns>& piece : out) {
        piece.begin = static_cast<std::size_t>(at);
        for (std::uint32_t s = 0; s < sites; ++s)
            if (random.uniform() < 0.6)
                piece.sites.push_back(s);
        for (int k = 0; k < 40; ++k, ++at) {
            std::vector<std::array<float, mostUnknowns>> row;
            for (std::uint32_t s = 0; s < piece.sites.size(); ++s) {
                if (random.uniform() > 0.3)
                    continue;
                std::array<float, mostUnknowns> d;
                for (int u = 0; u < unknowns; ++u) {
                    d[static_cast<std::size_t>(u)] = static_cast<float>(random.uniform(-1, 1));
                    a(at, static_cast<Eigen::Index>(piece.sites[s]) * unknowns + u) =
                        double(d[static_cast<std::size_t>(u)]);
                }
                piece.entries.push_back({{}, s});
                row.push_back(d);
            }
            piece.unit.push_back(0);
            piece.ends.push_back(static_cast<std::uint32_t>(piece.entries.size()));
            piece.setRow(static_cast<std::size_t>(k), row);
            piece.residual.push_back(static_cast<float>(random.uniform(-1, 1)));
            r[at] = double(piece.residual.back());
        }
    }
    return out;
}

} // namespace

void FitTest::theSolutionIsThatOfADenseSolver() {
    base::Random random(test::seed() + 2);
    constexpr std::size_t sites = 12;
    constexpr double ridge = 0.1;
    for (int k = 0; k < test::effort(10); ++k) {
        Eigen::MatrixXd a;
        Eigen::VectorXd r;
        const std::vector<FitPiece<unknowns>> pieces = randomPieces(random, sites, a, r);
        const Eigen::VectorXd from = Eigen::VectorXd::Random(a.cols());
        Eigen::MatrixXd normal = a.transpose() * a;
        Eigen::VectorXd added(a.cols());
        for (Eigen::Index i = 0; i < a.cols(); ++i) {
            double mean = 0;
            for (Eigen::Index j = i % unknowns; j < a.cols(); j += unknowns)
                mean += normal(j, j) / double(sites);
            added[i] = ridge * (normal(i, i) + 0.05 * mean);
        }
        const Eigen::VectorXd right = -(a.transpose() * r + added.cwiseProduct(from));
        normal += Eigen::MatrixXd(added.asDiagonal());
        const Eigen::VectorXd expected = normal.ldlt().solve(right);
        const Eigen::VectorXd found = NormalEquations<unknowns>(pieces, sites).solve(from, ridge, 0.05, 200);
        QVERIFY2((found - expected).norm() < 1e-3 * expected.norm(),
                 qPrintable(QString("seed %1: %2").arg(test::seed()).arg((found - expected).norm())));
    }
}

void FitTest::aLargeRidgeKeepsEverythingWhereItBegan() {
    base::Random random(test::seed() + 3);
    Eigen::MatrixXd a;
    Eigen::VectorXd r;
    const std::vector<FitPiece<unknowns>> pieces = randomPieces(random, 10, a, r);
    const Eigen::VectorXd from = Eigen::VectorXd::Random(a.cols());
    const Eigen::VectorXd found = NormalEquations<unknowns>(pieces, 10).solve(from, 1e6, 0.05, 200);
    QVERIFY((found + from).norm() < 1e-3 * from.norm());
}

static const test::Registered<FitTest> registered;
#include "fit_test.moc"
