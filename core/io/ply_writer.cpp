// The native format: binary little-endian PLY that every other program can read, too (io/README 2.3).
#include "core/base/parallel.h"
#include "core/io/file_coordinates.h"
#include "core/io/ply_comments.h"
#include "core/io/ply_header.h"
#include "core/io/ply_tree_shape.h"
#include "core/io/readers.h"
#include "core/io/record_roles.h"
#include "core/io/safe_file.h"

#include <functional>

namespace io {

namespace {

constexpr std::size_t grain = 2048;       // rows per chunk
constexpr std::size_t block = 64 * grain; // rows per write, some 4 MB, and between two looks at the cancel flag

/// Puts the values of one property for points [begin, end) into records; `out` is the property in the first record.
using Fill = std::function<void(std::size_t begin, std::size_t end, char* out, std::size_t stride)>;

template <class T>
void store(char* out, T value) {
    std::memcpy(out, &value, sizeof value);
}

class PlyWriter {
  public:
    PlyWriter(const path& target, const FileModel& model) : m_file(target), m_model(model) {}
    void write(const base::Progress& progress);

  private:
    void chooseProperties();
    void addPositions();
    void addAttribute(const surfel::Attribute& attribute);
    std::string header() const;
    void writeRecords(const base::Progress& progress);
    template <class T, class Value>
    void add(const std::string& name, ScalarType type, const Value& value);

    SafeFile m_file;
    const FileModel& m_model;
    PlyElement m_element{"vertex", 0, {}};
    std::vector<Fill> m_fills;
    std::vector<std::size_t> m_offsets;
    std::size_t m_stride = 0;
};

template <class T, class Value>
void PlyWriter::add(const std::string& name, ScalarType type, const Value& value) {
    PlyProperty property;
    property.name = name;
    property.type = type;
    m_element.properties.push_back(property);
    m_offsets.push_back(m_stride);
    m_stride += sizeof(T);
    m_fills.push_back([value](std::size_t begin, std::size_t end, char* out, std::size_t stride) {
        for (std::size_t i = begin; i < end; ++i, out += stride)
            store(out, static_cast<T>(value(i)));
    });
}

void PlyWriter::addPositions() {
    const auto& items = m_model.points.items;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string name(1, "xyz"[k]);
        if (hasOrigin(m_model))
            add<double>(name, ScalarType::Float64, [&, k](std::size_t i) { return fileCoordinates(m_model, i)[k]; });
        else
            add<float>(name, ScalarType::Float32, [&, k](std::size_t i) { return items[i].position[k]; });
    }
}

/// Words of integers hold them widened: the low bytes are the value.
void PlyWriter::addAttribute(const surfel::Attribute& attribute) {
    const std::uint32_t* const first = m_model.points.extra.data() + attribute.firstWord;
    const std::size_t words = m_model.points.layout->words();
    const auto word = [first, words](std::size_t i) { return first[i * words]; };
    switch (attribute.type) {
    case ScalarType::Int8:
    case ScalarType::UInt8:
        return add<std::uint8_t>(attribute.name, attribute.type, word);
    case ScalarType::Int16:
    case ScalarType::UInt16:
        return add<std::uint16_t>(attribute.name, attribute.type, word);
    case ScalarType::Int32:
    case ScalarType::UInt32:
    case ScalarType::Float32:
        return add<std::uint32_t>(attribute.name, attribute.type, word);
    case ScalarType::Float64:
        return add<std::uint64_t>(attribute.name, attribute.type, [first, words](std::size_t i) {
            return static_cast<std::uint64_t>(first[i * words + 1]) << 32 | first[i * words];
        });
    }
}

void PlyWriter::chooseProperties() {
    const auto& items = m_model.points.items;
    const surfel::AttributeLayout& layout = *m_model.points.layout;
    addPositions();
    if (layout.normals)
        for (std::size_t k = 0; k < 3; ++k)
            add<float>(std::string("n") + "xyz"[k], ScalarType::Float32,
                       [&, k](std::size_t i) { return items[i].normal[k]; });
    if (layout.colours)
        for (unsigned k = 0; k < 4; ++k)
            add<std::uint8_t>(channelColours[k], ScalarType::UInt8,
                              [&, k](std::size_t i) { return items[i].colour >> (8 * k); });
    if (m_model.hasSupports)
        add<float>("support_radius", ScalarType::Float32, [&](std::size_t i) { return items[i].support; });
    if (layout.masks)
        add<float>("mask", ScalarType::Float32, [&](std::size_t i) { return items[i].mask; });
    if (!coordinatesAreExact(m_model))
        for (std::size_t k = 0; k < 3; ++k)
            add<float>(localNames[k], ScalarType::Float32, [&, k](std::size_t i) { return items[i].position[k]; });
    for (const surfel::Attribute& attribute : layout.attributes())
        addAttribute(attribute);
    m_element.count = m_model.points.size();
}

std::string PlyWriter::header() const {
    NativeComments native;
    native.origin = m_model.origin;
    native.definition = m_model.definition;
    native.up = m_model.up;
    if (m_model.points.layout->normals)
        native.oriented = m_model.points.layout->oriented;
    std::string out = "ply\nformat binary_little_endian 1.0\n" + nativeCommentLines(native);
    for (std::string comment : m_model.comments) {
        for (char& c : comment)
            c = c == '\n' || c == '\r' ? ' ' : c;
        out += comment.starts_with("obj_info ") ? comment + "\n" : "comment " + comment + "\n";
    }
    out += m_element.declaration();
    for (const OpaqueElement& element : m_model.elements)
        out += element.declaration;
    return out + treeShapeDeclaration(m_model.shape) + "end_header\n";
}

void PlyWriter::writeRecords(const base::Progress& progress) {
    const std::size_t n = m_model.points.size();
    std::string buffer(std::min(block, n) * m_stride, '\0');
    for (std::size_t first = 0; first < n; first += block) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), "Writing");
        const std::size_t rows = std::min(block, n - first);
        base::parallelChunks(rows, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (std::size_t p = 0; p < m_fills.size(); ++p)
                m_fills[p](first + begin, first + end, buffer.data() + begin * m_stride + m_offsets[p], m_stride);
        });
        m_file.write({buffer.data(), rows * m_stride});
    }
}

void PlyWriter::write(const base::Progress& progress) {
    chooseProperties();
    m_file.write(header());
    writeRecords(progress);
    for (const OpaqueElement& element : m_model.elements)
        m_file.write(element.body);
    m_file.write(treeShapeBody(m_model.shape));
    progress.step(1, "Writing");
    m_file.commit();
}

} // namespace

void writePly(const path& file, const FileModel& model, const base::Progress& progress) {
    PlyWriter(file, model).write(progress);
}

} // namespace io
