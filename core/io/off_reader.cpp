// Object File Format (Geomview), in ascii: OFF, COFF, NOFF and their mixtures, vertices only. Comments begin with '#'.
#include "core/base/error.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/record_points.h"
#include "core/io/text/text_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace io {

namespace {

const char* const cutOff = "the file is damaged or was cut off; fetch it again";

struct FaceColours {
    bool any = false; ///< some face has one
    std::vector<surfel::Colour> all;
};

class OffReader {
  public:
    OffReader(const FileBytes& file, const base::Progress& progress) : m_file(file), m_progress(progress) {}
    FileModel read();

  private:
    void readHead(const TextRows& rows);
    void nameColumns(std::size_t columns);
    void readFaces(const TextRows& rows);
    static void takeColour(std::span<const std::string_view> fields, FaceColours& out);

    const FileBytes& m_file;
    const base::Progress& m_progress;
    FileModel m_model;
    RecordTable m_table;
    std::string m_prefix; ///< of the word OFF: ST, C, N
    std::size_t m_vertices = 0, m_faces = 0, m_firstRow = 0;
};

/// The word, which may be missing, and the counts behind or below it.
void OffReader::readHead(const TextRows& rows) {
    if (rows.count() == 0)
        m_file.fail("holds no points", "choose a file with at least one");
    auto fields = rows.fields(rows.row(0));
    if (fields[0].ends_with("OFF")) {
        m_prefix = fields[0].substr(0, fields[0].size() - 3);
        fields.erase(fields.begin());
        if (!fields.empty() && fields[0] == "BINARY")
            m_file.fail("is a binary OFF file, which cannot be read", "save it as ascii OFF or as PLY");
        if (m_prefix.find_first_of("4n") != std::string::npos)
            m_file.fail("has points with other than three dimensions", "save it as plain OFF");
        ++m_firstRow;
    }
    if (fields.empty() && m_firstRow < rows.count())
        fields = rows.fields(rows.row(m_firstRow++));
    else if (m_firstRow == 0)
        ++m_firstRow;
    const auto vertices = fields.empty() ? std::optional<std::uint64_t>() : countOf(fields[0]);
    const auto faces = fields.size() > 1 ? countOf(fields[1]) : std::optional<std::uint64_t>();
    if (!vertices || !faces)
        m_file.fail("does not say how many vertices and faces it has", "the file is damaged or not an OFF file");
    const std::size_t left = rows.count() - m_firstRow;
    if (*vertices > left || *faces > left - *vertices)
        m_file.fail("promises " + std::to_string(*vertices) + " vertices and " + std::to_string(*faces) +
                        " faces, but holds " + std::to_string(left) + " lines of them",
                    cutOff);
    if (*vertices == 0)
        m_file.fail("holds no points", "choose a file with at least one");
    m_vertices = *vertices;
    m_faces = *faces;
}

/// x y z, then normals (N), colours (C) and texture coordinates (ST). Many programs write colours and still call it
/// OFF: three or four numbers too many are colours.
void OffReader::nameColumns(std::size_t columns) {
    std::vector<std::string> names{"x", "y", "z"};
    if (m_prefix.find('N') != std::string::npos)
        names.insert(names.end(), {"nx", "ny", "nz"});
    const std::size_t texture = m_prefix.starts_with("ST") ? 2 : 0;
    const std::size_t colours = columns - std::min(columns, names.size() + texture);
    if (colours == 3 || colours == 4)
        names.insert(names.end(), {"red", "green", "blue", "alpha"});
    names.resize(std::min(names.size(), columns - std::min(columns, texture)));
    while (names.size() < columns)
        names.push_back("column_" + std::to_string(names.size() + 1));
    for (std::size_t c = 0; c < columns; ++c)
        m_table.fields.push_back({names[c], ScalarType::Float64,
                                  c < 3 || names[c][0] != 'c' ? ScalarType::Float64 : ScalarType::Float32,
                                  c * sizeof(double)});
}

/// Three or four numbers behind the corners: whole ones up to 255, others up to 1. One alone is a row of a table that
/// nobody has.
void OffReader::takeColour(std::span<const std::string_view> fields, FaceColours& out) {
    surfel::Colour colour = surfel::white;
    const bool given = fields.size() == 3 || fields.size() == 4;
    const bool whole = std::none_of(fields.begin(), fields.end(), [](std::string_view f) {
        return f.find_first_of(".eE") != std::string_view::npos;
    });
    for (std::size_t k = 0; given && k < 3; ++k) {
        const double value = numberOf(fields[k]).value_or(0) * (whole ? 1 : 255);
        const auto byte = value > 0 ? static_cast<surfel::Colour>(std::min(255.0, std::floor(value + 0.5))) : 0;
        colour = (colour & ~(surfel::Colour(0xff) << (8 * k))) | byte << (8 * k);
    }
    out.any |= given;
    out.all.push_back(colour);
}

/// A row of a face: how many corners, their numbers, then perhaps a colour.
void OffReader::readFaces(const TextRows& rows) {
    std::size_t left = m_faces, row = m_firstRow + m_vertices;
    FaceColours colours;
    rows.forRows(row, [&](std::string_view line) {
        if (left-- == 0)
            return false;
        const auto fields = rows.fields(line);
        const auto corners = countOf(fields[0]);
        if (!corners || *corners > fields.size() - 1)
            m_file.failAt(rows.offset(row), "is a face that does not hold as many corners as it declares", cutOff);
        for (std::size_t k = 1; k <= *corners; ++k) {
            const auto corner = countOf(fields[k]);
            m_model.polygons.corners.push_back(corner && *corner < m_vertices ? static_cast<std::uint32_t>(*corner)
                                                                              : std::uint32_t(-1));
        }
        m_model.polygons.close();
        takeColour(std::span(fields).subspan(*corners + 1), colours);
        ++row;
        return true;
    });
    if (colours.any)
        m_model.polygons.colours = std::move(colours.all);
}

FileModel OffReader::read() {
    if (m_file.bytes().substr(0, 4096).find('\0') != std::string_view::npos)
        m_file.fail("is binary, not an OFF text file", "save it as ascii OFF or as PLY");
    const TextRows rows(m_file, 0, {.comments = true}, {m_progress, 0, 0.2});
    readHead(rows);
    const std::size_t columns = rows.fields(rows.row(m_firstRow)).size();
    if (columns < 3 || columns > 1000)
        m_file.failAt(rows.offset(m_firstRow), "holds " + std::to_string(columns) + " numbers where a vertex needs 3",
                      cutOff);
    nameColumns(columns);
    std::vector<int> targets;
    for (std::size_t c = 0; c < columns; ++c)
        targets.push_back(static_cast<int>(c));
    rows.checkRoom(m_vertices, columns);
    double* const out = m_table.allocateDoubles(m_vertices, columns);
    rows.parse(m_firstRow, m_vertices, targets, columns, out, {m_progress, 0.2, 0.7});
    readFaces(rows);
    m_model.format = "off";
    m_model.faces = m_faces;
    makePoints(m_model, m_file, m_table, rolesOf(m_table.fields, false), {}, {m_progress, 0.7, 1});
    return std::move(m_model);
}

/// The numbers of a file one after the other, without comments; stops at the first that is none.
class Numbers {
  public:
    explicit Numbers(std::string_view text) : m_text(text) {}
    std::string_view word() {
        while (!m_text.empty()) {
            const std::size_t begin = m_text.find_first_not_of(" \t\r\n\v\f");
            m_text.remove_prefix(std::min(begin, m_text.size()));
            if (!m_text.starts_with('#'))
                break;
            m_text.remove_prefix(std::min(m_text.find_first_of("\r\n"), m_text.size()));
        }
        const std::string_view out = m_text.substr(0, m_text.find_first_of(" \t\r\n\v\f#"));
        m_text.remove_prefix(out.size());
        return out;
    }
    std::optional<std::uint64_t> count() { return countOf(word()); }
    /// Appends `n` numbers as they stand and ends the line.
    bool copy(std::size_t n, std::string& out) {
        for (std::size_t k = 0; k < n; ++k) {
            const std::string_view each = word();
            if (!numberOf(each))
                return false;
            out.append(each).append(1, ' ');
        }
        out += '\n';
        return true;
    }

  private:
    std::string_view m_text;
};

/// Line breaks mean nothing in OFF, though nearly all programs write a line each. The same in lines, where the numbers
/// are exactly as many as the counts say; empty where they are not.
std::string inLines(std::string_view text) {
    Numbers numbers(text);
    std::string_view word = numbers.word();
    std::string out;
    if (word.ends_with("OFF")) {
        out = word;
        word = numbers.word();
    } else {
        out = "OFF";
    }
    const auto vertices = countOf(word), faces = numbers.count(), edges = numbers.count();
    if (!vertices || !faces || !edges || *vertices > text.size() || *faces > text.size())
        return {};
    const auto has = [&](char prefix) { return out.substr(0, out.size() - 3).find(prefix) != std::string::npos; };
    const std::size_t width = 3 + (has('N') ? 3 : 0) + (has('C') ? 4 : 0) + (has('T') ? 2 : 0);
    out += "\n" + std::to_string(*vertices) + " " + std::to_string(*faces) + " 0\n";
    for (std::uint64_t i = 0; i < *vertices; ++i)
        if (!numbers.copy(width, out))
            return {};
    for (std::uint64_t i = 0; i < *faces; ++i) {
        const auto corners = numbers.count();
        if (!corners || *corners > text.size())
            return {};
        out += std::to_string(*corners) + " ";
        if (!numbers.copy(*corners, out))
            return {};
    }
    return numbers.word().empty() ? out : std::string();
}

} // namespace

FileModel readOff(const FileBytes& file, const base::Progress& progress, const path&) {
    try {
        return OffReader(file, progress).read();
    } catch (const base::Error&) {
        std::string lines = inLines(file.bytes());
        if (lines.empty())
            throw;
        const FileBytes rewritten(file.path(), std::move(lines));
        return OffReader(rewritten, progress).read();
    }
}

} // namespace io
