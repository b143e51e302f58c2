#include "core/io/pcd/pcd_header.h"

#include "core/io/number_text.h"
#include "core/io/text/text_lines.h"

#include <algorithm>
#include <span>

namespace io {

static const char* const noHeader = "choose a file that the Point Cloud Library can read";

std::optional<ScalarType> PcdField::scalar() const {
    switch (type) {
    case 'I':
        return size == 1   ? std::optional(ScalarType::Int8)
               : size == 2 ? std::optional(ScalarType::Int16)
               : size == 4 ? std::optional(ScalarType::Int32)
                           : std::nullopt;
    case 'U':
        return size == 1   ? std::optional(ScalarType::UInt8)
               : size == 2 ? std::optional(ScalarType::UInt16)
               : size == 4 ? std::optional(ScalarType::UInt32)
                           : std::nullopt;
    default:
        return size == 4 ? ScalarType::Float32 : ScalarType::Float64;
    }
}

namespace {

std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at < line.size();) {
        if (isBlank(line[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (end < line.size() && !isBlank(line[end]))
            ++end;
        out.push_back(line.substr(at, end - at));
        at = end;
    }
    return out;
}

class HeaderParser {
  public:
    explicit HeaderParser(const FileBytes& file) : m_file(file) {}
    PcdHeader parse();

  private:
    /// Takes one line; true for the last one, DATA.
    bool take(std::string_view line);
    void takeFields(std::span<const std::string_view> names);
    void takeData(std::string_view word);
    template <class Set>
    void takeEach(std::span<const std::string_view> words, const Set& set);
    std::size_t countIn(std::span<const std::string_view> words) const;
    void finish();
    [[noreturn]] void fail(const std::string& what) const { m_file.failAt(m_at, what, noHeader); }

    const FileBytes& m_file;
    PcdHeader m_header;
    std::size_t m_at = 0; ///< where the line starts
    bool m_hasPoints = false;
};

std::size_t HeaderParser::countIn(std::span<const std::string_view> words) const {
    const auto count = words.empty() ? std::nullopt : countOf(words.front());
    if (!count)
        fail("the header needs a whole number here");
    return *count;
}

void HeaderParser::takeFields(std::span<const std::string_view> names) {
    if (names.size() > 1000)
        fail("the header names more than 1000 fields");
    m_header.fields.resize(names.size());
    for (std::size_t k = 0; k < names.size(); ++k)
        m_header.fields[k].name = names[k];
}

template <class Set>
void HeaderParser::takeEach(std::span<const std::string_view> words, const Set& set) {
    if (words.size() != m_header.fields.size())
        fail("the header names " + std::to_string(m_header.fields.size()) + " fields, but tells of " +
             std::to_string(words.size()) + " here");
    for (std::size_t k = 0; k < words.size(); ++k)
        if (!set(m_header.fields[k], words[k]))
            fail("the header says " + inQuotes(words[k]) + ", which means nothing here");
}

void HeaderParser::takeData(std::string_view word) {
    if (word == "ascii")
        m_header.data = PcdData::Ascii;
    else if (word == "binary")
        m_header.data = PcdData::Binary;
    else if (word == "binary_compressed")
        m_header.data = PcdData::Compressed;
    else
        fail("the data are " + inQuotes(word) + ", not ascii, binary or binary_compressed");
}

bool HeaderParser::take(std::string_view line) {
    std::vector<std::string_view> all = wordsOf(line);
    if (all.empty())
        return false;
    const std::string_view key = all.front();
    const auto words = std::span(all).subspan(1);
    const char* const end = all.back().data() + all.back().size();
    if (key.starts_with('#')) {
        if (key != "#")
            m_header.comments.emplace_back(key.data() + 1, end);
        else if (!words.empty() && words.front() != ".PCD")
            m_header.comments.emplace_back(words.front().data(), end);
    } else if (key == "FIELDS" || key == "COLUMNS") {
        takeFields(words);
    } else if (key == "SIZE") {
        takeEach(words, [](PcdField& field, std::string_view word) {
            field.size = countOf(word).value_or(0);
            return field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8;
        });
    } else if (key == "TYPE") {
        takeEach(words, [](PcdField& field, std::string_view word) {
            field.type = word.front();
            return word == "I" || word == "U" || word == "F";
        });
    } else if (key == "COUNT") {
        takeEach(words, [](PcdField& field, std::string_view word) {
            field.elements = countOf(word).value_or(0);
            return field.elements > 0 && field.elements <= 100000;
        });
    } else if (key == "WIDTH") {
        m_header.width = countIn(words);
    } else if (key == "HEIGHT") {
        m_header.height = countIn(words);
    } else if (key == "POINTS") {
        m_header.points = countIn(words);
        m_hasPoints = true;
    } else if (key == "VIEWPOINT") {
        m_header.viewpoint = words.empty() ? std::string() : std::string(words.front().data(), end);
    } else if (key == "DATA") {
        takeData(words.empty() ? "" : words.front());
        return true;
    } else if (key != "VERSION") {
        fail("the header of PCD has no line " + inQuotes(key));
    }
    return false;
}

void HeaderParser::finish() {
    constexpr std::size_t most = std::size_t(1) << 40;
    if (m_header.width > most || m_header.height > most || m_header.points > most)
        m_file.fail("the header declares more points than any file holds", noHeader);
    const bool overflow = m_header.height > 0 && m_header.width > most / m_header.height;
    if (!m_hasPoints)
        m_header.points = overflow ? most : m_header.width * m_header.height;
    if (overflow)
        m_header.height = 1;
    if (m_header.fields.empty())
        m_file.fail("the header names no fields", noHeader);
    std::size_t columns = 0;
    for (PcdField& field : m_header.fields) {
        if (field.type == 'F' && field.size < 4)
            m_file.fail("the header has reals of " + std::to_string(field.size) + " bytes", noHeader);
        field.offset = m_header.stride;
        m_header.stride += field.size * field.elements;
        columns += field.elements;
    }
    if (columns > 100000)
        m_file.fail("the header tells of more than 100000 numbers a point", noHeader);
    if (m_header.points == 0)
        m_file.fail("holds no points", "choose a file with at least one");
}

PcdHeader HeaderParser::parse() {
    const std::string_view bytes = m_file.bytes();
    while (m_at < bytes.size()) {
        const std::size_t end = std::min(bytes.find('\n', m_at), bytes.size());
        if (end - m_at > 100000)
            fail("the header has a line of " + std::to_string(end - m_at) + " bytes");
        const bool last = take(bytes.substr(m_at, end - m_at));
        m_at = std::min(end + 1, bytes.size());
        if (last) {
            m_header.bodyOffset = m_at;
            finish();
            return m_header;
        }
    }
    m_file.fail("the header of PCD ends without a line DATA", noHeader);
}

} // namespace

PcdHeader parsePcdHeader(const FileBytes& file) {
    return HeaderParser(file).parse();
}

} // namespace io
