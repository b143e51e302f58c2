// Colours that faces have of their own: pictures and plain ones, on samples and on kept vertices.
#include "core/mesh/faces/open_faces.h"
#include "face_models.h"
#include "support/registry.h"

#include <QTest>

using namespace faces;
using mesh::Picture;
using mesh::Polygons;
using surfel::rgba;

class FacePaintTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void picturesAreSmoothAndRepeatOrEnd();
    void samplesAndVerticesHaveTheirPicturesColour();
    void facesHaveTheirOwnColours();
    void looksFollowTheirFaces();
};

namespace {

/// Red grows to the right, green upwards.
Picture ramp(int side, bool clamped = false) {
    Picture out{side, side, {}, clamped};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            out.pixels.push_back(
                rgba(unsigned(255 * column / (side - 1)), unsigned(255 * (side - 1 - row) / (side - 1)), 0));
    return out;
}

/// Two squares beside each other over [0, 2] x [0, 1]; the second one runs the other way round.
Polygons squares() {
    Polygons out;
    out.corners = {0, 1, 4, 3, 1, 4, 5, 2};
    out.ends = {4, 8};
    return out;
}

surfel::SurfelList corners() {
    surfel::SurfelList out;
    for (const Vec3f& p : {Vec3f{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}})
        out.append(at(p), {});
    return out;
}

mesh::OpenedFaces open(const Polygons& polygons, const mesh::FaceOptions& options) {
    const surfel::SurfelList list = corners();
    std::vector<Vec3f> positions;
    for (const surfel::Surfel& s : list.items)
        positions.push_back(s.position);
    const mesh::CutPolygons cut = mesh::cut(polygons, positions);
    const mesh::FacePaint paint(polygons, cut);
    return mesh::openFaces(list, cut.triangles, {}, options, {}, &paint);
}

int channel(surfel::Colour colour, unsigned k) {
    return static_cast<int>(colour >> (8 * k) & 255u);
}

} // namespace

void FacePaintTest::picturesAreSmoothAndRepeatOrEnd() {
    const Picture repeated = ramp(5), clamped = ramp(5, true);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            for (const double by : {0.0, 1.0, -7.0})
                QCOMPARE(repeated.at((column + 0.5) / 5 + by, 1 - (row + 0.5) / 5 + by),
                         repeated.pixels[std::size_t(5 * row + column)]);
    QCOMPARE(clamped.at(0.4, 0.5), rgba(95, 127, 0)); // between the pixels of 63 and 127
    QCOMPARE(clamped.at(9, -9), rgba(255, 0, 0));
    QCOMPARE(repeated.at(0, 0.5), rgba(128, 127, 0)); // between both ends
    for (const double far : {1e30, -1e30, 1e300, -1e-300}) {
        QVERIFY(repeated.at(far, far) >> 24 == 255);
        QVERIFY(clamped.at(far, far) >> 24 == 255);
    }
    const Picture one{1, 1, {rgba(9, 8, 7)}, false};
    QCOMPARE(one.at(0.3, 0.9), rgba(9, 8, 7));
}

void FacePaintTest::samplesAndVerticesHaveTheirPicturesColour() {
    Polygons polygons = squares();
    // Of the whole strip: u = x / 2, v = y, away from the borders where the picture repeats.
    const auto list = corners();
    for (const std::uint32_t corner : polygons.corners) {
        const Vec3f p = list.items[corner].position;
        polygons.places.push_back({0.1f + 0.4f * p.x, 0.1f + 0.8f * p.y});
    }
    polygons.pictureOf = {0, 0};
    polygons.pictures = {std::make_shared<Picture>(ramp(64))};
    QVERIFY(polygons.painted());
    for (const mesh::FaceUse use : {mesh::FaceUse::Sample, mesh::FaceUse::Vertices}) {
        const mesh::OpenedFaces found = open(polygons, {.use = use, .count = use == mesh::FaceUse::Sample ? 500u : 0u});
        QVERIFY(found.points.layout->colours);
        for (const surfel::Surfel& s : found.points.items) {
            const auto u = double(0.1f + 0.4f * s.position.x), v = double(0.1f + 0.8f * s.position.y);
            QVERIFY(std::abs(channel(s.colour, 0) - 255 * (64 * u - 0.5) / 63) < 1.6);
            QVERIFY(std::abs(channel(s.colour, 1) - 255 * (64 * v - 0.5) / 63) < 1.6);
        }
    }
}

void FacePaintTest::facesHaveTheirOwnColours() {
    Polygons polygons = squares();
    polygons.colours = {rgba(200, 0, 0), rgba(0, 0, 100)};
    const auto onBoth = [](const surfel::Surfel& s) { return std::abs(s.position.x - 1) < 1e-6f; }; // of either then
    for (const surfel::Surfel& s : open(polygons, {.use = mesh::FaceUse::Sample, .count = 500}).points.items)
        if (!onBoth(s))
            QCOMPARE(s.colour, s.position.x < 1 ? rgba(200, 0, 0) : rgba(0, 0, 100));
    for (const surfel::Surfel& s : open(polygons, {.use = mesh::FaceUse::Vertices}).points.items)
        if (s.position.x == 1)
            QVERIFY(channel(s.colour, 0) > 50 && channel(s.colour, 2) > 25);
        else
            QCOMPARE(s.colour, s.position.x < 1 ? rgba(200, 0, 0) : rgba(0, 0, 100));
    // A picture goes before the face's colour, but only where its face has one and its corners have places.
    polygons.places.resize(8);
    polygons.pictureOf = {0, Polygons::noPicture};
    polygons.pictures = {std::make_shared<Picture>(ramp(4))};
    for (const surfel::Surfel& s : open(polygons, {.use = mesh::FaceUse::Sample, .count = 200}).points.items)
        if (!onBoth(s))
            QCOMPARE(s.colour, s.position.x < 1 ? rgba(200, 0, 0) : rgba(0, 0, 100));
}

void FacePaintTest::looksFollowTheirFaces() {
    Polygons polygons = squares();
    polygons.colours = {1, 2};
    polygons.pictureOf = {3, 4};
    for (int k = 0; k < 8; ++k)
        polygons.places.push_back({static_cast<float>(k), 0});
    const std::vector<std::uint32_t> numbers{std::uint32_t(-1), 1, 2, 3, 4, 5}; // the first face goes
    QCOMPARE(polygons.renumber(numbers), std::size_t(1));
    QCOMPARE(polygons.colours, (std::vector<surfel::Colour>{2}));
    QCOMPARE(polygons.pictureOf, (std::vector<std::uint32_t>{4}));
    QVERIFY(polygons.places.size() == 4 && polygons.places[0].u == 4);
    const Polygons more = polygons;
    polygons.append(more);
    QVERIFY(polygons.size() == 2 && polygons.places.size() == 8 && polygons.colours.size() == 2);
}

static const test::Registered<FacePaintTest> registered;
#include "face_paint_test.moc"
