// glTF 2.0: all meshes and clouds of the file's scene where its nodes place them, with normals, colours and pictures
// (io/README 2.15).
#include "core/io/file_name.h"
#include "core/io/gltf/gltf_file.h"
#include "core/io/gltf/gltf_placement.h"
#include "core/io/pictures/face_pictures.h"
#include "core/io/readers.h"
#include "core/io/scene/scene_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace io {

namespace gltf {

namespace {

constexpr std::uint32_t noPoint = std::numeric_limits<std::uint32_t>::max();

class Scene {
  public:
    Scene(const GltfFile& from, const path& folder, const base::Progress& progress)
        : m_from(from), m_folder(folder), m_progress(progress), m_points(from.file(), from.size()) {}
    FileModel read();

  private:
    std::vector<std::size_t> roots() const;
    void walk();
    void addMesh(const json& mesh, const Placement& placement);
    void addPrimitive(const json& primitive, const Placement& placement, bool shared);
    std::optional<Accessor> cornersOf(const json& primitive) const;
    void pickRows(const json& primitive);
    void look(std::size_t i) const { // now and then, whether to go on
        if (i % 65536 == 0)
            m_progress.step(0.3, "Reading");
    }
    void addNormals(const json& attributes, const Placement& placement, std::size_t count, std::size_t first);
    void addColours(const json& primitive, std::size_t count, std::size_t first);
    void addColumns(const json& attributes, std::size_t count, std::size_t first);
    void addFaces(const json& primitive, std::size_t mode, bool mirrored, std::size_t count, std::uint32_t first);
    void addPictures(const json& primitive, std::size_t count, std::size_t corners, std::uint32_t first);
    void takePictures();
    std::optional<Accessor> attribute(const json& attributes, const char* name, std::size_t components,
                                      std::size_t count) const;

    const GltfFile& m_from;
    const path& m_folder;
    const base::Progress& m_progress;
    FileModel m_model;
    ScenePoints m_points;
    // Of the primitive that is read: its vertex list may serve others, too.
    std::size_t m_all = 0;             ///< vertices in its list
    bool m_picked = false;             ///< only those that it uses become points:
    std::vector<std::uint32_t> m_rows; ///< these, ascending
    bool m_left = false;               ///< primitives of lines
    bool m_pictured = false;           ///< some face has a picture
};

std::vector<std::size_t> Scene::roots() const {
    std::vector<std::size_t> out;
    const json& scene = m_from.named("scenes", countOf(member(m_from.root(), "scene")).value_or(0));
    for (const json& each : member(scene, "nodes"))
        out.push_back(countOf(each).value_or(noPoint));
    if (scene.is_object())
        return out;
    std::vector<bool> isChild(member(m_from.root(), "nodes").size()); // a library: every node that none has
    for (const json& node : member(m_from.root(), "nodes"))
        for (const json& child : member(node, "children"))
            if (const auto number = countOf(child); number && *number < isChild.size())
                isChild[*number] = true;
    for (std::size_t i = 0; i < isChild.size(); ++i)
        if (!isChild[i])
            out.push_back(i);
    return out;
}

/// Nodes are a forest: one that is met again is in a circle or has two parents, and stays where it was first.
void Scene::walk() {
    struct Waiting {
        std::size_t node;
        Placement placement;
    };
    std::vector<Waiting> waiting;
    const std::size_t count = member(m_from.root(), "nodes").size();
    std::vector<bool> met(count);
    const std::vector<std::size_t> first = roots();
    for (std::size_t i = first.size(); i-- > 0;)
        waiting.push_back({first[i], {}});
    while (!waiting.empty()) {
        m_progress.step(0.3, "Reading");
        const Waiting next = waiting.back();
        waiting.pop_back();
        if (next.node >= count || met[next.node])
            continue;
        met[next.node] = true;
        const json& node = m_from.named("nodes", next.node);
        const Placement placement = next.placement * placementOf(node);
        if (const auto mesh = countOf(member(node, "mesh")))
            addMesh(m_from.named("meshes", *mesh), placement);
        const json& children = member(node, "children");
        for (std::size_t i = children.is_array() ? children.size() : 0; i-- > 0;)
            waiting.push_back({countOf(children[i]).value_or(noPoint), placement});
    }
}

void Scene::addMesh(const json& mesh, const Placement& placement) {
    const auto listOf = [](const json& primitive) {
        return countOf(member(member(primitive, "attributes"), "POSITION")).value_or(noPoint);
    };
    std::map<std::size_t, std::size_t> users;
    for (const json& primitive : member(mesh, "primitives"))
        ++users[listOf(primitive)];
    for (const json& primitive : member(mesh, "primitives"))
        addPrimitive(primitive, placement, users[listOf(primitive)] > 1);
}

std::optional<Accessor> Scene::attribute(const json& attributes, const char* name, std::size_t components,
                                         std::size_t count) const {
    const auto number = countOf(member(attributes, name));
    if (!number)
        return std::nullopt;
    Accessor out = m_from.accessor(*number);
    if (out.components < components || out.count < (m_picked ? m_all : count))
        m_from.file().fail("the attribute " + inQuotes(name) + " has not as many numbers as its points need",
                           "the file is damaged; export it again");
    out.rows = m_picked ? &m_rows : nullptr;
    return out;
}

/// The numbers of vertices that are its corners; nothing where it takes them in their order.
std::optional<Accessor> Scene::cornersOf(const json& primitive) const {
    const auto number = countOf(member(primitive, "indices"));
    if (!number)
        return std::nullopt;
    const Accessor out = m_from.accessor(*number);
    if (out.normalised || out.components != 1 ||
        (out.type != ScalarType::UInt8 && out.type != ScalarType::UInt16 && out.type != ScalarType::UInt32))
        m_from.file().fail("the numbers of corners are no whole numbers", "the file is damaged; export it again");
    return out;
}

void Scene::pickRows(const json& primitive) {
    const std::optional<Accessor> corners = cornersOf(primitive);
    if (!corners)
        return;
    m_points.announce(corners->count);
    m_rows.clear();
    for (std::size_t i = 0; i < corners->count; ++i) {
        look(i);
        if (corners->index(i) < m_all)
            m_rows.push_back(corners->index(i));
    }
    std::sort(m_rows.begin(), m_rows.end());
    m_rows.erase(std::unique(m_rows.begin(), m_rows.end()), m_rows.end());
    m_picked = true;
}

/// `shared`: others have their vertices in the same list.
void Scene::addPrimitive(const json& primitive, const Placement& placement, bool shared) {
    const json& attributes = member(primitive, "attributes");
    const std::size_t mode = countOf(member(primitive, "mode")).value_or(4);
    m_picked = false;
    m_points.announce(1); // also without positions, as nodes may repeat it
    std::optional<Accessor> positions = attribute(attributes, "POSITION", 3, 0);
    if (!positions || (mode >= 1 && mode <= 3) || mode > 6) {
        m_left |= positions.has_value();
        return;
    }
    m_all = positions->count;
    if (shared && mode >= 4)
        pickRows(primitive);
    positions->rows = m_picked ? &m_rows : nullptr;
    const std::size_t count = m_picked ? m_rows.size() : m_all;
    const auto first = m_points.size();
    m_points.announce(count + 1);
    const bool stays = placement.onlyShifts() && placement.shift == base::Vec3d{}; // bit for bit, with the sign of zero
    for (std::size_t i = 0; i < count; ++i) {
        look(i);
        const base::Vec3d p{positions->at(i, 0), positions->at(i, 1), positions->at(i, 2)};
        m_points.add({stays ? p : placement(p), {}, surfel::white});
    }
    addNormals(attributes, placement, count, first);
    addColours(primitive, count, first);
    addColumns(attributes, count, first);
    if (mode >= 4)
        addFaces(primitive, mode, placement.mirrors(), count, first);
    m_progress.step(0.3, "Reading");
}

void Scene::addNormals(const json& attributes, const Placement& placement, std::size_t count, std::size_t first) {
    const std::optional<Accessor> normals = attribute(attributes, "NORMAL", 3, count);
    if (!normals)
        return;
    m_points.tellsNormals();
    if (placement.onlyShifts()) { // bit for bit
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                m_points[first + i].normal[k] = static_cast<float>(normals->at(i, k));
        return;
    }
    const base::Mat3d turn = base::cofactor(placement.linear) * (placement.mirrors() ? -1.0 : 1.0);
    for (std::size_t i = 0; i < count; ++i) {
        const base::Vec3d n = turn * base::Vec3d{normals->at(i, 0), normals->at(i, 1), normals->at(i, 2)};
        m_points[first + i].normal = base::cast<float>(base::normalized(n, base::Vec3d{}));
    }
}

/// COLOR_0 times the material's factor, both of which are linear.
void Scene::addColours(const json& primitive, std::size_t count, std::size_t first) {
    const std::optional<Accessor> colours = attribute(member(primitive, "attributes"), "COLOR_0", 3, count);
    const json& paint = member(m_from.named("materials", countOf(member(primitive, "material")).value_or(noPoint)),
                               "pbrMetallicRoughness");
    std::array<double, 4> factor{1, 1, 1, 1};
    for (std::size_t k = 0; k < 4; ++k)
        factor[k] = numberOf(entry(member(paint, "baseColorFactor"), k), 1);
    const bool pictured = member(paint, "baseColorTexture").is_object();
    if (!colours && (pictured || factor == std::array<double, 4>{1, 1, 1, 1}))
        return;
    m_points.tellsColours();
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 4> colour = factor;
        for (std::size_t k = 0; colours && k < colours->components && k < 4; ++k)
            colour[k] *= colours->at(i, k);
        m_points[first + i].colour = srgbOf(colour);
    }
}

/// Attributes of a program's own begin with an underscore.
void Scene::addColumns(const json& attributes, std::size_t count, std::size_t first) {
    if (!attributes.is_object())
        return;
    for (const auto& [key, number] : attributes.items()) {
        if (!key.starts_with("_") || key.size() < 2)
            continue;
        const std::optional<Accessor> values = attribute(attributes, key.c_str(), 1, count);
        std::string name = key.substr(1);
        if (std::none_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; }))
            name = lowerCase(name);
        for (std::size_t c = 0; values && c < values->components; ++c) {
            m_points.announce(count); // which may be the same bytes under many names
            std::vector<double> column(count);
            for (std::size_t i = 0; i < count; ++i)
                column[i] = values->at(i, c);
            m_points.set(values->components == 1 ? name : name + "_" + std::to_string(c + 1),
                         values->normalised ? ScalarType::Float32 : values->type, first, column);
        }
    }
}

void Scene::addFaces(const json& primitive, std::size_t mode, bool mirrored, std::size_t count, std::uint32_t first) {
    const std::optional<Accessor> indices = cornersOf(primitive);
    const std::size_t corners = indices ? indices->count : count;
    m_points.announce(corners); // not points, but as many as are read again for each node
    const auto corner = [&](std::size_t i) {
        look(i);
        const std::size_t at = indices ? indices->index(i) : i;
        if (m_picked) {
            const auto found = std::lower_bound(m_rows.begin(), m_rows.end(), at);
            return found != m_rows.end() && *found == at ? first + static_cast<std::uint32_t>(found - m_rows.begin())
                                                         : noPoint;
        }
        return at < count ? first + static_cast<std::uint32_t>(at) : noPoint;
    };
    mesh::Polygons& faces = m_model.polygons;
    const std::size_t before = faces.corners.size();
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        faces.corners.insert(faces.corners.end(), {a, mirrored ? c : b, mirrored ? b : c});
        faces.close();
    };
    if (mode == 4)
        for (std::size_t i = 0; i + 2 < corners; i += 3)
            add(corner(i), corner(i + 1), corner(i + 2));
    else
        for (std::size_t i = 0; i + 2 < corners; ++i)
            add(corner(mode == 6 ? 0 : i), corner(i + (mode == 5 && i % 2 == 1 ? 2 : 1)),
                corner(i + (mode == 5 && i % 2 == 1 ? 1 : 2)));
    addPictures(primitive, count, before, first);
}

/// Of the faces whose corners come behind `corners`.
void Scene::addPictures(const json& primitive, std::size_t count, std::size_t corners, std::uint32_t first) {
    mesh::Polygons& faces = m_model.polygons;
    const std::size_t material = countOf(member(primitive, "material")).value_or(noPoint);
    const json& texture =
        member(member(m_from.named("materials", material), "pbrMetallicRoughness"), "baseColorTexture");
    const json& transform = member(member(texture, "extensions"), "KHR_texture_transform");
    const std::size_t set =
        countOf(member(transform, "texCoord")).value_or(countOf(member(texture, "texCoord")).value_or(0));
    const auto image =
        countOf(member(m_from.named("textures", countOf(member(texture, "index")).value_or(noPoint)), "source"));
    const std::optional<Accessor> places =
        image ? attribute(member(primitive, "attributes"), ("TEXCOORD_" + std::to_string(set)).c_str(), 2, count)
              : std::nullopt;
    PicturePlace place;
    place.turn = numberOf(member(transform, "rotation"), 0);
    for (std::size_t k = 0; k < 2; ++k) {
        place.offset[k] = numberOf(entry(member(transform, "offset"), k), 0);
        place.scale[k] = numberOf(entry(member(transform, "scale"), k), 1);
    }
    faces.pictureOf.resize(faces.size(), places ? static_cast<std::uint32_t>(std::min<std::size_t>(*image, noPoint))
                                                : mesh::Polygons::noPicture);
    for (std::size_t i = corners; i < faces.corners.size(); ++i) {
        const std::uint32_t at = faces.corners[i];
        faces.places.push_back(places && at != noPoint ? place(places->at(at - first, 0), places->at(at - first, 1))
                                                       : mesh::Polygons::Place());
    }
    m_pictured |= places.has_value();
}

void Scene::takePictures() {
    mesh::Polygons& faces = m_model.polygons;
    if (!m_pictured) {
        faces.pictureOf.clear();
        faces.places.clear();
        return;
    }
    std::vector<PictureName> names;
    std::vector<std::unique_ptr<std::string>> texts;
    const json& images = member(m_from.root(), "images");
    for (std::size_t i = 0; i < (images.is_array() ? images.size() : 0); ++i) {
        const std::string uri = textOf(member(images[i], "uri"));
        PictureName name{uri.starts_with("data:") || uri.empty() ? "image " + std::to_string(i) : withoutPercents(uri)};
        name.inside = uri.empty() || uri.starts_with("data:") || member(images[i], "bufferView").is_number();
        if (const auto view = countOf(member(images[i], "bufferView")))
            name.bytes = m_from.view(*view);
        else if (uri.starts_with("data:"))
            name.bytes = *texts.emplace_back(std::make_unique<std::string>(GltfFile::embedded(uri)));
        names.push_back(name);
    }
    constexpr std::size_t clampToEdge = 33071;
    for (const json& texture : member(m_from.root(), "textures")) {
        const json& sampler = m_from.named("samplers", countOf(member(texture, "sampler")).value_or(noPoint));
        if (const auto source = countOf(member(texture, "source")); source && *source < names.size())
            names[*source].clamped |= countOf(member(sampler, "wrapS")) == clampToEdge;
    }
    readPictures(m_model, m_folder, names, m_progress);
}

FileModel Scene::read() {
    walk();
    if (m_points.size() == 0)
        m_from.file().fail("holds no points", "choose a file whose scene shows a mesh or a cloud");
    m_model.format = m_from.file().bytes().starts_with("glTF") ? "glb" : "gltf";
    m_model.faces = m_model.polygons.size();
    m_model.comments.emplace_back("unit meter");
    if (m_left)
        m_model.messages.emplace_back("Lines of the scene were left out.");
    takePictures();
    m_points.finish(m_model, {m_progress, 0.5, 1});
    return std::move(m_model);
}

} // namespace
} // namespace gltf

FileModel readGltf(const FileBytes& file, const base::Progress& progress, const path& folder) {
    progress.step(0, "Reading");
    const gltf::GltfFile from(file, folder);
    return gltf::Scene(from, folder, progress).read();
}

} // namespace io
