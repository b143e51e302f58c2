#include "core/surface/definition_text.h"

#include "core/base/error.h"

#include <array>
#include <charconv>
#include <cmath>

namespace surface {

static constexpr Named<Manifold> manifolds[] = {{Manifold::Surface, "surface"}, {Manifold::Curve, "curve"}};
static constexpr Named<Weight> weights[] = {
    {Weight::Wendland, "wendland"}, {Weight::WendlandC4, "wendland-c4"}, {Weight::Gaussian, "gaussian"}};
static constexpr Named<Frame> frames[] = {{Frame::Normals, "normals"},
                                          {Frame::Hyperplanes, "hyperplanes"},
                                          {Frame::Covariance, "covariance"},
                                          {Frame::CovarianceAtCentroid, "covariance-at-centroid"},
                                          {Frame::CentroidGradient, "centroid-gradient"},
                                          {Frame::Apss, "apss"},
                                          {Frame::Rimls, "rimls"}};
static constexpr Named<Boundary> boundaries[] = {
    {Boundary::Auto, "auto"}, {Boundary::Limit, "limit"}, {Boundary::None, "none"}};
static constexpr Named<Projector> projectors[] = {
    {Projector::Basic, "basic"}, {Projector::Almost, "almost"}, {Projector::Orthogonal, "orthogonal"}};
static constexpr Named<bool> switches[] = {{true, "on"}, {false, "off"}};

std::span<const Named<Manifold>> manifoldNames() {
    return manifolds;
}
std::span<const Named<Weight>> weightNames() {
    return weights;
}
std::span<const Named<Frame>> frameNames() {
    return frames;
}
std::span<const Named<Boundary>> boundaryNames() {
    return boundaries;
}
std::span<const Named<Projector>> projectorNames() {
    return projectors;
}

template <class E>
static const char* nameIn(std::span<const Named<E>> table, E value) {
    for (const auto& row : table)
        if (row.value == value)
            return row.name;
    return "";
}

template <class E>
static E parseIn(std::span<const Named<E>> table, const char* what, std::string_view name) {
    std::string known;
    for (const auto& row : table) {
        if (name == row.name)
            return row.value;
        known.append(known.empty() ? "" : ", ").append(row.name);
    }
    throw base::Error("unknown " + std::string(what) + " '" + std::string(name) + "'", {}, "known are " + known);
}

const char* nameOf(Manifold manifold) {
    return nameIn(manifoldNames(), manifold);
}
const char* nameOf(Weight weight) {
    return nameIn(weightNames(), weight);
}
const char* nameOf(Frame frame) {
    return nameIn(frameNames(), frame);
}
const char* nameOf(Boundary boundary) {
    return nameIn(boundaryNames(), boundary);
}
const char* nameOf(Projector projector) {
    return nameIn(projectorNames(), projector);
}
Manifold parseManifold(std::string_view name) {
    return parseIn(manifoldNames(), "manifold", name);
}
Weight parseWeight(std::string_view name) {
    return parseIn(weightNames(), "weight", name);
}
Frame parseFrame(std::string_view name) {
    return parseIn(frameNames(), "frame", name);
}
Projector parseProjector(std::string_view name) {
    return parseIn(projectorNames(), "projection", name);
}

template <class T>
static std::string printed(T value) {
    char out[40];
    const auto end = std::to_chars(out, out + sizeof out, value).ptr;
    return {out, end};
}

template <class T>
static T parseNumber(std::string_view name, std::string_view text, T least, const char* range) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= least))
        throw base::Error("'" + std::string(text) + "' is no value for it", std::string(name), range);
    return value;
}

static float parseLimit(std::string_view name, std::string_view text) {
    const char* range = "give auto, none or a limit above 0 in units of h";
    const float value = parseNumber<float>(name, text, 0, range);
    if (value == 0)
        throw base::Error("a limit of 0 leaves no surface", std::string(name), range);
    return value;
}

static void setBoundary(SurfaceDefinition& d, std::string_view value) {
    d.boundaryLimit = std::numeric_limits<float>::infinity();
    d.boundary = value == "auto" ? Boundary::Auto : value == "none" ? Boundary::None : Boundary::Limit;
    if (d.boundary == Boundary::Limit)
        d.boundaryLimit = parseLimit("boundary", value);
}

static float parseWithin(std::string_view name, std::string_view text, float least, float most, const char* range) {
    const float value = parseNumber<float>(name, text, least, range);
    if (!(value <= most))
        throw base::Error("'" + std::string(text) + "' is no value for it", std::string(name), range);
    return value;
}

static void setSupport(SurfaceDefinition& d, std::string_view value) {
    const char* range = "give a finite length above 0, or 0 for supports from neighbours";
    const float support = parseNumber<float>("support", value, 0, range);
    if (!std::isfinite(support))
        throw base::Error("a support must be finite", "support", range);
    d.support = support;
}

namespace {

struct OptionRow {
    const char* name;
    std::string (*get)(const SurfaceDefinition&);
    void (*set)(SurfaceDefinition&, std::string_view);
};

} // namespace

using Definition = SurfaceDefinition;
static constexpr OptionRow options[] = {
    {"manifold", [](const Definition& d) -> std::string { return nameOf(d.manifold); },
     [](Definition& d, std::string_view v) { d.manifold = parseManifold(v); }},
    {"frame", [](const Definition& d) -> std::string { return nameOf(d.frame); },
     [](Definition& d, std::string_view v) { d.frame = parseFrame(v); }},
    {"weight", [](const Definition& d) -> std::string { return nameOf(d.weight); },
     [](Definition& d, std::string_view v) { d.weight = parseWeight(v); }},
    {"support", [](const Definition& d) { return printed(d.support); }, setSupport},
    {"neighbours", [](const Definition& d) { return printed(d.neighbours); },
     [](Definition& d, std::string_view v) {
         d.neighbours = parseNumber<int>("neighbours", v, 3, "give a whole number of at least 3");
     }},
    {"boundary",
     [](const Definition& d) {
         return d.boundary == Boundary::Limit ? printed(d.boundaryLimit) : std::string(nameOf(d.boundary));
     },
     setBoundary},
    {"boundary-limit", [](const Definition& d) { return printed(d.boundaryLimit); },
     [](Definition& d, std::string_view v) { d.boundaryLimit = parseLimit("boundary-limit", v); }},
    {"shrink-free", [](const Definition& d) -> std::string { return d.shrinkFree ? "on" : "off"; },
     [](Definition& d, std::string_view v) { d.shrinkFree = parseIn<bool>(switches, "shrink-free", v); }},
    {"one-sheet", [](const Definition& d) -> std::string { return d.oneSheet ? "on" : "off"; },
     [](Definition& d, std::string_view v) { d.oneSheet = parseIn<bool>(switches, "one-sheet", v); }},
    {"interpolating", [](const Definition& d) -> std::string { return d.interpolating ? "on" : "off"; },
     [](Definition& d, std::string_view v) { d.interpolating = parseIn<bool>(switches, "interpolating", v); }},
    {"curvature-spacings", [](const Definition& d) { return printed(d.curvatureSpacings); },
     [](Definition& d, std::string_view v) {
         d.curvatureSpacings = parseWithin("curvature-spacings", v, 0, 1000, "give a number from 0 to 1000");
     }},
    {"apss-beta", [](const Definition& d) { return printed(d.apssBeta); },
     [](Definition& d, std::string_view v) {
         d.apssBeta = parseWithin("apss-beta", v, 0, 1, "give a number from 0, planes, to 1, spheres");
     }},
    {"rimls-sigma", [](const Definition& d) { return printed(d.rimlsSigma); },
     [](Definition& d, std::string_view v) {
         d.rimlsSigma = parseWithin("rimls-sigma", v, 0.01f, 100, "give a number from 0.01 to 100");
     }},
};
static constexpr auto names = [] {
    std::array<const char*, std::size(options)> out{};
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = options[i].name;
    return out;
}();

std::span<const char* const> optionNames() {
    return names;
}

static const OptionRow& row(std::string_view name) {
    std::string known;
    for (const auto& candidate : options) {
        if (name == candidate.name)
            return candidate;
        known.append(known.empty() ? "" : ", ").append(candidate.name);
    }
    throw base::Error("unknown surface option '" + std::string(name) + "'", {}, "known are " + known);
}

std::string option(const SurfaceDefinition& definition, std::string_view name) {
    return row(name).get(definition);
}

void setOption(SurfaceDefinition& definition, std::string_view name, std::string_view value) {
    row(name).set(definition, value);
}

std::string toWords(const SurfaceDefinition& definition) {
    std::string out;
    for (const auto& each : options)
        out.append(out.empty() ? "" : " ").append(each.name).append("=").append(each.get(definition));
    return out;
}

SurfaceDefinition definitionFromWords(std::string_view words) {
    SurfaceDefinition out;
    while (true) {
        const std::size_t begin = words.find_first_not_of(" \t");
        if (begin == std::string_view::npos)
            return out;
        words.remove_prefix(begin);
        const std::string_view word = words.substr(0, words.find_first_of(" \t"));
        words.remove_prefix(word.size());
        const std::size_t equals = word.find('=');
        if (equals == std::string_view::npos)
            throw base::Error("'" + std::string(word) + "' is no surface option", {}, "write name=value");
        setOption(out, word.substr(0, equals), word.substr(equals + 1));
    }
}

} // namespace surface
