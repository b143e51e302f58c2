#include "core/process/samples/samples.h"

#include "core/base/row_of_id.h"
#include "core/process/samples/block_of_clay.h"
#include "core/process/samples/complex_samples.h"
#include "core/process/samples/simulated_scan.h"
#include "core/process/samples/tube.h"

#include <numbers>

namespace process {

namespace {

/// Points on a spiral that turns by the golden angle: equal areas, and no direction in which they line up.
surfel::SurfelList makeSphere(std::size_t count, std::uint64_t) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = std::move(layout);
    out.items.resize(count);
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
        const double r = std::sqrt(1 - z * z), angle = std::fmod(golden * static_cast<double>(i), 2 * std::numbers::pi);
        const base::Vec3f p = base::cast<float>(base::Vec3d{r * std::cos(angle), z, r * std::sin(angle)});
        out.items[i].position = out.items[i].normal = p;
    }
    return out;
}

surfel::SurfelList makeTorus(std::size_t count, std::uint64_t) {
    constexpr double radius = 0.7;
    return sampleTube({[](double t) {
                           return base::Vec3d{radius * std::cos(t), 0, -radius * std::sin(t)};
                       },
                       [](double t) {
                           return base::Vec3d{-std::sin(t), 0, -std::cos(t)};
                       },
                       0.3},
                      count);
}

/// Trefoil: twice around the long way and three times the short way of a torus.
surfel::SurfelList makeKnot(std::size_t count, std::uint64_t) {
    constexpr double scale = 1 / 3.55;
    const auto centre = [](double t) {
        const double r = 2 + std::cos(3 * t);
        return base::Vec3d{r * std::cos(2 * t), r * std::sin(2 * t), std::sin(3 * t)} * scale;
    };
    const auto tangent = [](double t) {
        const double r = 2 + std::cos(3 * t), dr = -3 * std::sin(3 * t);
        return base::Vec3d{dr * std::cos(2 * t) - 2 * r * std::sin(2 * t),
                           dr * std::sin(2 * t) + 2 * r * std::cos(2 * t), 3 * std::cos(3 * t)};
    };
    return sampleTube({centre, tangent, 0.55 * scale}, count);
}

surfel::SurfelList makeClay(std::size_t count, std::uint64_t) {
    return sampleBlock({}, count);
}

/// A strip with half a turn, its points on a golden lattice: one side, one rim, no normals.
surfel::SurfelList makeMoebius(std::size_t count, std::uint64_t) {
    surfel::SurfelList out;
    out.items.resize(count);
    const double golden = (std::sqrt(5.0) - 1) / 2;
    for (std::size_t i = 0; i < count; ++i) {
        const double u = 2 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const double across = 0.6 * (std::fmod(golden * static_cast<double>(i), 1.0) - 0.5);
        const double ring = 0.7 + across * std::cos(u / 2);
        out.items[i].position =
            base::cast<float>(base::Vec3d{ring * std::cos(u), across * std::sin(u / 2), -ring * std::sin(u)});
    }
    return out;
}

/// A wire wound twelve times around a ring, at equal arc lengths, thicker on one side: `radius` beside each point.
surfel::SurfelList makeCoil(std::size_t count, std::uint64_t) {
    constexpr int fine = 1 << 15;
    const auto at = [](double t) {
        const double ring = 0.65 + 0.25 * std::cos(12 * t);
        return base::Vec3d{ring * std::cos(t), 0.25 * std::sin(12 * t), ring * std::sin(t)};
    };
    std::vector<double> arc(fine + 1);
    for (int i = 0; i < fine; ++i)
        arc[i + 1] = arc[i] + distance(at(2 * std::numbers::pi * i / fine), at(2 * std::numbers::pi * (i + 1) / fine));
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->add("radius", surfel::ScalarType::Float32);
    out.layout = layout;
    out.items.resize(count);
    out.extra.resize(count * layout->words());
    int step = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double length = arc.back() * static_cast<double>(i) / static_cast<double>(count);
        while (arc[step + 1] <= length)
            ++step;
        const double t = 2 * std::numbers::pi * (step + (length - arc[step]) / (arc[step + 1] - arc[step])) / fine;
        out.items[i].position = base::cast<float>(at(t));
        write(*layout->find("radius"), std::span(out.extra).subspan(i * layout->words(), layout->words()),
              0.03 + 0.015 * std::cos(t));
    }
    return out;
}

/// A row's functions of a complex.
template <ComplexSample (*make)(std::size_t)>
surfel::SurfelList pointsOf(std::size_t count, std::uint64_t) {
    return make(count).points;
}
template <ComplexSample (*make)(std::size_t)>
surface::Connectivity connectivityOf(std::size_t count) {
    return make(count).connectivity;
}

constexpr surface::Manifold complex = surface::Manifold::Complex;
constexpr SampleRow table[] = {
    {"sphere", "Sphere", "A ball of clay, evenly sampled", makeSphere, 40000},
    {"torus", "Torus", "A ring", makeTorus, 40000},
    {"knot", "Knot", "A trefoil knot", makeKnot, 40000},
    {"clay", "Block of clay", "A block with rounded edges, to start sculpting from", makeClay, 60000},
    {"scan", "Simulated scan", "Raw points of a figure: several views, noise, holes, no normals", simulateScan, 60000},
    {"coil", "Coil", "A curve in space with a radius per point: a wound wire", makeCoil, 2000,
     surface::Manifold::Curve},
    {"moebius", "M\u00f6bius strip", "A strip with half a turn: one side, one rim", makeMoebius, 20000},
    {"square", "Square", "A complex: one open patch between four edges", pointsOf<makeSquareComplex>, 2000, complex,
     connectivityOf<makeSquareComplex>},
    {"gasket", "Gasket", "A complex: Sierpinski's triangle, patches that meet in corners only",
     pointsOf<makeGasketComplex>, 6000, complex, connectivityOf<makeGasketComplex>},
    {"octant", "Octant", "A complex: an eighth of a ball, sharp where its faces meet", pointsOf<makeOctantComplex>,
     4000, complex, connectivityOf<makeOctantComplex>},
    {"cone", "Cone", "A complex: eight triangles about an apex, smooth from one to the next", pointsOf<makeConeComplex>,
     4000, complex, connectivityOf<makeConeComplex>},
    {"icosahedron", "Icosahedron", "A complex: twenty flat faces, sharp edges and corners",
     pointsOf<makeIcosahedronComplex>, 6000, complex, connectivityOf<makeIcosahedronComplex>},
    {"bulged", "Bulged icosahedron", "A complex: round faces between straight, sharp edges",
     pointsOf<makeBulgedComplex>, 6000, complex, connectivityOf<makeBulgedComplex>},
    {"rounded", "Rounded icosahedron", "A complex: twenty faces of a ball that share planes along their edges",
     pointsOf<makeRoundedComplex>, 6000, complex, connectivityOf<makeRoundedComplex>},
};

} // namespace

std::span<const SampleRow> sampleTable() {
    return table;
}

surface::SurfaceDefinition definitionOf(const SampleRow& sample, std::size_t count) {
    surface::SurfaceDefinition out;
    out.manifold = sample.manifold;
    if (sample.connectivity)
        out.connectivity = std::make_shared<const surface::Connectivity>(sample.connectivity(count));
    return out;
}

const SampleRow& sample(std::string_view id) {
    return base::rowOf(table, id, {"there is no sample called '%'", "", "choose one of %"});
}

} // namespace process
