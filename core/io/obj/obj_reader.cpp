// Wavefront OBJ: its vertices and faces, these with pictures and colours of their materials (obj_materials.h); vertices
// with colours where `v` carries them, and normals where `vn` can be told to belong to vertices: by the corners of
// faces (corners of one vertex that disagree are averaged), else by equal counts.
#include "core/io/obj/obj_materials.h"
#include "core/io/obj/obj_statements.h"
#include "core/io/readers.h"
#include "core/io/record_points.h"
#include "core/io/text/text_lines.h"

#include <algorithm>

namespace io {

namespace {

constexpr std::uint32_t noNormal = std::numeric_limits<std::uint32_t>::max();

/// A vertex and a normal that a corner of a face brings together.
struct Corner {
    std::uint32_t vertex, normal;
    auto operator<=>(const Corner&) const = default;
};

struct Counts {
    std::size_t vertices = 0, normals = 0, textures = 0, faces = 0;
    Counts& operator+=(const Counts& o) {
        vertices += o.vertices, normals += o.normals, textures += o.textures, faces += o.faces;
        return *this;
    }
};

class ObjReader {
  public:
    ObjReader(const FileBytes& file, const base::Progress& progress, const path& folder)
        : m_file(file), m_lines(m_file, 0), m_progress(progress), m_folder(folder), m_before(m_lines.chunks() + 1),
          m_materials(m_lines.chunks() + 1), m_libraries(m_lines.chunks()), m_corners(m_lines.chunks()),
          m_textureOf(m_lines.chunks()), m_faces(m_lines.chunks()) {}
    FileModel read();

  private:
    void count();
    void findMaterials();
    std::uint32_t materialOf(std::string_view name) const;
    void joinFaces();
    void placeInPictures(mesh::Polygons& faces, const std::vector<std::uint32_t>& textures) const;
    void colourFaces();
    std::size_t parse(std::size_t chunk);
    void takeFace(std::string_view line, const Counts& at, std::size_t chunk);
    bool takeCorner(std::string_view word, const Counts& at, Corner& out) const;
    std::uint32_t takeTexture(std::string_view word, const Counts& at) const;
    std::vector<base::Vec3d> vertexNormals();
    std::vector<base::Vec3d> normalsByCorners();
    void fillTable(const std::vector<base::Vec3d>& normals);
    const Counts& all() const { return m_before.back(); }

    const FileBytes& m_file;
    TextLines m_lines;
    const base::Progress& m_progress;
    const path& m_folder; ///< of materials and pictures
    FileModel m_model;
    std::vector<Counts> m_before; ///< statements before each chunk
    std::size_t m_width = 3;      ///< numbers of a vertex: 6 with colours
    std::vector<double> m_vertices;
    std::vector<base::Vec3d> m_normals;
    /// Materials as the text has them: the last one named before the end of each chunk; empty where none is.
    std::vector<std::string_view> m_materials;
    std::vector<std::vector<std::string>> m_libraries;           ///< per chunk
    std::vector<ObjMaterial> m_painting;                         ///< the materials that paint faces
    std::map<std::string, std::uint32_t, std::less<>> m_numbers; ///< of these, by their names
    bool m_pictured = false;                                     ///< some have pictures, and corners places in them
    std::vector<mesh::Polygons::Place> m_textures;
    std::vector<std::vector<Corner>> m_corners;          ///< per chunk
    std::vector<std::vector<std::uint32_t>> m_textureOf; ///< per chunk, of the faces' corners
    std::vector<mesh::Polygons> m_faces;                 ///< per chunk
    RecordTable m_table;
};

void ObjReader::count() {
    std::vector<std::size_t> first(m_lines.chunks(), TextLines::none);
    m_lines.run({m_progress, 0, 0.2}, [&](std::size_t chunk) {
        Counts& counts = m_before[chunk + 1];
        m_lines.forLines(chunk, [&](std::size_t at, std::string_view line) {
            const Statement statement = takeStatement(line);
            counts.vertices += statement == Statement::Vertex ? 1 : 0;
            counts.normals += statement == Statement::Normal ? 1 : 0;
            counts.textures += statement == Statement::Texture ? 1 : 0;
            counts.faces += statement == Statement::Face ? 1 : 0;
            if (statement == Statement::Material)
                m_materials[chunk + 1] = trimmed(line);
            else if (statement == Statement::Library)
                m_libraries[chunk].emplace_back(trimmed(line));
            if (statement == Statement::Vertex)
                first[chunk] = std::min(first[chunk], at);
            return true;
        });
        return TextLines::none;
    });
    for (std::size_t chunk = 0; chunk < m_lines.chunks(); ++chunk) {
        m_before[chunk + 1] += m_before[chunk];
        if (m_materials[chunk + 1].empty())
            m_materials[chunk + 1] = m_materials[chunk];
    }
    if (all().vertices == 0)
        m_file.fail("holds no points", "choose an OBJ file with 'v' lines");
    if (all().vertices >= noNormal || all().normals >= noNormal || all().textures >= noNormal)
        m_file.fail("holds more than 4 billion vertices", "split the file");
    std::string_view line = m_lines.lineAt(*std::min_element(first.begin(), first.end()));
    takeStatement(line);
    double numbers[8];
    m_width = takeNumbers(line, numbers, 8) >= 6 ? 6 : 3;
}

/// The materials that faces can have.
void ObjReader::findMaterials() {
    std::vector<std::string> libraries;
    for (const auto& chunk : m_libraries)
        libraries.insert(libraries.end(), chunk.begin(), chunk.end());
    if (all().faces == 0)
        return;
    for (auto& [name, material] : readMaterials(m_folder, libraries, m_model.messages)) {
        m_numbers[name] = static_cast<std::uint32_t>(m_painting.size());
        m_pictured |= all().textures > 0 && !material.picture.file.empty();
        m_painting.push_back(material);
    }
}

std::uint32_t ObjReader::materialOf(std::string_view name) const {
    const auto found = m_numbers.find(name);
    return found == m_numbers.end() ? mesh::Polygons::noPicture : found->second;
}

/// The corner "v", "v/t", "v//n" or "v/t/n": false where it does not bring a vertex and a normal together.
bool ObjReader::takeCorner(std::string_view word, const Counts& at, Corner& out) const {
    const std::size_t slash = word.rfind('/');
    if (!takeIndex(word.substr(0, word.find('/')), at.vertices, all().vertices, out.vertex)) {
        out.vertex = noNormal;
        return false;
    }
    return slash != std::string_view::npos && word.find('/') != slash &&
           takeIndex(word.substr(slash + 1), at.normals, all().normals, out.normal);
}

/// The number of the corner's place in the picture, or noNormal.
std::uint32_t ObjReader::takeTexture(std::string_view word, const Counts& at) const {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos)
        return noNormal;
    word.remove_prefix(slash + 1);
    std::uint32_t out = noNormal;
    return takeIndex(word.substr(0, word.find('/')), at.textures, all().textures, out) ? out : noNormal;
}

void ObjReader::takeFace(std::string_view line, const Counts& at, std::size_t chunk) {
    for (skipBlanks(line); !line.empty() && line.front() != '#'; skipBlanks(line)) {
        std::size_t size = 0;
        while (size < line.size() && !isBlank(line[size]))
            ++size;
        Corner corner{};
        if (takeCorner(line.substr(0, size), at, corner))
            m_corners[chunk].push_back(corner);
        m_faces[chunk].corners.push_back(corner.vertex);
        if (m_pictured)
            m_textureOf[chunk].push_back(takeTexture(line.substr(0, size), at));
        line.remove_prefix(size);
    }
    m_faces[chunk].close();
}

std::size_t ObjReader::parse(std::size_t chunk) {
    Counts at = m_before[chunk];
    std::uint32_t material = materialOf(m_materials[chunk]);
    std::size_t fault = TextLines::none;
    m_lines.forLines(chunk, [&](std::size_t offset, std::string_view line) {
        double numbers[7] = {0, 0, 0, 1, 1, 1, 1};
        switch (takeStatement(line)) {
        case Statement::Vertex: {
            const std::size_t found = takeNumbers(line, numbers, 7);
            if (found < 3)
                fault = offset;
            double* const out = m_vertices.data() + at.vertices++ * m_width;
            std::copy_n(numbers, 3, out);
            // Seven numbers are x y z w r g b.
            std::copy_n(numbers + (found == 7 ? 4 : 3), m_width - 3, out + 3);
            break;
        }
        case Statement::Normal:
            if (takeNumbers(line, numbers, 3) < 3)
                fault = offset;
            m_normals[at.normals++] = {numbers[0], numbers[1], numbers[2]};
            break;
        case Statement::Face:
            takeFace(line, at, chunk);
            if (!m_painting.empty())
                m_faces[chunk].pictureOf.push_back(material);
            break;
        case Statement::Texture: {
            numbers[1] = 0; // which may be left out
            if (takeNumbers(line, numbers, 2) > 0 && m_pictured)
                m_textures[at.textures] = {static_cast<float>(numbers[0]), static_cast<float>(numbers[1])};
            ++at.textures;
            break;
        }
        case Statement::Material:
            material = materialOf(trimmed(line));
            break;
        case Statement::Library:
        case Statement::Other:
            break;
        }
        return fault == TextLines::none;
    });
    return fault;
}

/// One normal keeps its bits; several different ones are added up in the order of their numbers.
std::vector<base::Vec3d> ObjReader::normalsByCorners() {
    std::vector<std::uint32_t> first(all().vertices, noNormal);
    std::vector<Corner> further;
    for (const auto& corners : m_corners)
        for (const Corner& corner : corners) {
            if (first[corner.vertex] == noNormal)
                first[corner.vertex] = corner.normal;
            else if (first[corner.vertex] != corner.normal)
                further.push_back(corner);
        }
    std::sort(further.begin(), further.end());
    further.erase(std::unique(further.begin(), further.end()), further.end());
    std::vector<base::Vec3d> out(first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] != noNormal)
            out[i] = m_normals[first[i]];
    for (const Corner& corner : further)
        out[corner.vertex] += m_normals[corner.normal];
    return out;
}

/// One per vertex, zero where unknown; empty where the file has none or does not tell whose they are.
std::vector<base::Vec3d> ObjReader::vertexNormals() {
    if (m_normals.empty())
        return {};
    const bool cornersTell = std::any_of(m_corners.begin(), m_corners.end(), [](const auto& c) { return !c.empty(); });
    if (cornersTell)
        return normalsByCorners();
    if (m_normals.size() == all().vertices)
        return std::move(m_normals);
    m_model.messages.emplace_back("The normals were left out because no face tells which points they belong to.");
    return {};
}

void ObjReader::fillTable(const std::vector<base::Vec3d>& normals) {
    const std::size_t columns = m_width + (normals.empty() ? 0 : 3);
    static constexpr const char* names[] = {"x", "y", "z", "red", "green", "blue"};
    static constexpr const char* normalNames[] = {"nx", "ny", "nz"};
    for (std::size_t c = 0; c < columns; ++c)
        m_table.fields.push_back({c < m_width ? names[c] : normalNames[c - m_width], ScalarType::Float64,
                                  ScalarType::Float64, c * sizeof(double)});
    double* const out = m_table.allocateDoubles(all().vertices, columns);
    base::parallelFor(all().vertices, 4096, [&](std::size_t i) {
        std::copy_n(m_vertices.data() + i * m_width, m_width, out + i * columns);
        if (!normals.empty())
            for (std::size_t k = 0; k < 3; ++k)
                out[i * columns + m_width + k] = normals[i][k];
    });
    m_vertices = {};
}

/// The corners' places in the pictures of their faces' materials.
void ObjReader::placeInPictures(mesh::Polygons& faces, const std::vector<std::uint32_t>& textures) const {
    const ObjMaterial none;
    for (std::size_t face = 0, corner = 0; face < faces.size(); ++face) {
        const std::uint32_t number = faces.pictureOf[face];
        const ObjMaterial& material = number < m_painting.size() ? m_painting[number] : none;
        const auto moved = [&](float place, std::size_t k) {
            return static_cast<float>(static_cast<double>(place) * material.scale[k] + material.offset[k]);
        };
        for (; corner < faces.ends[face]; ++corner) {
            mesh::Polygons::Place place;
            if (textures[corner] < m_textures.size())
                place = m_textures[textures[corner]];
            faces.places.push_back({moved(place.u, 0), moved(place.v, 1)});
        }
    }
}

/// The colours of materials where they tell faces apart; vertices that have colours keep them.
void ObjReader::colourFaces() {
    mesh::Polygons& faces = m_model.polygons;
    if (m_width > 3 || faces.pictureOf.empty())
        return;
    std::vector<surfel::Colour> colours;
    bool pictured = false;
    for (const std::uint32_t number : faces.pictureOf) {
        const ObjMaterial* material = number < m_painting.size() ? &m_painting[number] : nullptr;
        colours.push_back(material ? material->colour.value_or(surfel::white) : surfel::white);
        pictured |= m_pictured && material && !material->picture.file.empty();
    }
    const surfel::Colour usual = pictured ? surfel::white : colours.front();
    if (std::any_of(colours.begin(), colours.end(), [&](surfel::Colour each) { return each != usual; }))
        faces.colours = std::move(colours);
}

void ObjReader::joinFaces() {
    for (std::size_t chunk = 0; chunk < m_faces.size(); ++chunk) {
        if (m_pictured)
            placeInPictures(m_faces[chunk], m_textureOf[chunk]);
        m_model.polygons.append(m_faces[chunk]);
        m_faces[chunk] = {};
        m_textureOf[chunk] = {};
    }
    if (m_painting.empty())
        return;
    colourFaces();
    std::vector<PictureName> pictures;
    for (const ObjMaterial& material : m_painting)
        pictures.push_back(m_pictured ? material.picture : PictureName());
    readPictures(m_model, m_folder, pictures);
}

FileModel ObjReader::read() {
    if (m_file.bytes().substr(0, 4096).find('\0') != std::string_view::npos)
        m_file.fail("is binary, not an OBJ text file", "choose an OBJ file or convert it to PLY");
    count();
    findMaterials();
    m_vertices.resize(all().vertices * m_width);
    m_textures.resize(m_pictured ? all().textures : 0);
    m_normals.resize(all().normals);
    const std::size_t fault = m_lines.run({m_progress, 0.2, 0.7}, [&](std::size_t chunk) { return parse(chunk); });
    if (fault != TextLines::none)
        m_file.failAt(fault, "needs three numbers", "correct the line or remove it");
    fillTable(vertexNormals());
    m_model.format = "obj";
    m_model.faces = all().faces;
    joinFaces();
    makePoints(m_model, m_file, m_table, rolesOf(m_table.fields, false), {}, {m_progress, 0.7, 1});
    return std::move(m_model);
}

} // namespace

FileModel readObj(const FileBytes& file, const base::Progress& progress, const path& folder) {
    std::string joined = joinedLines(file.bytes());
    if (joined.empty())
        return ObjReader(file, progress, folder).read();
    const FileBytes whole(file.path(), std::move(joined));
    return ObjReader(whole, progress, folder).read();
}

} // namespace io
