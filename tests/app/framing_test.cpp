// What `render` shows where nobody says from where: the whole model, in the middle of the picture.
#include "app/options/view_options.h"
#include "core/base/random.h"
#include "core/render/framed_box.h"
#include "core/render/named_views.h"
#include "support/registry.h"

#include <functional>
#include <numbers>
#include <QTest>

using base::Vec3d;

class FramingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void modelsAreWholeAndInTheMiddle_data();
    void modelsAreWholeAndInTheMiddle();
    void rimsAreSeenFromAbove();
    void outliersHaveNoSay();
    void aTurntableShowsAllFromEverySide();
    void aPointIsLookedAt();
};

namespace {

/// Of a model that stands with y upwards.
using Shape = std::function<Vec3d(base::Random&)>;

struct ShapeRow {
    const char* name;
    Shape shape;
};

std::vector<ShapeRow> shapes() {
    const auto turn = [](base::Random& random) { return random.uniform(0, 2 * std::numbers::pi); };
    return {
        {"box",
         [](base::Random& random) {
             Vec3d p{random.uniform(-2, 2), random.uniform(-0.5, 0.5), random.uniform(-1, 1)};
             const std::size_t side = random.below(3);
             p[side] = p[side] > 0 ? (side == 0 ? 2 : side == 1 ? 0.5 : 1) : (side == 0 ? -2 : side == 1 ? -0.5 : -1);
             return p;
         }},
        {"tilted rod",
         [turn](base::Random& random) {
             const double t = random.uniform(-5, 5), a = turn(random);
             return Vec3d{0.3 * t + 0.1 * std::cos(a), t, 0.8 * t + 0.1 * std::sin(a)};
         }},
        {"cup",
         [turn](base::Random& random) {
             const double a = turn(random), y = random.uniform(-0.2, 1),
                          r = y < 0 ? random.uniform(0, 0.6) : 0.6 + 0.3 * y;
             return Vec3d{r * std::cos(a), std::max(y, 0.0), r * std::sin(a)};
         }},
        {"terrain",
         [](base::Random& random) {
             const double x = random.uniform(-3, 3), z = random.uniform(-3, 3);
             return Vec3d{x, 0.2 * std::sin(2 * x) * std::cos(z), z};
         }},
        {"spire on a plate",
         [](base::Random& random) {
             const double t = random.uniform();
             return t < 0.1 ? Vec3d{1.5, 20 * t, -1} : Vec3d{random.uniform(-2, 2), 0, random.uniform(-2, 2)};
         }},
    };
}

constexpr float support = 0.02f;

surfel::SurfelList pointsOf(const Shape& shape, base::UpAxis up, std::size_t count, base::Random& random) {
    surfel::SurfelList out;
    const Vec3d far{30, -4, 11};
    for (std::size_t i = 0; i < count; ++i) {
        surfel::Surfel s;
        s.position = base::cast<float>(fromStanding(up, shape(random)) + far);
        s.support = support;
        out.items.push_back(s);
    }
    return out;
}

/// The discs of points in parts of the picture's width and height, around its middle: -1/2 to 1/2.
struct Seen {
    double left = 9, right = -9, top = 9, bottom = -9;
    bool behind = false;

    Seen(const render::Camera& camera, const tree::SurfelTree& model, const base::Box3f& shown) {
        model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot) {
                if (!shown.contains(block.position(slot)))
                    continue;
                const Vec3d at = camera.project(base::cast<double>(block.position(slot)));
                const double x = at.x / camera.width - 0.5, y = at.y / camera.height - 0.5;
                const double disc = 0.37 * double(support) * camera.pixelsPerUnit(at.z);
                left = std::min(left, x - disc / camera.width), right = std::max(right, x + disc / camera.width);
                top = std::min(top, y - disc / camera.height), bottom = std::max(bottom, y + disc / camera.height);
                behind |= !(at.z > 0);
            }
        });
    }
    double most() const { return std::max({-left, right, -top, bottom}); }
    bool isCentred(double within = 0.02) const {
        return std::abs(left + right) < within && std::abs(top + bottom) < within;
    }
    QByteArray text() const {
        return QByteArray::number(left) + ".." + QByteArray::number(right) + ", " + QByteArray::number(top) + ".." +
               QByteArray::number(bottom);
    }
};

} // namespace

void FramingTest::modelsAreWholeAndInTheMiddle_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<int>("up");
    const std::vector<ShapeRow> all = shapes();
    for (std::size_t k = 0; k < all.size(); ++k)
        for (const base::UpRow& row : base::upTable())
            QTest::addRow("%s, %s up", all[k].name, row.id) << static_cast<int>(k) << static_cast<int>(row.axis);
}

void FramingTest::modelsAreWholeAndInTheMiddle() {
    QFETCH(int, shape);
    QFETCH(int, up);
    const auto axis = static_cast<base::UpAxis>(up);
    base::Random random(test::seed());
    const auto model = tree::SurfelTree::build(pointsOf(shapes()[static_cast<std::size_t>(shape)].shape, axis,
                                                        static_cast<std::size_t>(test::effort(1500)), random));
    for (const char* size : {"640x400", "1280x720", "300x700", "1000x150"})
        for (const double fov : {0.0, 8.0, 75.0})
            for (const char* ortho : {"", "fit"}) {
                app::ViewOptions options;
                options.size = size, options.fovDeg = fov, options.ortho = ortho;
                std::vector<std::string> views{""};
                for (const render::NamedView& view : render::namedViews())
                    views.push_back(view.id);
                for (const std::string& view : views) {
                    options.view = view;
                    const Seen seen(app::camerasOf(options, model, {}, axis).front(), model, model.bounds());
                    const QByteArray where = QByteArray(size) + " " + view.c_str() + " " + ortho +
                                             QByteArray::number(fov) + " seed " + QByteArray::number(test::seed()) +
                                             ": " + seen.text();
                    QVERIFY2(!seen.behind && seen.most() < 0.451 && seen.most() > 0.4, where);
                    QVERIFY2(seen.isCentred(), where);
                }
            }
}

/// Of what stands, tall or wide, the default view shows the upper side.
void FramingTest::rimsAreSeenFromAbove() {
    base::Random random(test::seed());
    for (const base::UpRow& row : base::upTable())
        for (const double tall : {0.3, 1.0, 1.7, 3.0}) {
            const auto cup = [&](base::Random& r) {
                const Vec3d p = shapes()[2].shape(r);
                return Vec3d{p.x, tall * p.y, p.z};
            };
            const auto model = tree::SurfelTree::build(pointsOf(cup, row.axis, 500, random));
            for (const char* size : {"640x400", "400x400"}) {
                app::ViewOptions options;
                options.size = size;
                const render::Camera camera = app::camerasOf(options, model, {}, row.axis).front();
                double top = -1e9, bottom = 1e9;
                for (const surfel::Surfel& each : model.surfels().items) {
                    const double high = dot(base::cast<double>(each.position), row.up);
                    top = std::max(top, high), bottom = std::min(bottom, high);
                }
                QVERIFY2(dot(camera.eye, row.up) > top + 0.1 * (top - bottom), row.id);
            }
        }
}

void FramingTest::outliersHaveNoSay() {
    base::Random random(test::seed());
    surfel::SurfelList points = pointsOf(shapes()[2].shape, base::UpAxis::Z, 5000, random);
    const base::Box3f own = tree::SurfelTree::build(points).bounds();
    for (int k = 0; k < 10; ++k) {
        surfel::Surfel far = points.items.front();
        far.position += base::cast<float>(random.unitVector() * 1000.0);
        far.support = 300;
        points.items.push_back(far);
    }
    points.items.front().support = 50; // a wide one among the others is drawn no wider than they are
    const auto model = tree::SurfelTree::build(points);
    const Seen seen(app::camerasOf({}, model, {}, base::UpAxis::Z).front(), model, own);
    QVERIFY2(seen.most() < 0.451 && seen.most() > 0.4 && seen.isCentred(0.05), seen.text());
}

void FramingTest::aTurntableShowsAllFromEverySide() {
    base::Random random(test::seed());
    for (const ShapeRow& row : shapes()) {
        const auto model = tree::SurfelTree::build(pointsOf(row.shape, base::UpAxis::MinusX, 2000, random));
        for (const char* ortho : {"", "fit"}) {
            app::ViewOptions options;
            options.size = "400x300", options.turntable = 12, options.ortho = ortho;
            for (const render::Camera& camera : app::camerasOf(options, model, {}, base::UpAxis::MinusX)) {
                const Seen seen(camera, model, model.bounds());
                QVERIFY2(!seen.behind && seen.most() < 0.48, row.name + (": " + seen.text()));
            }
        }
    }
}

void FramingTest::aPointIsLookedAt() {
    surfel::SurfelList list;
    surfel::Surfel s;
    s.position = {3, 4, 5}, s.support = 0.1f;
    list.items.push_back(s);
    const auto model = tree::SurfelTree::build(list);
    for (const char* ortho : {"", "fit", "2"}) {
        app::ViewOptions options;
        options.ortho = ortho;
        const render::Camera camera = app::camerasOf(options, model, {}, base::UpAxis::Z).front();
        const Vec3d at = camera.project({3, 4, 5});
        QVERIFY(at.z > 0 && std::abs(at.x - 640) < 1e-6 && std::abs(at.y - 360) < 1e-6);
    }
}

static const test::Registered<FramingTest> registered;
#include "framing_test.moc"
