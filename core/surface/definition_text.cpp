#include "core/surface/definition_text.h"

#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/surface/definition_options.h"
#include "core/surface/frames/frame_table.h"

#include <array>

namespace surface {

static constexpr Named<Manifold> manifolds[] = {
    {Manifold::Surface, "surface"}, {Manifold::Curve, "curve"}, {Manifold::Complex, "complex"}};
static constexpr Named<Weight> weights[] = {
    {Weight::Wendland, "wendland"}, {Weight::WendlandC4, "wendland-c4"}, {Weight::Gaussian, "gaussian"}};
static constexpr auto frames = [] {
    std::array<Named<Frame>, std::size(frameTable)> out{};
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = {frameTable[i].frame, frameTable[i].name};
    return out;
}();
static constexpr Named<Boundary> boundaries[] = {
    {Boundary::Auto, "auto"}, {Boundary::Limit, "limit"}, {Boundary::None, "none"}};
static constexpr Named<Projector> projectors[] = {
    {Projector::Basic, "basic"}, {Projector::Almost, "almost"}, {Projector::Orthogonal, "orthogonal"}};

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
    return base::rowOf(table, name, {what, "", "known are %"}, &Named<E>::name).value;
}

const char* nameOf(Manifold manifold) {
    return nameIn(manifoldNames(), manifold);
}
std::string nounOf(Manifold manifold) {
    return std::string("a ") + nameOf(manifold);
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
    return parseIn(manifoldNames(), "unknown manifold '%'", name);
}
Weight parseWeight(std::string_view name) {
    return parseIn(weightNames(), "unknown weight '%'", name);
}
Frame parseFrame(std::string_view name) {
    return parseIn(frameNames(), "unknown frame '%'", name);
}
Projector parseProjector(std::string_view name) {
    return parseIn(projectorNames(), "unknown projection '%'", name);
}

std::string toWords(const SurfaceDefinition& definition, bool decided) {
    std::string out;
    for (const DefinitionOption& each : definitionOptionTable())
        if (decided || std::string_view(each.id) != "boundary-limit")
            out.append(out.empty() ? "" : " ").append(each.id).append("=").append(textOf(each, definition));
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
            throw base::Error("'" + std::string(word) + "' is not a surface option", {}, "write name=value");
        setText(definitionOption(word.substr(0, equals)), out, word.substr(equals + 1));
    }
}

} // namespace surface
