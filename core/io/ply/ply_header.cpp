#include "core/io/ply/ply_header.h"

#include "core/io/number_text.h"
#include "core/io/record_table.h"

#include <algorithm>
#include <optional>

namespace io {

namespace {

struct TypeName {
    const char* name;
    ScalarType type;
};
constexpr TypeName typeNames[] = {
    {"char", ScalarType::Int8},       {"uchar", ScalarType::UInt8},    {"short", ScalarType::Int16},
    {"ushort", ScalarType::UInt16},   {"int", ScalarType::Int32},      {"uint", ScalarType::UInt32},
    {"float", ScalarType::Float32},   {"double", ScalarType::Float64}, {"int8", ScalarType::Int8},
    {"uint8", ScalarType::UInt8},     {"int16", ScalarType::Int16},    {"uint16", ScalarType::UInt16},
    {"int32", ScalarType::Int32},     {"uint32", ScalarType::UInt32},  {"float32", ScalarType::Float32},
    {"float64", ScalarType::Float64}, {"bool", ScalarType::UInt8}};

/// More than any program writes; a damaged file could else make us search long lists of names.
constexpr std::size_t mostProperties = 1000, mostElements = 1000;
const char* const damaged = "the header is damaged or this is not a PLY file";

/// Reads the header line by line; every fault names its line.
class HeaderParser {
  public:
    explicit HeaderParser(const FileBytes& file) : m_file(file) {}
    PlyHeader parse();

  private:
    bool nextLine();
    void passLineEnd();
    void parseFormat();
    void parseElement();
    void parseProperty();
    ScalarType typeOf(std::string_view name) const;
    std::string restAfter(std::string_view word) const;
    [[noreturn]] void fail(const std::string& what) const { m_file.failAt(m_lineStart, what, damaged); }

    const FileBytes& m_file;
    PlyHeader m_header;
    std::size_t m_at = 0, m_lineStart = 0;
    std::string_view m_line;
    std::vector<std::string_view> m_words;
    bool m_crOnly = false, m_hasFormat = false;
};

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view line) {
    while (!line.empty() && isBlank(line.front()))
        line.remove_prefix(1);
    while (!line.empty() && isBlank(line.back()))
        line.remove_suffix(1);
    return line;
}

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty() && words.size() < 8; line = trimmed(line)) {
        const auto end = static_cast<std::size_t>(std::find_if(line.begin(), line.end(), isBlank) - line.begin());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

/// Passes over one line end. Where the first line ended in CR alone, an LF after a CR is a byte of the body.
void HeaderParser::passLineEnd() {
    const std::string_view bytes = m_file.bytes();
    const bool first = m_lineStart == 0;
    if (m_at < bytes.size() && bytes[m_at] == '\r') {
        ++m_at;
        const bool lineFeed = m_at < bytes.size() && bytes[m_at] == '\n';
        if (first)
            m_crOnly = !lineFeed;
        if (lineFeed && !m_crOnly)
            ++m_at;
    } else if (m_at < bytes.size()) {
        ++m_at;
    }
}

bool HeaderParser::nextLine() {
    const std::string_view bytes = m_file.bytes();
    if (m_at >= bytes.size())
        return false;
    m_lineStart = m_at;
    m_at = std::min(bytes.find_first_of("\r\n", m_at), bytes.size());
    m_line = trimmed(bytes.substr(m_lineStart, m_at - m_lineStart));
    m_words = wordsOf(m_line);
    passLineEnd();
    return true;
}

ScalarType HeaderParser::typeOf(std::string_view name) const {
    for (const TypeName& row : typeNames)
        if (name == row.name)
            return row.type;
    fail(inQuotes(name) + " is not a type that PLY knows");
}

/// The line after its first word, as a comment keeps it.
std::string HeaderParser::restAfter(std::string_view word) const {
    std::string_view rest = m_line.substr(word.size());
    if (!rest.empty())
        rest.remove_prefix(1);
    return std::string(rest);
}

void HeaderParser::parseFormat() {
    if (m_words.size() < 2)
        fail("names no format");
    for (const PlyEncoding encoding : {PlyEncoding::Ascii, PlyEncoding::LittleEndian, PlyEncoding::BigEndian})
        if (m_words[1] == nameOf(encoding)) {
            m_header.encoding = encoding;
            m_hasFormat = true;
            return;
        }
    fail(inQuotes(m_words[1]) + " is not a format that PLY knows");
}

void HeaderParser::parseElement() {
    if (m_words.size() < 3)
        fail("an element needs a name and a count");
    const auto count = countOf(m_words[2]);
    if (!count)
        fail(inQuotes(m_words[2]) + " is not a count of elements");
    if (m_header.elements.size() == mostElements)
        fail("declares more than " + std::to_string(mostElements) + " elements");
    m_header.elements.push_back({std::string(m_words[1]), static_cast<std::size_t>(*count), {}});
}

void HeaderParser::parseProperty() {
    if (m_header.elements.empty())
        fail("a property stands before any element");
    auto& properties = m_header.elements.back().properties;
    if (properties.size() == mostProperties)
        fail("declares more than " + std::to_string(mostProperties) + " properties");
    PlyProperty property;
    property.isList = m_words.size() > 1 && m_words[1] == "list";
    if (m_words.size() < (property.isList ? 5u : 3u))
        fail("a property needs a type and a name");
    if (property.isList) {
        property.countType = typeOf(m_words[2]);
        if (surfel::isReal(property.countType))
            fail("the count of a list cannot be of type " + std::string(m_words[2]));
    }
    property.type = typeOf(m_words[property.isList ? 3 : 1]);
    property.name = m_words[property.isList ? 4 : 2];
    properties.push_back(std::move(property));
}

constexpr std::size_t longestLine = 5; ///< words of a line that declares anything

PlyHeader HeaderParser::parse() {
    if (!nextLine() || m_line != "ply")
        fail("does not start with 'ply'");
    while (nextLine()) {
        const std::string_view word = m_words.empty() ? std::string_view() : m_words[0];
        if (word == "end_header") {
            if (!m_hasFormat)
                fail("the header has no format line");
            m_header.bodyOffset = m_at;
            return std::move(m_header);
        }
        if (word == "format")
            parseFormat();
        else if (word == "element")
            parseElement();
        else if (word == "property")
            parseProperty();
        else if (word == "comment")
            m_header.comments.push_back(restAfter(word));
        else if (word == "obj_info")
            m_header.comments.emplace_back(m_line);
        else if (m_words.size() > longestLine)
            m_header.comments.emplace_back(m_line); // some exporters forget the word
        else if (!word.empty())
            fail(inQuotes(m_line) + " is not a line of a PLY header");
    }
    m_file.fail("the header has no end_header line", "the file is damaged or was cut off; fetch it again");
}

} // namespace

const char* nameOf(PlyEncoding encoding) {
    switch (encoding) {
    case PlyEncoding::LittleEndian:
        return "binary_little_endian";
    case PlyEncoding::BigEndian:
        return "binary_big_endian";
    case PlyEncoding::Ascii:
        break;
    }
    return "ascii";
}

const char* plyName(ScalarType type) {
    return std::find_if(std::begin(typeNames), std::end(typeNames),
                        [&](const TypeName& row) { return row.type == type; })
        ->name;
}

bool PlyElement::hasLists() const {
    return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.isList; });
}

std::size_t PlyElement::scalarBytes() const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties)
        bytes += property.isList ? 0 : sizeOf(property.type);
    return bytes;
}

std::string PlyElement::declaration() const {
    std::string out = "element " + name + " " + std::to_string(count) + "\n";
    for (const PlyProperty& property : properties)
        out += std::string("property ") +
               (property.isList ? std::string("list ") + plyName(property.countType) + " " : "") +
               plyName(property.type) + " " + property.name + "\n";
    return out;
}

PlyHeader parsePlyHeader(const FileBytes& file) {
    return HeaderParser(file).parse();
}

} // namespace io
