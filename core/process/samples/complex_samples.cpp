#include "core/process/samples/complex_samples.h"

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace process {

using base::Vec3d;

namespace {

/// Puts a complex together, cell by cell.
class Maker {
  public:
    using Curve = std::function<Vec3d(double t)>;              ///< t from 0 to 1
    using Triangle = std::function<Vec3d(double u, double v)>; ///< u, v >= 0, u + v <= 1
    using Normal = std::function<Vec3d(const Vec3d&)>;

    Maker() {
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        layout->add(surface::cellOfComplex, surfel::ScalarType::UInt32);
        m_out.points.layout = layout;
    }

    std::uint32_t addPoint(const Vec3d& p) {
        const std::uint32_t cell = begin({0, {}});
        put(p, {}, cell);
        return cell;
    }
    std::uint32_t addCurve(std::uint32_t from, std::uint32_t to, const Curve& curve, int count) {
        const std::uint32_t cell = begin({1, {from, to}});
        for (int i = 0; i < count; ++i)
            put(curve((i + 0.5) / count), {}, cell);
        return cell;
    }
    std::uint32_t beginPatch(std::vector<std::uint32_t> boundary) { return begin({2, std::move(boundary)}); }
    void put(const Vec3d& p, const Vec3d& normal, std::uint32_t cell) {
        surfel::Surfel s;
        s.position = base::cast<float>(p);
        s.normal = base::cast<float>(normal);
        m_out.points.append(s, std::array{cell});
    }
    /// The middles of `across` rows of equal triangles, one less in each.
    std::uint32_t addTriangle(std::vector<std::uint32_t> boundary, const Triangle& at, const Normal& normal,
                              int across) {
        const std::uint32_t cell = beginPatch(std::move(boundary));
        for (int i = 0; i < across; ++i)
            for (int j = 0; i + j < across; ++j) {
                const Vec3d p = at((i + 1.0 / 3) / across, (j + 1.0 / 3) / across);
                put(p, normal(p), cell);
            }
        return cell;
    }
    /// All cells run along `direction` at that place of a curve or point.
    void prescribe(std::uint32_t at, std::vector<std::uint32_t> cells, const Vec3d& p, const Vec3d& direction) {
        m_out.connectivity.tangents.push_back(
            {at, std::move(cells), base::cast<float>(p), base::cast<float>(direction)});
    }
    ComplexSample take() { return std::move(m_out); }

  private:
    std::uint32_t begin(surface::ComplexCell cell) {
        m_out.connectivity.cells.push_back(std::move(cell));
        return static_cast<std::uint32_t>(m_out.connectivity.cells.size() - 1);
    }
    ComplexSample m_out;
};

Maker::Curve line(const Vec3d& a, const Vec3d& b) {
    return [=](double t) { return a + (b - a) * t; };
}

/// The shorter arc of a circle about the origin.
Maker::Curve arc(const Vec3d& a, const Vec3d& b) {
    const double r = length(a), angle = std::acos(dot(a, b) / (r * length(b)));
    return [=](double t) {
        return a * (std::sin((1 - t) * angle) / std::sin(angle)) + b * (std::sin(t * angle) / std::sin(angle));
    };
}

/// Of what `make` gives for so many rows across a face, the one with about `count` points.
template <class Make>
ComplexSample ofAbout(std::size_t count, const Make& make) {
    constexpr int least = 4;
    const double wanted = static_cast<double>(count);
    int across = least;
    ComplexSample out = make(across);
    for (int round = 0; round < 4; ++round) { // nearly as the square root of the count
        const double share = std::sqrt(wanted / static_cast<double>(out.points.size()));
        const int next = std::max(least, static_cast<int>(std::lround(across * share)));
        if (next == across)
            break;
        across = next;
        out = make(across);
    }
    return out;
}

Vec3d facing(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return normalized(cross(b - a, c - a));
}

/// A flat triangle between straight edges.
void addFlat(Maker& maker, const std::array<Vec3d, 3>& corner, std::vector<std::uint32_t> edges, int across) {
    const Vec3d normal = facing(corner[0], corner[1], corner[2]);
    maker.addTriangle(
        std::move(edges),
        [&](double u, double v) { return corner[0] + (corner[1] - corner[0]) * u + (corner[2] - corner[0]) * v; },
        [&](const Vec3d&) { return normal; }, across);
}

/// Sierpinski's triangle.
class Gasket {
  public:
    explicit Gasket(int across) : m_across(across) {}
    ComplexSample make(const std::array<Vec3d, 3>& corner) {
        divide(corner, 3);
        return m_maker.take();
    }

  private:
    std::uint32_t pointAt(const Vec3d& p) {
        const std::pair key{std::lround(p.x * 1e6), std::lround(p.y * 1e6)};
        const auto found = m_points.find(key);
        return found != m_points.end() ? found->second : m_points[key] = m_maker.addPoint(p);
    }
    void divide(const std::array<Vec3d, 3>& c, int depth) {
        if (depth > 0) {
            const Vec3d ab = (c[0] + c[1]) * 0.5, bc = (c[1] + c[2]) * 0.5, ca = (c[2] + c[0]) * 0.5;
            divide({c[0], ab, ca}, depth - 1);
            divide({ab, c[1], bc}, depth - 1);
            divide({ca, bc, c[2]}, depth - 1);
            return;
        }
        std::array<std::uint32_t, 3> ends{};
        for (std::size_t k = 0; k < 3; ++k)
            ends[k] = pointAt(c[k]);
        std::vector<std::uint32_t> edges;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            edges.push_back(m_maker.addCurve(ends[k], ends[next], line(c[k], c[next]), m_across));
        }
        addFlat(m_maker, c, std::move(edges), m_across);
    }
    Maker m_maker;
    int m_across;
    std::map<std::pair<long, long>, std::uint32_t> m_points;
};

constexpr int icosahedronFaces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                         {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                         {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                         {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

std::array<Vec3d, 12> icosahedronCorners() {
    const double g = std::numbers::phi;
    std::array<Vec3d, 12> out{{{-1, g, 0},
                               {1, g, 0},
                               {-1, -g, 0},
                               {1, -g, 0},
                               {0, -1, g},
                               {0, 1, g},
                               {0, -1, -g},
                               {0, 1, -g},
                               {g, 0, -1},
                               {g, 0, 1},
                               {-g, 0, -1},
                               {-g, 0, 1}}};
    for (Vec3d& each : out)
        each = base::cast<double>(base::cast<float>(normalized(each))); // edges end in what is stored
    return out;
}

/// Twenty faces between edges; `face` puts the points of one.
template <class Edge, class Face>
ComplexSample icosahedron(int across, const Edge& edge, const Face& face, bool rounded) {
    const std::array<Vec3d, 12> corners = icosahedronCorners();
    Maker maker;
    std::array<std::uint32_t, 12> points{};
    for (std::size_t i = 0; i < 12; ++i)
        points[i] = maker.addPoint(corners[i]);
    std::map<std::pair<int, int>, std::uint32_t> edges;
    std::map<std::uint32_t, std::vector<std::uint32_t>> patches; // of edges
    for (const auto& f : icosahedronFaces) {
        std::vector<std::uint32_t> boundary;
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(f[k], f[(k + 1) % 3]);
            if (!edges.contains({a, b}))
                edges[{a, b}] = maker.addCurve(points[std::size_t(a)], points[std::size_t(b)],
                                               edge(corners[std::size_t(a)], corners[std::size_t(b)]), across);
            boundary.push_back(edges[{a, b}]);
        }
        const std::array<Vec3d, 3> c{corners[std::size_t(f[0])], corners[std::size_t(f[1])],
                                     corners[std::size_t(f[2])]};
        const std::uint32_t patch = face(maker, c, boundary);
        for (const std::uint32_t b : boundary)
            patches[b].push_back(patch);
    }
    if (rounded)
        for (const auto& [ends, curve] : edges)
            for (int i = 0; i <= across; ++i) {
                const Vec3d p = edge(corners[std::size_t(ends.first)],
                                     corners[std::size_t(ends.second)])(static_cast<double>(i) / across);
                maker.prescribe(curve, patches[curve], p, normalized(p));
            }
    return maker.take();
}

} // namespace

static ComplexSample makeSquare(int across) {
    const std::array<Vec3d, 4> corner{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
    Maker maker;
    std::array<std::uint32_t, 4> points{};
    for (std::size_t k = 0; k < 4; ++k)
        points[k] = maker.addPoint(corner[k]);
    std::vector<std::uint32_t> edges;
    for (std::size_t k = 0; k < 4; ++k)
        edges.push_back(maker.addCurve(points[k], points[(k + 1) % 4], line(corner[k], corner[(k + 1) % 4]), across));
    const std::uint32_t patch = maker.beginPatch(edges);
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j)
            maker.put({(2 * i + 1.0) / across - 1, (2 * j + 1.0) / across - 1, 0}, {0, 0, 1}, patch);
    return maker.take();
}

ComplexSample makeGasketComplex(std::size_t count) {
    const double high = std::sqrt(0.75);
    return ofAbout(count, [&](int across) {
        return Gasket(across).make({{{-1, -high, 0}, {1, -high, 0}, {0, high, 0}}});
    });
}

static ComplexSample makeOctant(int across) {
    Maker maker;
    const std::array<Vec3d, 4> corner{{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<std::uint32_t, 4> points{};
    for (std::size_t k = 0; k < 4; ++k)
        points[k] = maker.addPoint(corner[k]);
    std::array<std::uint32_t, 4> spoke{}, rim{}; // rim[k]: from corner k to the next
    for (std::size_t k = 1; k < 4; ++k)
        spoke[k] = maker.addCurve(points[0], points[k], line({}, corner[k]), across);
    for (std::size_t k = 1; k < 4; ++k) {
        const std::size_t next = k % 3 + 1;
        rim[k] = maker.addCurve(points[k], points[next], arc(corner[k], corner[next]),
                                static_cast<int>(across * std::numbers::pi / 2));
    }
    const std::uint32_t round = maker.beginPatch({rim[1], rim[2], rim[3]});
    const int rows = static_cast<int>(across * std::numbers::pi / 2);
    for (int i = 0; i < rows; ++i) {
        const double polar = (i + 0.5) / rows * std::numbers::pi / 2; // from the third corner
        const int around = std::max(1, static_cast<int>(std::lround(rows * std::sin(polar))));
        for (int j = 0; j < around; ++j) {
            const double turn = (j + 0.5) / around * std::numbers::pi / 2;
            const Vec3d p{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)};
            maker.put(p, p, round);
        }
    }
    for (std::size_t k = 1; k < 4; ++k) {
        const std::size_t next = k % 3 + 1;
        const std::uint32_t flat = maker.beginPatch({spoke[k], spoke[next], rim[k]});
        for (int i = 0; i < across; ++i) {
            const double r = (i + 0.5) / across;
            const int around = std::max(1, static_cast<int>(std::lround((i + 0.5) * std::numbers::pi / 2)));
            for (int j = 0; j < around; ++j) {
                const double turn = (j + 0.5) / around * std::numbers::pi / 2;
                maker.put((corner[k] * std::cos(turn) + corner[next] * std::sin(turn)) * r,
                          -cross(corner[k], corner[next]), flat);
            }
        }
    }
    return maker.take();
}

static ComplexSample makeCone(int across) {
    constexpr int sides = 8;
    constexpr double high = 1.2;
    Maker maker;
    const Vec3d apex{0, high / 2, 0};
    const auto rimAt = [](double side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        return Vec3d{std::cos(angle), -high / 2, -std::sin(angle)};
    };
    const auto normalAt = [](double side) {
        const double angle = 2 * std::numbers::pi * side / sides;
        return normalized(Vec3d{high * std::cos(angle), 1, -high * std::sin(angle)});
    };
    const std::uint32_t top = maker.addPoint(apex);
    std::array<std::uint32_t, sides> foot{}, edge{}, rim{}, patch{};
    for (int k = 0; k < sides; ++k)
        foot[std::size_t(k)] = maker.addPoint(rimAt(k));
    for (int k = 0; k < sides; ++k) {
        const auto next = static_cast<std::size_t>((k + 1) % sides);
        edge[std::size_t(k)] = maker.addCurve(top, foot[std::size_t(k)], line(apex, rimAt(k)),
                                              static_cast<int>(std::lround(across * length(apex - rimAt(k)) * 1.3)));
        rim[std::size_t(k)] = maker.addCurve(
            foot[std::size_t(k)], foot[next], [&, k](double t) { return rimAt(k + t); }, across);
    }
    for (int k = 0; k < sides; ++k) {
        const auto next = static_cast<std::size_t>((k + 1) % sides);
        const std::uint32_t cell = maker.beginPatch({edge[std::size_t(k)], edge[next], rim[std::size_t(k)]});
        patch[std::size_t(k)] = cell;
        const int rows = static_cast<int>(std::lround(across * length(apex - rimAt(0)) * 1.3));
        for (int i = 0; i < rows; ++i) {
            const double down = (i + 0.5) / rows;
            const int around = std::max(1, static_cast<int>(std::lround(across * down)));
            for (int j = 0; j < around; ++j) {
                const double side = k + (j + 0.5) / around;
                maker.put(apex + (rimAt(side) - apex) * down, normalAt(side), cell);
            }
        }
    }
    for (int k = 0; k < sides; ++k) {
        const auto before = static_cast<std::size_t>((k + sides - 1) % sides);
        for (int i = 1; i <= across; ++i) // along a straight edge the cone has one plane, up to its apex
            maker.prescribe(edge[std::size_t(k)], {patch[std::size_t(k)], patch[before]},
                            apex + (rimAt(k) - apex) * (static_cast<double>(i) / across), normalAt(k));
    }
    return maker.take();
}

static ComplexSample makeIcosahedron(int across) {
    return icosahedron(
        across, line,
        [across](Maker& maker, const std::array<Vec3d, 3>& c, const std::vector<std::uint32_t>& edges) {
            const Vec3d normal = facing(c[0], c[1], c[2]);
            return maker.addTriangle(
                edges, [&](double u, double v) { return c[0] + (c[1] - c[0]) * u + (c[2] - c[0]) * v; },
                [&](const Vec3d&) { return normal; }, across);
        },
        false);
}

static ComplexSample makeBulged(int across) {
    return icosahedron(
        across, line,
        [across](Maker& maker, const std::array<Vec3d, 3>& c, const std::vector<std::uint32_t>& edges) {
            constexpr double high = 0.15;
            const Vec3d up = facing(c[0], c[1], c[2]);
            const auto at = [&](double u, double v) {
                const double w = 1 - u - v;
                return c[0] * w + c[1] * u + c[2] * v + up * (27 * high * u * v * w);
            };
            const std::uint32_t cell = maker.beginPatch(edges);
            for (int i = 0; i < across; ++i)
                for (int j = 0; i + j < across; ++j) {
                    const double u = (i + 1.0 / 3) / across, v = (j + 1.0 / 3) / across, d = 1e-5;
                    const Vec3d n = normalized(cross(at(u + d, v) - at(u - d, v), at(u, v + d) - at(u, v - d)));
                    maker.put(at(u, v), n, cell);
                }
            return cell;
        },
        false);
}

static ComplexSample makeRounded(int across) {
    return icosahedron(
        across, arc,
        [across](Maker& maker, const std::array<Vec3d, 3>& c, const std::vector<std::uint32_t>& edges) {
            return maker.addTriangle(
                edges, [&](double u, double v) { return normalized(c[0] * (1 - u - v) + c[1] * u + c[2] * v); },
                [](const Vec3d& p) { return p; }, across);
        },
        true);
}

ComplexSample makeSquareComplex(std::size_t count) {
    return ofAbout(count, makeSquare);
}

ComplexSample makeOctantComplex(std::size_t count) {
    return ofAbout(count, makeOctant);
}

ComplexSample makeConeComplex(std::size_t count) {
    return ofAbout(count, makeCone);
}

ComplexSample makeIcosahedronComplex(std::size_t count) {
    return ofAbout(count, makeIcosahedron);
}

ComplexSample makeBulgedComplex(std::size_t count) {
    return ofAbout(count, makeBulged);
}

ComplexSample makeRoundedComplex(std::size_t count) {
    return ofAbout(count, makeRounded);
}

} // namespace process
