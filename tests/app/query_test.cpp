// query and intersect: columns, order, precision and values on models whose surface is known.
#include "core/base/random.h"
#include "program.h"
#include "support/registry.h"

#include <cmath>
#include <cstdio>
#include <QTest>

using base::Vec3d;
using test::Outcome;
using test::Program;
using test::rowsOf;

class QueryTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void columnsFollowTheContract_data();
    void columnsFollowTheContract();
    void rowsKeepTheirOrderAndPlaces();
    void theSphereIsMeasured_data();
    void theSphereIsMeasured();
    void whatHasNoAnswerSaysSo();
    void largeOriginsComeBack();
    void modelsServeAsPositions();
    void raysMeetTheSphere_data();
    void raysMeetTheSphere();
    void allHitsAndAnyHitAreTold();
    void causesAndAgreementAreTold();
    void curvesAnswerTheSameQuestions();
    void byteOrderMarksArePassedOver();
    void decimalCommasMeanWhatPointsMean();
};

static std::string number(double value) {
    char out[40];
    std::snprintf(out, sizeof out, "%.17g", value);
    return out;
}

static std::string line(const Vec3d& p, const char* separator = " ") {
    return number(p.x) + separator + number(p.y) + separator + number(p.z);
}

static Vec3d vectorAt(const std::vector<std::string>& row, std::size_t k) {
    return {std::stod(row.at(k)), std::stod(row.at(k + 1)), std::stod(row.at(k + 2))};
}

/// Positions near the unit sphere and the program's answers about them.
static std::vector<std::vector<std::string>> ask(const Program& program, const std::vector<Vec3d>& points,
                                                 const char* what, const char* precision) {
    std::string text;
    for (const Vec3d& p : points)
        text += line(p) + "\n";
    program.write("p.txt", text);
    const Outcome outcome = program.run(
        {"query", "sample:sphere:4000", "--at", "p.txt", "--what", what, "-o", "out.csv", "--precision", precision});
    return outcome.code == 0 ? rowsOf(program.read("out.csv")) : rowsOf(outcome.err);
}

void QueryTest::columnsFollowTheContract_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("header");
    const auto row = [](const char* what, const char* columns) {
        QTest::newRow(what) << what << QString("x,y,z,status,") + columns;
    };
    row("value", "f");
    row("centroid", "cx,cy,cz");
    row("normal", "nx,ny,nz");
    row("gradient", "gx,gy,gz");
    row("off-centre", "o");
    row("curvature", "k1,k2,d1x,d1y,d1z,d2x,d2y,d2z");
    row("project-basic", "px,py,pz,iterations");
    row("project-almost", "px,py,pz,iterations");
    row("project-orthogonal", "px,py,pz,iterations");
    row("project-orthogonal,curvature,off-centre,gradient,normal,centroid,value",
        "f,cx,cy,cz,nx,ny,nz,gx,gy,gz,o,k1,k2,d1x,d1y,d1z,d2x,d2y,d2z,px,py,pz,iterations");
}

void QueryTest::columnsFollowTheContract() {
    QFETCH(QString, what);
    QFETCH(QString, header);
    const Program program;
    const auto rows = ask(program, {{0, 0, 1.01}, {0, 9, 0}}, qPrintable(what), "float");
    QCOMPARE(rows.size(), std::size_t(3));
    QCOMPARE(QString::fromStdString(program.read("out.csv")).split('\n')[0], header);
    for (const auto& row : rows)
        QCOMPARE(row.size(), rows[0].size());
    QCOMPARE(rows[1][3], std::string("ok"));
}

void QueryTest::rowsKeepTheirOrderAndPlaces() {
    const Program program;
    base::Random random(test::seed());
    std::vector<Vec3d> points;
    for (int k = 0; k < 70000; ++k)
        points.push_back(random.unitVector() * random.uniform(0.98, 1.02));
    for (const auto& [precision, digits] : {std::pair{"float", 9}, {"double", 17}}) {
        const auto rows = ask(program, points, "value", precision);
        QCOMPARE(rows.size(), points.size() + 1);
        for (std::size_t k = 0; k < points.size(); ++k) {
            char text[40];
            std::snprintf(text, sizeof text, "%.*g", digits, points[k].x);
            QCOMPARE(std::stod(rows[k + 1][0]), std::stod(text));
            QCOMPARE(rows[k + 1][3], std::string("ok"));
        }
    }
}

void QueryTest::theSphereIsMeasured_data() {
    QTest::addColumn<QString>("precision");
    QTest::newRow("float") << "float";
    QTest::newRow("double") << "double";
}

/// The sample's surface differs from the unit sphere by far less than these tolerances.
void QueryTest::theSphereIsMeasured() {
    QFETCH(QString, precision);
    const Program program;
    base::Random random(test::seed());
    std::vector<Vec3d> points;
    for (int k = 0; k < 200; ++k)
        points.push_back(random.unitVector() * random.uniform(0.95, 1.05));
    const auto rows = ask(program, points, "value,normal,gradient,curvature,project-orthogonal", qPrintable(precision));
    QCOMPARE(rows.size(), points.size() + 1);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto& row = rows[k + 1];
        const Vec3d radial = base::normalized(points[k]);
        const double height = base::length(points[k]) - 1;
        QCOMPARE(row[3], std::string("ok"));
        QVERIFY2(std::abs(std::stod(row[4]) - height) < 0.01, row[4].c_str());
        QVERIFY(base::distance(vectorAt(row, 5), radial) < 0.05);
        QVERIFY(base::distance(vectorAt(row, 8), radial) < 0.1);
        const double k1 = std::stod(row[11]), k2 = std::stod(row[12]);
        QVERIFY2(k1 >= k2 && k2 > 0.5 && k1 < 1.6, qPrintable(QString("%1 %2").arg(k1).arg(k2)));
        QVERIFY(base::distance(vectorAt(row, 19), radial) < 2e-3);
    }
}

void QueryTest::whatHasNoAnswerSaysSo() {
    const Program program;
    program.write("p.csv", "x,y,z\n0, 0, 1\n# a comment\n\n0\t0\t90 # far away\nnan 0 0\n");
    const Outcome outcome = program.run(
        {"query", "sample:sphere:4000", "--at", "p.csv", "--what", "value,curvature,project-basic", "-o", "out.csv"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("out.csv"));
    QCOMPARE(rows.size(), std::size_t(4));
    QCOMPARE(rows[1][3], std::string("ok"));
    QCOMPARE(rows[2][3], std::string("outside"));
    QCOMPARE(rows[3][3], std::string("outside"));
    for (std::size_t k = 4; k < 13; ++k) {
        QVERIFY(rows[1][k] != "nan");
        QCOMPARE(rows[2][k], std::string("nan"));
        QCOMPARE(rows[3][k], std::string("nan"));
    }
}

void QueryTest::largeOriginsComeBack() {
    const Program program;
    const Vec3d far{500000.25, 5600000.5, 100.125};
    base::Random random(test::seed());
    std::string model, points;
    for (int k = 0; k < 4000; ++k)
        model += line(random.unitVector() + far) + "\n";
    const Vec3d at = far + Vec3d{0, 0, 1.01};
    program.write("m.xyz", model);
    program.write("p.xyz", line(at));
    program.write("r.csv", "dx,dy,dz,ox,oy,oz\n0,0,-2," + line(far + Vec3d{0, 0, 5}, ",") + "\n");
    QCOMPARE(program
                 .run({"query", "m.xyz", "--at", "p.xyz", "--what", "centroid,project-orthogonal", "-o", "q.csv",
                       "--precision", "double"})
                 .code,
             0);
    const auto rows = rowsOf(program.read("q.csv"));
    QCOMPARE(rows[1][3], std::string("ok"));
    QVERIFY(vectorAt(rows[1], 0) == at);
    QVERIFY(base::distance(vectorAt(rows[1], 4), at) < 0.2);
    QVERIFY(base::distance(vectorAt(rows[1], 7), far + Vec3d{0, 0, 1}) < 0.1);
    QCOMPARE(program.run({"intersect", "m.xyz", "--rays", "r.csv", "-o", "h.csv", "--precision", "double"}).code, 0);
    const auto hits = rowsOf(program.read("h.csv"));
    QCOMPARE(hits[1][0], std::string("1"));
    QVERIFY(std::abs(std::stod(hits[1][1]) - 4) < 0.1);
    QVERIFY(base::distance(vectorAt(hits[1], 2), far + Vec3d{0, 0, 1}) < 0.1);
}

/// What spreadsheets write where people count with commas: positions, rays and the ways of tools.
void QueryTest::decimalCommasMeanWhatPointsMean() {
    const Program program;
    const auto answer = [&](const QStringList& arguments, const std::string& text) {
        program.write("in.csv", text);
        const Outcome outcome = program.run(arguments + QStringList{"in.csv", "-o", "out.csv", "sample:sphere:4000"});
        if (outcome.code != 0)
            return "refused: " + outcome.err;
        std::string out;
        for (const auto& row : rowsOf(program.read("out.csv")))
            for (std::size_t k = 0; k < row.size() && k < 11; ++k) // but for the time that a haptic step took
                out += row[k] + " ";
        return out;
    };
    const QStringList query{"query", "--what", "value", "--at"}, intersect{"intersect", "--rays"},
        haptic{"haptic", "--trajectory"};
    struct Asked {
        QStringList arguments;
        std::string points, doubled;
    };
    for (const Asked& asked :
         {Asked{query, "0.5;0.25;0.82\n0;0;1.01\n", "x,y,z\n0,5,0,25,0,82\n"},
          {query, "x;y;z\n0;0;1\n0.5;0.25;0.82\n", "0,50,0,05,0,82\n"},
          {intersect, "ox;oy;oz;dx;dy;dz\n0.5;0.25;3.5;0;0;-1\n", "ox,oy,oz,dx,dy,dz\n0,5,0,25,3,5,0,0,0,0,-1,0\n"},
          {haptic, "t;x;y;z\n0;0;0;1.5\n0.001;0;0.25;0.9\n", "t,x,y,z\n0,0,0,0,0,0,1,5\n"}}) {
        std::string commas = asked.points;
        std::replace(commas.begin(), commas.end(), '.', ',');
        const std::string wanted = answer(asked.arguments, asked.points);
        QVERIFY2(wanted.size() > 40 && wanted.find("nan") == std::string::npos && !wanted.starts_with("refused"),
                 wanted.c_str());
        QCOMPARE(answer(asked.arguments, commas), wanted);
        const std::string refused = answer(asked.arguments, asked.doubled);
        QVERIFY2(refused.starts_with("refused") && refused.find("semicolons") != std::string::npos, refused.c_str());
    }
}

void QueryTest::modelsServeAsPositions() {
    const Program program;
    QCOMPARE(program.run({"convert", "sample:sphere:1000", "p.ply"}).code, 0);
    QCOMPARE(program.run({"query", "sample:sphere:4000", "--at", "p.ply", "--what", "value", "-o", "out.csv"}).code, 0);
    const auto rows = rowsOf(program.read("out.csv"));
    QVERIFY(rows.size() > 900);
    for (std::size_t k = 1; k < rows.size(); ++k) {
        QCOMPARE(rows[k][3], std::string("ok"));
        QVERIFY(std::abs(std::stod(rows[k][4])) < 5e-3);
    }
}

void QueryTest::raysMeetTheSphere_data() {
    theSphereIsMeasured_data();
}

void QueryTest::raysMeetTheSphere() {
    QFETCH(QString, precision);
    const Program program;
    base::Random random(test::seed());
    std::vector<std::pair<Vec3d, Vec3d>> rays;
    std::string text = "ox,oy,oz,dx,dy,dz\n";
    for (int k = 0; k < 500; ++k) {
        const Vec3d origin = random.unitVector() * 4, aim = random.unitVector() * random.uniform(0, 2);
        rays.emplace_back(origin, base::normalized(aim - origin));
        text += line(origin, ",") + "," + line((aim - origin) * 3, ",") + "\n";
    }
    program.write("r.csv", text);
    const Outcome outcome =
        program.run({"intersect", "sample:sphere:4000", "--rays", "r.csv", "-o", "h.csv", "--precision", precision});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("h.csv"));
    QCOMPARE(rows.size(), rays.size() + 1);
    QCOMPARE(QString::fromStdString(program.read("h.csv")).split('\n')[0], QString("hit,t,x,y,z,nx,ny,nz"));
    int hits = 0;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const auto& [origin, direction] = rays[k];
        const auto& row = rows[k + 1];
        const double along = -base::dot(origin, direction);
        const double distance = base::length(origin + direction * along);
        if (std::abs(distance - 1) < 0.02)
            continue; // a silhouette may go either way
        QCOMPARE(row[0], std::string(distance < 1 ? "1" : "0"));
        if (distance > 1) {
            QCOMPARE(row[1], std::string("nan"));
            continue;
        }
        ++hits;
        const double t = along - std::sqrt(1 - distance * distance);
        const Vec3d place = origin + direction * t;
        QVERIFY(std::abs(std::stod(row[1]) - t) < 0.02);
        QVERIFY(base::distance(vectorAt(row, 2), place) < 0.02);
        QVERIFY(base::distance(vectorAt(row, 5), place) < 0.1);
        QVERIFY(base::dot(vectorAt(row, 5), direction) < 0);
    }
    QVERIFY(hits > 100);
}

/// In and out of the sphere, by either policy; shadows from its own surface.
void QueryTest::allHitsAndAnyHitAreTold() {
    const Program program;
    program.write("r.csv", "ox,oy,oz,dx,dy,dz\n0,0,5,0,0,-1\n0,3,5,0,0,-1\n0.3,0,-4,0,0,1\n0,0,1,0,0,1\n");
    for (const char* policy : {"fast", "robust"})
        for (const char* precision : {"float", "double"}) {
            const auto run = [&](const char* hits) {
                const Outcome outcome =
                    program.run({"intersect", "sample:sphere:4000", "--rays", "r.csv", "-o", "h.csv", "--hits", hits,
                                 "--policy", policy, "--precision", precision});
                QVERIFY2(outcome.code == 0, outcome.err.c_str());
            };
            run("all");
            QCOMPARE(QString::fromStdString(program.read("h.csv")).split('\n')[0], QString("ray,t,x,y,z,nx,ny,nz"));
            const auto all = rowsOf(program.read("h.csv"));
            QVERIFY(all.size() >= 5);
            const double expected[4][3] = {{0, 0, 1}, {0, 0, -1}, {0.3, 0, -0.954}, {0.3, 0, 0.954}};
            const char* rays[4] = {"0", "0", "2", "2"};
            for (std::size_t k = 0; k < 4; ++k) {
                QCOMPARE(all[k + 1][0], std::string(rays[k]));
                QVERIFY(base::distance(vectorAt(all[k + 1], 2), {expected[k][0], expected[k][1], expected[k][2]}) <
                        0.02);
            }
            run("any");
            QCOMPARE(program.read("h.csv").substr(0, 10), std::string("hit\n1\n0\n1\n"));
        }
}

void QueryTest::causesAndAgreementAreTold() {
    const Program program;
    const auto rows = ask(program, {{0, 0, 1.01}, {0, 9, 0}}, "agreement,cause", "double");
    QCOMPARE(rows.size(), std::size_t(3));
    QCOMPARE(rows[0].at(4) + " " + rows[0].at(5), std::string("agreement cause"));
    QVERIFY(std::stod(rows[1].at(4)) > 0.9 && std::stod(rows[1].at(4)) <= 1);
    QCOMPARE(rows[1].at(5), std::string("none"));
    QCOMPARE(rows[2].at(3), std::string("outside"));
    QCOMPARE(rows[2].at(5), std::string("no-support"));
    QCOMPARE(program.run({"query", "sample:sphere:4000", "--at", "p.txt", "--what", "tangent", "-o", "o.csv"}).code, 2);
}

/// A circle of points with radius 2: its foot, tangent and curvature vector; rays meet its tube.
void QueryTest::curvesAnswerTheSameQuestions() {
    const Program program;
    std::string circle;
    for (int i = 0; i < 2000; ++i)
        circle +=
            line({2 * std::cos(i * 0.001 * 3.14159265358979), 2 * std::sin(i * 0.001 * 3.14159265358979), 5}) + "\n";
    program.write("circle.xyz", circle);
    program.write("p.txt", line({2.05, 0, 5.02}) + "\n" + line({0, 40, 5}) + "\n");
    const auto outcome = program.run({"query", "circle.xyz", "--manifold", "curve", "--support", "0.2", "--at", "p.txt",
                                      "--what", "value,curvature,tangent,curvature-vector,project-orthogonal", "-o",
                                      "o.csv", "--precision", "double"});
    QVERIFY2(outcome.code == 0, outcome.err.c_str());
    const auto rows = rowsOf(program.read("o.csv"));
    QCOMPARE(rows.size(), std::size_t(3));
    const auto& row = rows[1];
    QCOMPARE(row.at(3), std::string("ok"));
    const double radius = 2 - 0.04 / 28 / 2; // the shift of a curve, surface/README
    QVERIFY(std::abs(std::stod(row.at(4)) - std::hypot(2.05 - radius, 0.02)) < 1e-3);
    QVERIFY(std::abs(std::stod(row.at(5)) - 0.5) < 0.05 && std::stod(row.at(6)) == 0);
    QVERIFY(std::abs(std::abs(vectorAt(row, 13).y) - 1) < 1e-3);
    QVERIFY(distance(vectorAt(row, 16), {-0.5, 0, 0}) < 0.05);
    QVERIFY(distance(vectorAt(row, 19), {radius, 0, 5}) < 1e-4);
    QCOMPARE(rows[2].at(3), std::string("outside"));
    program.write("rays.csv", "ox,oy,oz,dx,dy,dz\n5,0,5,-1,0,0\n0,0,9,0,0,-1\n");
    QCOMPARE(program
                 .run({"intersect", "circle.xyz", "--manifold", "curve", "--support", "0.2", "--rays", "rays.csv", "-o",
                       "h.csv"})
                 .code,
             0);
    const auto hits = rowsOf(program.read("h.csv"));
    QCOMPARE(hits.at(1).at(0), std::string("1"));
    QVERIFY(std::abs(std::stod(hits.at(1).at(1)) - (5 - radius - 0.025)) < 1e-3); // an eighth of the support
    QCOMPARE(hits.at(2).at(0), std::string("0"));
    QCOMPARE(program
                 .run({"query", "circle.xyz", "--manifold", "curve", "--frame", "apss", "--at", "p.txt", "--what",
                       "value", "-o", "o.csv"})
                 .code,
             1);
}

/// Spreadsheets put one before the text.
void QueryTest::byteOrderMarksArePassedOver() {
    const Program program;
    const auto same = [&](QStringList arguments, const char* input, const std::string& text) {
        std::string answers[2];
        for (const int marked : {0, 1}) {
            program.write(input, (marked == 1 ? "\xef\xbb\xbf" : "") + text);
            const Outcome outcome = program.run(arguments + QStringList{"-o", "o.csv"});
            answers[marked] = outcome.code == 0 ? program.read("o.csv") : outcome.err;
        }
        return answers[0] == answers[1] && answers[0].find("pointclay:") == std::string::npos;
    };
    const QStringList query{"query", "sample:sphere:500", "--at", "p.txt", "--what", "value"};
    QVERIFY(same(query, "p.txt", "0 0 1.01\n0 1 0\n"));
    QVERIFY(same(query, "p.txt", "x,y,z\r\n0,0,1.01\r\n"));
    QVERIFY(same({"intersect", "sample:sphere:500", "--rays", "r.csv"}, "r.csv", "ox,oy,oz,dx,dy,dz\n0,0,3,0,0,-1\n"));
    program.write("p.txt", "\xef\xbb\xbf"
                           "0 0 1\n0 zero 1\n");
    QVERIFY(program.run(query + QStringList{"-o", "o.csv"}).err.find("p.txt, line 2") != std::string::npos);
}

static const test::Registered<QueryTest> registered;
#include "query_test.moc"
