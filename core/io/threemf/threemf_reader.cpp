// 3MF: all that the package is to build, placed as its items and components say, with colours and pictures
// (io/README 2.16).
#include "core/io/packed/inflate.h"
#include "core/io/pictures/face_pictures.h"
#include "core/io/readers.h"
#include "core/io/threemf/threemf_parts.h"

#include <algorithm>
#include <map>

namespace io {

namespace threemf {

namespace {

const char* const damaged = "the file is damaged; export it again";

class Package {
  public:
    Package(const FileBytes& file, const base::Progress& progress)
        : m_file(file), m_progress(progress), m_entries(zipEntries(file)), m_points(file, file.size()) {}
    FileModel read();

  private:
    const Part& part(const std::string& name);
    void build(const std::string& in, const Placed& placed, const Placement& outer, int depth);
    void addMesh(const std::string& in, const Object& object, const Placement& placement);
    void addLook(const std::string& in, const Triangle& triangle, bool mirrored);
    std::uint32_t pictureOf(const std::string& in, std::uint32_t id);
    void colour();
    void takePictures();
    void look(std::size_t i) const { // now and then, whether to go on
        if (i % 65536 == 0)
            m_progress.step(0.4, "Reading");
    }

    const FileBytes& m_file;
    const base::Progress& m_progress;
    std::vector<ZipEntry> m_entries;
    std::size_t m_left = mostInflated(m_file.size()); ///< bytes that entries may still become
    std::map<std::string, Part> m_parts;
    FileModel m_model;
    ScenePoints m_points;
    std::vector<surfel::Colour> m_colours; ///< of corners
    bool m_coloured = false, m_pictured = false;
    std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> m_pictureNumbers;
    std::vector<Picture> m_pictures;
};

const Part& Package::part(const std::string& name) {
    const auto known = m_parts.find(name);
    if (known != m_parts.end())
        return known->second;
    for (const ZipEntry& entry : m_entries)
        if (entry.name == name)
            return m_parts[name] = readPart(m_file, entry, m_left, m_progress);
    m_file.fail("has no part " + inQuotes(name) + ", or it is encrypted", damaged);
}

void Package::build(const std::string& in, const Placed& placed, const Placement& outer, int depth) {
    constexpr int deepest = 32;
    m_progress.step(0.4, "Reading");
    m_points.announce(1);
    const std::string& name = placed.part.empty() ? in : placed.part;
    const Part& from = part(name);
    const auto object = from.objects.find(placed.object);
    if (object == from.objects.end() || depth > deepest)
        m_file.fail(depth > deepest ? "its objects are made of each other without end"
                                    : "an object is to be built that is not there",
                    damaged);
    const Placement placement = outer * placed.placement;
    addMesh(name, object->second, placement);
    for (const Placed& each : object->second.components)
        build(name, each, placement, depth + 1);
}

void Package::addMesh(const std::string& in, const Object& object, const Placement& placement) {
    m_points.announce(std::max(object.vertices.size(), object.triangles.size()));
    const std::uint32_t first = m_points.size();
    for (std::size_t i = 0; i < object.vertices.size(); ++i) {
        look(i);
        m_points.add({placement(object.vertices[i]), {}, surfel::white});
    }
    const bool mirrored = placement.mirrors();
    mesh::Polygons& faces = m_model.polygons;
    for (std::size_t i = 0; i < object.triangles.size(); ++i) {
        look(i);
        const Triangle& triangle = object.triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = triangle.corners[mirrored ? 2 - k : k];
            faces.corners.push_back(corner < object.vertices.size() ? first + corner : nothing);
        }
        faces.close();
        addLook(in, triangle, mirrored);
    }
}

void Package::addLook(const std::string& in, const Triangle& triangle, bool mirrored) {
    const auto& groups = part(in).groups;
    const auto found = groups.find(triangle.group);
    const Group* const group = found == groups.end() ? nullptr : &found->second;
    mesh::Polygons& faces = m_model.polygons;
    const bool pictured = group && !group->places.empty();
    faces.pictureOf.push_back(pictured ? pictureOf(in, group->picture) : mesh::Polygons::noPicture);
    m_pictured |= pictured;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t property = triangle.properties[mirrored ? 2 - k : k];
        const bool coloured = group && property < group->colours.size();
        m_coloured |= coloured;
        m_colours.push_back(coloured ? group->colours[property] : surfel::white);
        faces.places.push_back(pictured && property < group->places.size() ? group->places[property]
                                                                           : mesh::Polygons::Place());
    }
}

std::uint32_t Package::pictureOf(const std::string& in, std::uint32_t id) {
    const auto& pictures = part(in).pictures;
    const auto found = pictures.find(id);
    if (found == pictures.end())
        return mesh::Polygons::noPicture;
    const auto [at, fresh] = m_pictureNumbers.try_emplace({in, id}, static_cast<std::uint32_t>(m_pictures.size()));
    if (fresh)
        m_pictures.push_back(found->second);
    return at->second;
}

static surfel::Colour meanOf(const surfel::Colour* three) {
    surfel::Colour out = 0;
    for (unsigned shift = 0; shift < 32; shift += 8)
        out |= ((three[0] >> shift & 255) + (three[1] >> shift & 255) + (three[2] >> shift & 255) + 1) / 3 << shift;
    return out;
}

/// Colours stand at corners. Where all corners of each point agree they are the points', else the faces'.
void Package::colour() {
    if (!m_coloured)
        return;
    mesh::Polygons& faces = m_model.polygons;
    std::vector<bool> met(m_points.size());
    bool agree = true;
    for (std::size_t i = 0; agree && i < faces.corners.size(); ++i) {
        look(i);
        const std::uint32_t at = faces.corners[i];
        if (at == nothing)
            continue;
        agree = !met[at] || m_points[at].colour == m_colours[i];
        met[at] = true;
        m_points[at].colour = m_colours[i];
    }
    if (agree)
        return m_points.tellsColours();
    for (std::size_t i = 0; i < faces.corners.size(); i += 3)
        faces.colours.push_back(meanOf(m_colours.data() + i));
}

void Package::takePictures() {
    mesh::Polygons& faces = m_model.polygons;
    if (!m_pictured) {
        faces.pictureOf.clear();
        faces.places.clear();
        return;
    }
    std::map<std::string, std::string> contents; // of entries, which many pictures may be
    std::vector<PictureName> names;
    for (const Picture& picture : m_pictures) {
        m_progress.step(0.45, "Reading");
        const auto [at, fresh] = contents.try_emplace(picture.entry);
        for (auto entry = m_entries.begin(); fresh && entry != m_entries.end(); ++entry)
            if (entry->name == picture.entry) {
                const auto append = [&to = at->second](std::string_view piece) { to.append(piece); };
                unpackWithin(m_file, *entry, m_left, m_progress, append);
                break;
            }
        names.push_back({picture.entry, picture.clamped, at->second, true});
    }
    readPictures(m_model, {}, names, m_progress);
}

FileModel Package::read() {
    std::string root = rootPart(m_file, m_entries, m_left, m_progress);
    for (const ZipEntry& entry : m_entries) // where the package does not tell
        if (root.empty() && entry.name.ends_with(".model"))
            root = entry.name;
    if (root.empty())
        m_file.fail("is a ZIP archive without a 3D model", "choose a 3MF file, or unpack the archive");
    const std::vector<Placed> items = part(root).build;
    for (const Placed& item : items)
        build(root, item, {}, 0);
    if (items.empty())
        for (const auto& [id, object] : part(root).objects)
            build(root, {"", id, {}}, {}, 0);
    if (m_points.size() == 0)
        m_file.fail("holds no points", "choose a file with a mesh in it");
    m_model.format = "3mf";
    m_model.faces = m_model.polygons.size();
    m_model.comments.push_back("unit " + part(root).unit);
    colour();
    takePictures();
    m_points.finish(m_model, {m_progress, 0.5, 1});
    return std::move(m_model);
}

} // namespace
} // namespace threemf

FileModel read3mf(const FileBytes& file, const base::Progress& progress, const path&) {
    progress.step(0, "Reading");
    if (!file.bytes().starts_with("PK"))
        file.fail("is no 3MF file", "choose one that is a ZIP archive with a 3D model");
    return threemf::Package(file, progress).read();
}

} // namespace io
