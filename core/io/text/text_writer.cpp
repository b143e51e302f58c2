// Points as text, by the customs of each extension:
//
//     xyz        x y z [nx ny nz] [red green blue]
//     pwn        x y z [nx ny nz]
//     pts        the number of points, then x y z [intensity] [red green blue]; colours bring an intensity, if only 0
//     txt asc    all that the model has, after a line "# x y z ..."
//     csv        the same, after a line "x,y,z,...", separated by commas
#include "core/io/file_coordinates.h"
#include "core/io/file_name.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/record_roles.h"
#include "core/io/text/text_output.h"

#include <functional>

namespace io {

namespace {

struct Column {
    std::string name;
    std::function<void(std::string& out, std::size_t i)> append;
};

/// The columns of one file; what the extension has no place for is left out.
class TextColumns {
  public:
    TextColumns(const FileModel& model, const std::string& extension) : m_model(model), m_layout(*model.points.layout) {
        const bool all = extension == "csv" || extension == "txt" || extension == "asc";
        addPosition();
        if (m_layout.normals && extension != "pts")
            addNormal();
        if (extension == "pts")
            addIntensity();
        if (m_layout.colours && extension != "pwn")
            addColour(all ? 4 : 3);
        if (all)
            addRest();
    }
    const std::vector<Column>& columns() const { return m_columns; }

  private:
    void addPosition() {
        for (std::size_t k = 0; k < 3; ++k)
            m_columns.push_back({std::string(1, "xyz"[k]), [this, k](std::string& out, std::size_t i) {
                                     if (hasOrigin(m_model))
                                         appendNumber(out, fileCoordinates(m_model, i)[k]);
                                     else
                                         appendNumber(out, m_model.points.items[i].position[k]);
                                 }});
    }
    void addNormal() {
        for (std::size_t k = 0; k < 3; ++k)
            m_columns.push_back({std::string("n") + "xyz"[k], [this, k](std::string& out, std::size_t i) {
                                     appendNumber(out, m_model.points.items[i].normal[k]);
                                 }});
    }
    void addColour(unsigned channels) {
        for (unsigned k = 0; k < channels; ++k)
            m_columns.push_back({channelColours[k], [this, k](std::string& out, std::size_t i) {
                                     const surfel::Colour colour = m_model.points.items[i].colour;
                                     appendNumber(out, static_cast<std::int64_t>(colour >> (8 * k) & 0xff));
                                 }});
    }
    void addIntensity() {
        if (const surfel::Attribute* attribute = m_layout.find("intensity"))
            addAttribute(*attribute);
        else if (m_layout.colours)
            m_columns.push_back({"intensity", [](std::string& out, std::size_t) { out += '0'; }});
    }
    void addAttribute(const surfel::Attribute& attribute) {
        m_columns.push_back({attribute.name, [this, attribute](std::string& out, std::size_t i) {
                                 const double value = surfel::read(attribute, m_model.points.extraOf(i));
                                 if (attribute.type == ScalarType::Float32)
                                     appendNumber(out, static_cast<float>(value));
                                 else if (attribute.type == ScalarType::Float64)
                                     appendNumber(out, value);
                                 else
                                     appendNumber(out, static_cast<std::int64_t>(value));
                             }});
    }
    void addRest() {
        if (m_model.hasSupports)
            m_columns.push_back({"support_radius", [this](std::string& out, std::size_t i) {
                                     appendNumber(out, m_model.points.items[i].support);
                                 }});
        if (m_layout.masks)
            m_columns.push_back(
                {"mask", [this](std::string& out, std::size_t i) { appendNumber(out, m_model.points.items[i].mask); }});
        for (const surfel::Attribute& attribute : m_layout.attributes())
            addAttribute(attribute);
    }

    const FileModel& m_model;
    const surfel::AttributeLayout& m_layout;
    std::vector<Column> m_columns;
};

std::string headLine(const std::vector<Column>& columns, const std::string& extension, std::size_t points) {
    if (extension == "pts")
        return std::to_string(points) + "\n";
    if (extension == "xyz" || extension == "pwn")
        return "";
    std::string out;
    for (const Column& column : columns)
        out += (out.empty() ? "" : extension == "csv" ? "," : " ") + column.name;
    return (extension == "csv" ? out : "# " + out) + "\n";
}

} // namespace

void writeText(const path& target, const FileModel& model, const base::Progress& progress) {
    const std::string extension = extensionOf(target);
    const TextColumns chosen(model, extension);
    const auto& columns = chosen.columns();
    const char separator = extension == "csv" ? ',' : ' ';
    SafeFile file(target);
    file.write(headLine(columns, extension, model.points.size()));
    writeRows(file, model.points.size(), progress, [&](std::string& out, std::size_t i) {
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (c > 0)
                out += separator;
            columns[c].append(out, i);
        }
        out += '\n';
    });
    file.commit();
}

} // namespace io
