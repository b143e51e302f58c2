#include "core/session/scene/scene.h"

#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/selection/affine.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace session {

using process::Rigid;

int Scene::indexOf(std::string_view name) const {
    const auto found = std::ranges::find(models, name, &SceneModel::name);
    return found == models.end() ? -1 : static_cast<int>(found - models.begin());
}

int Scene::indexOf(std::uint32_t id) const {
    const auto found = std::ranges::find(models, id, &SceneModel::id);
    return found == models.end() ? -1 : static_cast<int>(found - models.begin());
}

std::size_t Scene::find(const std::string& name) const {
    const int index = indexOf(std::string_view(name));
    if (index >= 0)
        return static_cast<std::size_t>(index);
    std::vector<std::string> known;
    for (const SceneModel& each : models)
        known.push_back("\"" + each.name + "\"");
    throw base::Error("there is no model \"" + name + "\" in the scene", {}, "known are " + base::listed(known));
}

std::string Scene::freshName(const std::string& wanted) const {
    std::string out = wanted;
    for (int number = 2; indexOf(out) >= 0; ++number)
        out = wanted + " " + std::to_string(number);
    return out;
}

void refuseChange(const SceneModel& model) {
    if (model.locked)
        throw base::Error("\"" + model.name + "\" is locked", {}, "unlock it first, or activate another model");
    if (!model.visible)
        throw base::Error("\"" + model.name + "\" is hidden", {}, "show it first, or activate another model");
}

bool isModelName(const std::string& name) {
    return layers::isName(name);
}

std::string nameOf(const std::filesystem::path& file) {
    std::string out = file.stem().string();
    return isModelName(out) ? out : "Model";
}

bool isNothing(const Rigid& pose) {
    return selection::Affine{pose.rotation, pose.translation}.isNothing();
}

Rigid between(const SceneModel& from, const SceneModel& to) {
    // Differences first: the origins may be large, and near each other.
    const Rigid files = to.pose.inverse() * from.pose;
    return {files.rotation, files.rotation * from.origin() - to.origin() + files.translation};
}

std::vector<double> matrixOf(const Rigid& pose) {
    const base::Mat3d& r = pose.rotation;
    const base::Vec3d& t = pose.translation;
    return {r[0][0], r[0][1], r[0][2], t.x, r[1][0], r[1][1], r[1][2], t.y, r[2][0], r[2][1], r[2][2], t.z, 0, 0, 0, 1};
}

Rigid poseOf(const std::vector<double>& m) {
    constexpr double roundOff = 1e-6;
    if (m.size() != 16 || !std::ranges::all_of(m, [](double v) { return std::isfinite(v); }))
        throw base::Error("a pose is 16 finite numbers, a matrix by row");
    const Rigid out{{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}}, {m[3], m[7], m[11]}};
    const base::Mat3d off = out.rotation * transposed(out.rotation);
    bool rigid = m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1 && base::determinant(out.rotation) > 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            rigid &= std::abs(off[r][c] - (r == c ? 1 : 0)) <= roundOff;
    if (!rigid)
        throw base::Error("a pose only turns and moves", {}, "scale or mirror the model itself, with \"transform\"");
    return out;
}

surface::Surface placed(const surface::Surface& surface, const Rigid& motion) {
    return selection::transformed(surface, {motion.rotation, motion.translation}, selection::Limit::Everything);
}

io::FileModel fileModel(const SceneModel& model) {
    const Provenance& provenance = *model.provenance;
    io::FileModel out;
    out.points = model.surface.tree().surfels();
    out.shape = model.surface.tree().shape();
    out.origin = provenance.origin;
    out.up = model.up;
    out.definition = model.surface.definition();
    out.hasSupports = out.limitDecided = true;
    out.faces = provenance.faces;
    out.dropped = provenance.dropped;
    out.format = provenance.format;
    out.comments = provenance.comments;
    for (std::string& line : layers::linesOf(model.layers))
        out.comments.push_back(std::move(line));
    out.elements = provenance.elements;
    return out;
}

static void appendWords(std::vector<std::uint32_t>& words, std::string_view text) {
    words.push_back(static_cast<std::uint32_t>(text.size()));
    for (const char c : text)
        words.push_back(static_cast<unsigned char>(c));
}

static void appendWords(std::vector<std::uint32_t>& words, std::uint64_t bits) {
    words.push_back(static_cast<std::uint32_t>(bits));
    words.push_back(static_cast<std::uint32_t>(bits >> 32));
}

static void appendWords(std::vector<std::uint32_t>& words, double number) {
    appendWords(words, std::bit_cast<std::uint64_t>(number + 0.0)); // -0 and 0 are the same place
}

static base::Hash128 layoutHash(const surfel::AttributeLayout& layout) {
    std::vector<std::uint32_t> words;
    for (const std::string& name : layout.names()) {
        appendWords(words, name);
        const surfel::Attribute* attribute = layout.find(name);
        words.push_back(attribute ? static_cast<std::uint32_t>(attribute->type) : ~0u);
    }
    return base::hashWords(words);
}

static base::Hash128 originHash(const base::Vec3d& origin) {
    std::vector<std::uint32_t> words;
    for (std::size_t k = 0; k < 3; ++k)
        appendWords(words, origin[k]);
    return base::hashWords(words);
}

static base::Hash128 layersHash(const layers::Stack& stack) {
    std::vector<std::uint32_t> words;
    for (const std::string& line : layers::linesOf(stack))
        appendWords(words, line);
    return base::hashWords(words);
}

base::Hash128 contentHash(const tree::SurfelTree& tree, const base::Vec3d& origin, const layers::Stack& stack) {
    base::Hash128 out = tree.contentHash();
    out += layoutHash(*tree.layout());
    out += originHash(origin);
    if (!stack.empty())
        out += layersHash(stack);
    return out;
}

/// How it stands in the scene belongs to its content: exchanged poses are another scene.
static base::Hash128 placedHash(const SceneModel& model) {
    const base::Hash128 content = contentHash(model.surface.tree(), model.origin(), model.layers);
    std::vector<std::uint32_t> words;
    appendWords(words, content.lo);
    appendWords(words, content.hi);
    appendWords(words, model.name);
    for (const double number : matrixOf(model.pose))
        appendWords(words, number);
    words.push_back(model.visible ? 1 : 0);
    words.push_back(model.locked ? 1 : 0);
    return base::hashWords(words);
}

base::Hash128 contentHash(const Scene& scene) {
    const SceneModel& first = scene.models.front();
    if (scene.models.size() == 1 && isNothing(first.pose))
        return contentHash(first.surface.tree(), first.origin(), first.layers);
    base::Hash128 out;
    for (const SceneModel& each : scene.models)
        out += placedHash(each);
    return out;
}

std::size_t unsharedBytes(const Scene& version, const Scene& other) {
    std::size_t out = 0;
    for (const SceneModel& each : version.models) {
        const int same = other.indexOf(each.id);
        const tree::SurfelTree none;
        out += tree::unsharedBytes(each.surface.tree(),
                                   same < 0 ? none : other.models[static_cast<std::size_t>(same)].surface.tree());
    }
    return out;
}

} // namespace session
