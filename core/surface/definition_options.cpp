#include "core/surface/definition_options.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/base/short_number.h"
#include "core/surface/definition_text.h"

#include <charconv>

namespace surface {

std::span<const DefinitionOption> definitionOptionTable() {
    using D = SurfaceDefinition;
    using R = DefinitionRange;
    static const DefinitionOption rows[] = {
        {"manifold", "",
         "what the points sample; a complex: patches, curves and corners that are glued to each other, as the file "
         "tells",
         &D::manifold},
        {"frame", "", "where the normal of the local plane comes from", &D::frame},
        {"weight", "", "how a point's weight falls off with distance", &D::weight},
        {"support",
         "model units",
         "one support radius for all points; for the gaussian the scale H in exp(-s^2/H^2)",
         &D::support,
         {R::aboveZero, R::largest, true},
         "give a finite length above 0, or 0 for supports from neighbours"},
        {"neighbours",
         "",
         "a support radius per point that holds about this many neighbours",
         &D::neighbours,
         {3, 10000},
         nullptr,
         ChosenBy::Person,
         "support"},
        {"boundary",
         "h",
         "off-centre limit beyond which an open surface ends",
         BoundaryField{},
         {R::aboveZero, R::largest},
         "give auto, none or a limit above 0 in units of h"},
        {"boundary-limit",
         "h",
         "limit that the boundary auto was resolved to for this model",
         &D::boundaryLimit,
         {R::aboveZero, std::numeric_limits<float>::infinity()},
         "give auto, none or a limit above 0 in units of h",
         ChosenBy::Estimate},
        {"known-rims",
         "",
         "the attribute rim tells beside which surfels the surface ends",
         &D::knownRims,
         {},
         nullptr,
         ChosenBy::Estimate},
        {"shrink-free", "", "symmetric form that does not erode the model", &D::shrinkFree},
        {"one-sheet", "", "second pass that keeps nearby sheets apart", &D::oneSheet},
        {"interpolating", "", "weights that make the surface pass through the points", &D::interpolating},
        {"curvature-spacings",
         "spacings",
         "smallest support radius on which curvature is measured, for supports from neighbours",
         &D::curvatureSpacings,
         {0, 1000}},
        {"apss-beta",
         "",
         "what the frame apss fits: 1 spheres, 0 planes",
         &D::apssBeta,
         {0, 1},
         "give a number from 0 (planes) to 1 (spheres)"},
        {"rimls-sigma",
         "",
         "how far normals may differ on one side of an edge, for the frame rimls",
         &D::rimlsSigma,
         {0.01, 100}},
    };
    return rows;
}

const DefinitionOption& definitionOption(std::string_view id) {
    return base::rowOf(definitionOptionTable(), id, {"unknown surface option '%'", "", "known are %"});
}

template <class E>
static std::string joined(std::span<const Named<E>> names) {
    std::string out;
    for (const auto& row : names)
        out.append(out.empty() ? "" : " ").append(row.name);
    return out;
}

std::string choicesOf(const DefinitionOption& option) {
    struct Choices {
        std::string operator()(Manifold SurfaceDefinition::*) const { return joined(manifoldNames()); }
        std::string operator()(Frame SurfaceDefinition::*) const { return joined(frameNames()); }
        std::string operator()(Weight SurfaceDefinition::*) const { return joined(weightNames()); }
        std::string operator()(BoundaryField) const {
            return std::string(nameOf(Boundary::Auto)) + " " + nameOf(Boundary::None);
        }
        std::string operator()(float SurfaceDefinition::*) const { return {}; }
        std::string operator()(int SurfaceDefinition::*) const { return {}; }
        std::string operator()(bool SurfaceDefinition::*) const { return {}; }
    };
    return std::visit(Choices{}, option.field);
}

// --- values as words ---

template <class Number>
static std::string printed(Number value) {
    char out[40];
    const auto end = std::to_chars(out, out + sizeof out, value).ptr;
    return {out, end};
}

static std::string wordOf(float value) {
    return printed(value);
}
static std::string wordOf(int value) {
    return printed(value);
}
static std::string wordOf(bool value) {
    return value ? "on" : "off";
}
template <class Named>
static std::string wordOf(Named value) {
    return nameOf(value);
}

std::string textOf(const DefinitionOption& option, const SurfaceDefinition& definition) {
    if (std::holds_alternative<BoundaryField>(option.field))
        return definition.boundary == Boundary::Limit ? printed(definition.boundaryLimit) : nameOf(definition.boundary);
    return std::visit(
        [&](auto field) -> std::string {
            if constexpr (std::is_same_v<decltype(field), BoundaryField>)
                return {};
            else
                return wordOf(definition.*field);
        },
        option.field);
}

// --- words as values ---

static std::string wishOf(const DefinitionOption& option, const char* what) {
    if (option.wish)
        return option.wish;
    const double min = static_cast<double>(option.range.min), max = static_cast<double>(option.range.max);
    return std::string("give a ") + what + " from " + base::shortNumber(min) + " to " + base::shortNumber(max);
}

template <class Number>
static Number numberIn(const DefinitionOption& option, std::string_view word, const char* what) {
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const DefinitionRange& range = option.range;
    const bool low = range.min == DefinitionRange::aboveZero ? value > 0 : value >= static_cast<Number>(range.min);
    const bool within = low && double(value) <= double(static_cast<Number>(range.max));
    const bool known = error == std::errc() && end == word.data() + word.size();
    if (!known || !(within || (range.orZero && value == 0)))
        throw base::Error("'" + std::string(word) + "' is not a valid value", option.id, wishOf(option, what));
    return value;
}

static void read(const DefinitionOption&, std::string_view word, Manifold& out) {
    out = parseManifold(word);
}
static void read(const DefinitionOption&, std::string_view word, Frame& out) {
    out = parseFrame(word);
}
static void read(const DefinitionOption&, std::string_view word, Weight& out) {
    out = parseWeight(word);
}
static void read(const DefinitionOption& option, std::string_view word, float& out) {
    out = numberIn<float>(option, word, "number");
}
static void read(const DefinitionOption& option, std::string_view word, int& out) {
    out = numberIn<int>(option, word, "whole number");
}
static void read(const DefinitionOption& option, std::string_view word, bool& out) {
    if (word != "on" && word != "off")
        throw base::Error("unknown " + std::string(option.id) + " '" + std::string(word) + "'", {},
                          "known are on, off");
    out = word == "on";
}

static void readBoundary(const DefinitionOption& option, std::string_view word, SurfaceDefinition& out) {
    const Boundary named = word == nameOf(Boundary::Auto)   ? Boundary::Auto
                           : word == nameOf(Boundary::None) ? Boundary::None
                                                            : Boundary::Limit;
    out.boundaryLimit =
        named == Boundary::Limit ? numberIn<float>(option, word, "number") : std::numeric_limits<float>::infinity();
    out.boundary = named;
}

void setText(const DefinitionOption& option, SurfaceDefinition& definition, std::string_view word) {
    const auto set = [&](auto field) {
        if constexpr (std::is_same_v<decltype(field), BoundaryField>)
            readBoundary(option, word, definition);
        else
            read(option, word, definition.*field);
    };
    std::visit(set, option.field);
}

} // namespace surface
