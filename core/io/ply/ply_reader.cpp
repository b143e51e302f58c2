#include "core/io/pictures/face_pictures.h"
#include "core/io/ply/ply_comments.h"
#include "core/io/ply/ply_complex.h"
#include "core/io/ply/ply_elements.h"
#include "core/io/ply/ply_faces.h"
#include "core/io/ply/ply_tree_shape.h"
#include "core/io/readers.h"
#include "core/io/record_points.h"
#include "core/io/scene/splat_columns.h"

#include <algorithm>
#include <limits>

namespace io {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
const char* const cutOff = "the file is damaged or was cut off; fetch it again";

/// Whether records name vertices by their number, which means nothing once points were moved, added and removed.
bool refersToVertices(const PlyElement& element) {
    static constexpr std::string_view elements[] = {"face", "faces", "tristrips", "trifans", "edge", "range_grid"};
    static constexpr std::string_view properties[] = {"vertex_indices", "vertex_index", "vertex1", "vertex2"};
    return std::find(std::begin(elements), std::end(elements), element.name) != std::end(elements) ||
           std::any_of(element.properties.begin(), element.properties.end(), [](const PlyProperty& property) {
               return std::find(std::begin(properties), std::end(properties), property.name) != std::end(properties);
           });
}

std::size_t vertexElement(const PlyHeader& header) {
    for (const std::string_view name : {"vertex", "point", "vertices", "points"})
        for (std::size_t i = 0; i < header.elements.size(); ++i)
            if (header.elements[i].name == name)
                return i;
    return none;
}

/// One PLY file on its way to a model.
class PlyReader {
  public:
    PlyReader(const FileBytes& file, const base::Progress& progress, const path& folder)
        : m_file(file), m_progress(progress), m_folder(folder) {}
    FileModel read();

  private:
    void readBinary(bool bigEndian);
    void readAscii();
    void keepOther(const PlyElement& element, const std::function<std::string()>& body);
    void takeFaces(const PlyElement& element, std::string_view body, std::size_t offset, bool bigEndian);
    void matchLooks();
    void takePictures();
    void takeComplex();
    void judgeSplats();
    void finish();

    const FileBytes& m_file;
    const base::Progress& m_progress;
    const path& m_folder; ///< of pictures
    PlyHeader m_header;
    std::size_t m_vertex = none;
    RecordTable m_table;
    PlyComplex m_complex;
    FileModel m_model;
};

void PlyReader::keepOther(const PlyElement& element, const std::function<std::string()>& body) {
    if (isOfComplex(element))
        m_complex.take(m_file, element, body());
    else if (isTreeShape(element))
        m_model.shape = treeShapeOf(m_file, element, body());
    else if (!refersToVertices(element))
        m_model.elements.push_back({element.declaration(), body()});
    else if (!isFace(element) && !isStrips(element) && element.count > 0)
        m_model.messages.push_back("The element " + inQuotes(element.name) +
                                   " refers to points by number; it is not used and will not be written back.");
}

void PlyReader::takeFaces(const PlyElement& element, std::string_view body, std::size_t offset, bool bigEndian) {
    if (element.properties.empty()) {
        if (element.count > 0)
            m_model.messages.push_back("The header declares " + std::to_string(element.count) + " of element " +
                                       inQuotes(element.name) + " without properties, so there are none.");
        return;
    }
    const mesh::Polygons faces = polygonsOf(m_file, body, element, offset, bigEndian);
    m_model.faces += isFace(element) ? element.count : faces.size();
    m_model.polygons.append(faces);
}

void PlyReader::readBinary(bool bigEndian) {
    std::size_t offset = m_header.bodyOffset;
    for (std::size_t i = 0; i < m_header.elements.size(); ++i) {
        const PlyElement& element = m_header.elements[i];
        const std::size_t extent = binaryExtent(m_file, element, offset, bigEndian);
        if (i == m_vertex)
            m_table = binaryTable(m_file, element, offset, bigEndian);
        else
            keepOther(element, [&] { return littleEndianBody(m_file, element, offset, extent, bigEndian); });
        if (isFace(element) || isStrips(element))
            takeFaces(element, m_file.bytes(), offset, bigEndian);
        offset += extent;
    }
    if (m_file.bytes().find_first_not_of(std::string_view(" \t\r\n\0", 5), offset) != std::string_view::npos)
        m_model.messages.push_back("The file goes on for " + std::to_string(m_file.size() - offset) +
                                   " bytes after all that its header declares; they were left out.");
}

void PlyReader::readAscii() {
    const TextRows rows(m_file, m_header.bodyOffset, {}, {m_progress, 0, 0.2});
    std::size_t row = 0;
    for (std::size_t i = 0; i < m_header.elements.size(); ++i) {
        const PlyElement& element = m_header.elements[i];
        const std::size_t taken = element.properties.empty() ? 0 : element.count;
        if (taken > rows.count() - row)
            m_file.fail("the header declares " + std::to_string(taken) + " of element " + inQuotes(element.name) +
                            ", but the body ends after " + std::to_string(rows.count() - row),
                        cutOff);
        if (i == m_vertex)
            m_table = asciiTable(m_file, rows, row, element, {m_progress, 0.2, 0.7});
        else
            keepOther(element, [&] { return littleEndianBody(m_file, rows, row, element); });
        if (isFace(element) || isStrips(element))
            takeFaces(element, littleEndianBody(m_file, rows, row, element), 0, false);
        row += taken;
    }
    if (const std::size_t more = rows.count() - std::min(row, rows.count()); more > 0)
        m_model.messages.push_back(more == 1 ? "The file holds a line more than its header declares; it was left out."
                                             : "The file holds " + std::to_string(more) +
                                                   " lines more than its header declares; they were left out.");
}

/// Faces of several elements have the looks that all of them have.
void PlyReader::matchLooks() {
    mesh::Polygons& faces = m_model.polygons;
    if (faces.colours.size() != faces.size())
        faces.colours.clear();
    if (faces.places.size() != faces.corners.size() || faces.pictureOf.size() != faces.size())
        faces.places.clear(), faces.pictureOf.clear();
}

/// The pictures that comments name; places in them that stand at the vertices become those of the corners.
void PlyReader::takePictures() {
    constexpr std::string_view word = "TextureFile ";
    std::vector<PictureName> names;
    for (const std::string& comment : m_header.comments)
        if (std::string_view(comment).starts_with(word))
            names.push_back({comment.substr(word.size())});
    mesh::Polygons& faces = m_model.polygons;
    const surfel::AttributeLayout& layout = *m_model.points.layout;
    for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
        const surfel::Attribute *first = layout.find(u), *second = layout.find(v);
        if (names.empty() || !faces.places.empty() || !first || !second)
            continue;
        faces.pictureOf.assign(faces.size(), 0);
        for (const std::uint32_t corner : faces.corners) {
            const auto words = m_model.points.extraOf(corner);
            faces.places.push_back(
                {static_cast<float>(surfel::read(*first, words)), static_cast<float>(surfel::read(*second, words))});
        }
    }
    readPictures(m_model, m_folder, names);
}

/// A file that says nothing else of its surface is that complex.
void PlyReader::takeComplex() {
    if (!m_complex.any())
        return;
    if (!m_model.definition) {
        m_model.definition.emplace();
        m_model.definition->manifold = surface::Manifold::Complex;
    }
    m_model.definition->connectivity =
        std::make_shared<const surface::Connectivity>(m_complex.made(m_file, m_model.origin));
}

/// Which splats are surface enough, and what the person should know of them.
void PlyReader::judgeSplats() {
    const std::size_t all = m_model.points.size(), dropped = dropTransparent(m_model);
    if (dropped == all)
        m_file.fail("holds only splats that are nearly transparent", "choose a file with opaque ones");
    shapeSplats(m_model);
    m_model.messages.push_back("The file holds Gaussian splats: " + std::to_string(dropped) + " of " +
                               std::to_string(all) +
                               " were left out because they are less than a tenth opaque, and so were colours that "
                               "depend on the view. The shading unlit shows the others as they were taken.");
}

void PlyReader::finish() {
    matchLooks();
    m_model.comments = m_header.comments;
    const NativeComments native = takeNativeComments(m_model.comments, m_model.messages);
    m_model.definition = native.definition;
    m_model.up = native.up;
    m_model.limitDecided = native.limitDecided;
    const bool splats = areSplats(m_table.fields);
    if (splats)
        colourSplats(m_table);
    const RecordRoles roles = rolesOf(m_table.fields, native.origin.has_value());
    if (roles.position[0] == RecordRoles::none || roles.position[1] == RecordRoles::none)
        m_file.fail("the points have no properties x and y", "choose a file with coordinates");
    const double begun = m_header.encoding == PlyEncoding::Ascii ? 0.7 : 0.1;
    makePoints(m_model, m_file, m_table, roles, {native.origin, native.oriented.value_or(true)},
               {m_progress, begun, 1});
    takePictures();
    takeComplex();
    if (splats)
        judgeSplats();
    for (const PlyProperty& property : m_header.elements[m_vertex].properties)
        if (property.isList)
            m_model.messages.push_back("The list property " + inQuotes(property.name) + " of the points was left out.");
}

FileModel PlyReader::read() {
    m_progress.step(0, "Reading");
    m_header = parsePlyHeader(m_file);
    m_model.format = std::string("ply ") + nameOf(m_header.encoding);
    m_vertex = vertexElement(m_header);
    if (m_vertex == none)
        m_file.fail("the header declares no element 'vertex'", "choose a file that holds points");
    if (m_header.elements[m_vertex].count == 0)
        m_file.fail("holds no points", "choose a file with at least one");
    if (m_header.encoding == PlyEncoding::Ascii)
        readAscii();
    else
        readBinary(m_header.encoding == PlyEncoding::BigEndian);
    finish();
    return std::move(m_model);
}

} // namespace

FileModel readPly(const FileBytes& file, const base::Progress& progress, const path& folder) {
    return PlyReader(file, progress, folder).read();
}

} // namespace io
