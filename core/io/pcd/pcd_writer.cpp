// Binary PCD: all that the points have, the colour packed into four bytes as the Point Cloud Library has it, the
// viewpoint that a PCD file was read with (io/README 2.11).
#include "core/io/channel_columns.h"
#include "core/io/readers.h"
#include "core/io/record_table.h"

namespace io {

namespace {

constexpr std::string_view viewpointWord = "viewpoint ";

struct PcdType {
    char letter;
    std::size_t size;
};

PcdType pcdType(ScalarType type) {
    switch (type) {
    case ScalarType::Int8:
    case ScalarType::Int16:
    case ScalarType::Int32:
        return {'I', sizeOf(type)};
    case ScalarType::UInt8:
    case ScalarType::UInt16:
    case ScalarType::UInt32:
        return {'U', sizeOf(type)};
    case ScalarType::Float32:
    case ScalarType::Float64:
        break;
    }
    return {'F', sizeOf(type)};
}

/// A name without blanks that is not the one of a packed colour.
std::string fieldName(const std::string& name) {
    static constexpr std::pair<const char*, const char*> ours[] = {
        {"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}, {"rgb", "rgb_2"}, {"rgba", "rgba_2"}, {"_", "_2"}};
    for (const auto& [from, to] : ours)
        if (name == from)
            return to;
    return name;
}

std::string headerOf(const FileModel& model, const ChannelColumns& columns) {
    std::string out = "# .PCD v0.7 - Point Cloud Data file format\n", viewpoint = "0 0 0 1 0 0 0";
    for (std::string comment : model.comments) {
        for (char& c : comment)
            c = c == '\n' || c == '\r' ? ' ' : c;
        if (comment.starts_with(viewpointWord))
            viewpoint = comment.substr(viewpointWord.size());
        else
            out += "# " + comment + "\n";
    }
    std::string fields, sizes, types, counts;
    bool colourComes = model.points.layout->colours; // before any attribute of its name
    for (const ChannelColumn& column : columns.columns()) {
        const PcdType type = pcdType(column.type);
        const bool isColour = colourComes && (column.name == "rgb" || column.name == "rgba");
        colourComes &= !isColour;
        fields += " " + (isColour ? column.name : fieldName(column.name));
        sizes += " " + std::to_string(type.size);
        types += std::string(" ") + type.letter;
        counts += " 1";
    }
    const std::string n = std::to_string(model.points.size());
    return out + "VERSION 0.7\nFIELDS" + fields + "\nSIZE" + sizes + "\nTYPE" + types + "\nCOUNT" + counts +
           "\nWIDTH " + n + "\nHEIGHT 1\nVIEWPOINT " + viewpoint + "\nPOINTS " + n + "\nDATA binary\n";
}

} // namespace

void writePcd(const path& target, const FileModel& model, const base::Progress& progress) {
    const ChannelColumns columns(model, {.packedColour = true, .locals = false});
    SafeFile file(target);
    file.write(headerOf(model, columns));
    columns.write(file, progress);
    file.commit();
}

} // namespace io
