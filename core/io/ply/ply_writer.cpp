// The native format: binary little-endian PLY that every other program can read, too (io/README 2.3).
#include "core/io/channel_columns.h"
#include "core/io/ply/ply_comments.h"
#include "core/io/ply/ply_complex.h"
#include "core/io/ply/ply_header.h"
#include "core/io/ply/ply_tree_shape.h"
#include "core/io/readers.h"

namespace io {

namespace {

class PlyWriter {
  public:
    PlyWriter(const path& target, const FileModel& model)
        : m_file(target), m_model(model), m_columns(model, {.packedColour = false, .locals = true}) {}
    void write(const base::Progress& progress);

  private:
    std::string header() const;
    const surface::Connectivity* complex() const {
        return m_model.definition ? m_model.definition->connectivity.get() : nullptr;
    }
    std::string declaration() const;

    SafeFile m_file;
    const FileModel& m_model;
    ChannelColumns m_columns;
};

std::string PlyWriter::declaration() const {
    PlyElement element{"vertex", m_model.points.size(), {}};
    for (const ChannelColumn& column : m_columns.columns()) {
        PlyProperty property;
        property.name = column.name;
        property.type = column.type;
        element.properties.push_back(property);
    }
    return element.declaration();
}

std::string PlyWriter::header() const {
    NativeComments native;
    native.origin = m_model.origin;
    native.definition = m_model.definition;
    native.limitDecided = m_model.limitDecided;
    native.up = m_model.up;
    if (m_model.points.layout->normals)
        native.oriented = m_model.points.layout->oriented;
    std::string out = "ply\nformat binary_little_endian 1.0\n" + nativeCommentLines(native);
    for (std::string comment : m_model.comments) {
        for (char& c : comment)
            c = c == '\n' || c == '\r' ? ' ' : c;
        out += comment.starts_with("obj_info ") ? comment + "\n" : "comment " + comment + "\n";
    }
    out += declaration() + complexDeclaration(complex());
    for (const OpaqueElement& element : m_model.elements)
        out += element.declaration;
    return out + treeShapeDeclaration(m_model.shape) + "end_header\n";
}

void PlyWriter::write(const base::Progress& progress) {
    m_file.write(header());
    m_columns.write(m_file, progress);
    m_file.write(complexBody(complex(), m_model.origin));
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
