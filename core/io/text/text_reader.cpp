// Points as text: XYZ, TXT, ASC, CSV, PTS, PWN. One row per point, fields separated by blanks, tabs, commas or
// semicolons; a line of names before, a line with the number of points before, comments of '#', '%' and '//' anywhere.
#include "core/base/listed.h"
#include "core/io/file_name.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/record_points.h"
#include "core/io/text/decimal_commas.h"
#include "core/io/text/text_columns.h"
#include "core/io/text/text_heads.h"
#include "core/io/text/text_rows.h"
#include "core/io/text/text_units.h"

#include <algorithm>
#include <cmath>

namespace io {

namespace {

constexpr const char* needsThree =
    "choose a file of three coordinates; which columns they are can be told by --columns or File > Open With";

class TextReader {
  public:
    TextReader(const FileBytes& file, const base::Progress& progress, const TextReading& how)
        : m_file(file), m_progress(progress), m_how(how) {}
    TextRead read();

  private:
    std::size_t refuseOthers() const;
    void refusePlane(const TextRows& rows, const std::vector<std::string_view>& names) const;
    bool isLabelled(const TextRows& rows, const std::vector<std::string_view>& fields) const;
    void readHead(const TextRows& rows);
    bool hasDecimalCommas(const TextRows& rows);
    void takeGivenNames(const TextRows& rows);
    void chooseColumns(const TextRows& rows);
    void checkClaim(const TextRows& rows);
    void parse(const TextRows& rows);
    void tellWrongCounts(std::size_t begin);
    void joinNormalsBelow();
    void nameColumns();
    void nameCoordinates(bool counted);
    void tellCount();
    void judgeNormals(const std::vector<ColumnFacts>& facts);
    void takeUnit();
    std::vector<std::string> takenColumns() const;
    void typeColumns(const std::vector<ColumnFacts>& facts);
    double* values() { return reinterpret_cast<double*>(m_table.owned.get()); }

    const FileBytes& m_file;
    const base::Progress& m_progress;
    const TextReading& m_how;
    FileModel m_model;
    bool m_sure = true;
    RecordTable m_table;
    std::vector<std::string> m_names;       ///< of all columns; empty where the file has none
    std::vector<std::string> m_heads;       ///< the same, whatever a person says
    std::vector<std::string> m_units;       ///< in a line below them; empty where there is none
    std::vector<int> m_targets;             ///< per column, its place in the table or -1
    std::vector<std::string> m_tableNames;  ///< of the columns in the table; empty where the file has none
    std::optional<std::uint64_t> m_claimed; ///< the count line
    std::size_t m_firstRow = 0;
    bool m_ragged = false; ///< rows differ in length, and a person has named columns
};

/// Returns where the text begins, behind a byte order mark.
std::size_t TextReader::refuseOthers() const {
    const std::string_view start = m_file.bytes().substr(0, 4096);
    if (start.starts_with("[Expe/PointSet"))
        m_file.fail("is a binary Expe point set, which cannot be read", "convert it to PLY with MeshLab");
    if (start.find('\0') != std::string_view::npos)
        m_file.fail("is binary, not text", "choose a text file or convert it to PLY");
    return start.starts_with("\xef\xbb\xbf") ? 3 : 0;
}

/// Rows of two numbers below a line of names.
void TextReader::refusePlane(const TextRows& rows, const std::vector<std::string_view>& names) const {
    if (names.size() != 2 || m_firstRow + 1 >= rows.count())
        return;
    const auto below = rows.fields(rows.row(m_firstRow + 1));
    if (below.size() == 2 && numberOf(below[0]) && numberOf(below[1]))
        m_file.failAt(rows.offset(m_firstRow + 1), "holds 2 columns where x, y and z are needed", needsThree);
}

/// Rows that begin with a word have no names above where the next one is like the first: "P1 1 2 3", "v 1 2 3".
bool TextReader::isLabelled(const TextRows& rows, const std::vector<std::string_view>& fields) const {
    if (m_firstRow + 1 >= rows.count())
        return false;
    const auto next = rows.fields(rows.row(m_firstRow + 1));
    return next.size() == fields.size() && !numberOf(next[0]) && isPoint(next, true);
}

/// Names and count before the first row of numbers.
void TextReader::readHead(const TextRows& rows) {
    for (; m_firstRow < rows.count(); ++m_firstRow) {
        const auto fields = rows.fields(rows.row(m_firstRow));
        if (fields.size() == 1 && m_firstRow == 0 && countOf(fields[0])) {
            m_claimed = countOf(fields[0]);
            continue;
        }
        if (isPoint(fields, !m_names.empty() || isLabelled(rows, fields)))
            return;
        if (!m_names.empty() && areUnits(fields)) {
            m_units.assign(fields.begin(), fields.end());
            continue;
        }
        refusePlane(rows, fields);
        if (m_firstRow > 1 || fields.size() < 3)
            m_file.failAt(rows.offset(m_firstRow), inQuotes(fields.empty() ? "" : fields[0]) + " is not a number",
                          "choose a text file with rows of coordinates");
        m_names = namesIn(rows.row(m_firstRow), fields);
    }
    m_file.fail("holds no points", "choose a file with at least one");
}

bool TextReader::hasDecimalCommas(const TextRows& rows) {
    const std::string example = decimalCommaIn(m_file, rows, m_firstRow, m_names.size());
    if (!example.empty())
        m_model.messages.push_back("Commas were read as decimal commas, as in " + inQuotes(example) + ".");
    return !example.empty();
}

/// In place of those that the file tells.
void TextReader::takeGivenNames(const TextRows& rows) {
    if (m_how.columns.empty())
        return;
    const std::size_t given = m_how.columns.size(), there = rows.fields(rows.row(m_firstRow)).size();
    if (given != there && given != m_names.size() && !m_ragged)
        m_file.failAt(rows.offset(m_firstRow),
                      "holds " + std::to_string(there) + " columns, and " + std::to_string(given) + " are named",
                      "name each of them, with - for those to be left out");
    m_names = m_how.columns;
}

/// Columns that hold words in the first row ("status" of our own query tables) are passed over, and those that are
/// named "-".
void TextReader::chooseColumns(const TextRows& rows) {
    auto fields = rows.fields(rows.row(m_firstRow));
    if (m_ragged && fields.size() > m_names.size())
        fields.resize(m_names.size());
    const bool title = m_how.columns.empty() && m_names.size() > fields.size() && !coordinatesAmong(m_names);
    if (m_names.size() < fields.size() || title)
        m_names.clear();
    const std::size_t columns = std::max(fields.size(), m_names.size());
    if (columns < 3)
        m_file.failAt(rows.offset(m_firstRow),
                      "holds " + std::to_string(columns) + (columns == 1 ? " column" : " columns") +
                          " where x, y and z are needed",
                      needsThree);
    if (columns > 1000)
        m_file.failAt(rows.offset(m_firstRow), "holds more than 1000 columns", "remove those that are not needed");
    int next = 0;
    for (std::size_t c = 0; c < columns; ++c) {
        const bool word = c < fields.size() && !fields[c].empty() && !rows.isNumber(fields[c]);
        const bool passed = !m_how.columns.empty() && m_names[c] == "-";
        m_targets.push_back(word || passed ? -1 : next++);
        if (passed)
            continue;
        if (word)
            m_model.messages.push_back("The column " +
                                       (m_names.empty() ? std::to_string(c + 1) : inQuotes(m_names[c])) +
                                       " holds words and was left out.");
        else if (!m_names.empty())
            m_tableNames.push_back(m_names[c]);
    }
    if (next < 3)
        m_file.failAt(rows.offset(m_firstRow), "holds fewer than three numbers", "choose a file with coordinates");
}

void TextReader::parse(const TextRows& rows) {
    const std::size_t n = rows.count() - m_firstRow;
    const auto columns = static_cast<std::size_t>(
        std::count_if(m_targets.begin(), m_targets.end(), [](int target) { return target >= 0; }));
    rows.checkRoom(n, m_targets.size());
    double* const out = m_table.allocateDoubles(n, columns);
    const std::size_t others = rows.parse(m_firstRow, n, m_targets, columns, out, {m_progress, 0.2, 0.7});
    if (others > 0)
        m_model.messages.push_back(std::to_string(others) + (others == 1 ? " row does" : " rows do") +
                                   " not have the " + std::to_string(m_targets.size()) +
                                   " columns that were named; what is missing was left empty, what is more left out.");
}

void TextReader::checkClaim(const TextRows& rows) {
    const std::size_t n = rows.count() - m_firstRow;
    if (m_claimed && *m_claimed > n && !m_how.head)
        m_file.fail("the first line promises " + std::to_string(*m_claimed) + " points, but " + std::to_string(n) +
                        " follow",
                    "the file is damaged or was cut off; fetch it again");
}

/// All count lines together, where the first is not it all: what they leave out was read all the same.
void TextReader::tellWrongCounts(std::size_t begin) {
    const TextRows lines(m_file, begin, {.separators = true, .comments = true}, {m_progress, 0.7, 0.7});
    std::uint64_t sum = 0;
    std::size_t looked = 0;
    lines.forRows(0, [&](std::string_view line) {
        if (looked++ % 65536 == 0)
            m_progress.step(0.7, "Reading");
        const std::size_t mark = line.find_first_not_of("0123456789 \t\r");
        if (mark != std::string_view::npos && line[mark] != '#' && line[mark] != '%' && line[mark] != '/')
            return true;
        const auto fields = lines.fields(line);
        if (fields.size() == 1) // no honest count exceeds the bytes
            sum += std::min<std::uint64_t>(countOf(fields[0]).value_or(0), m_file.size());
        return true;
    });
    if (sum != m_table.count)
        m_model.messages.push_back("The file counts " + std::to_string(sum) + " points but holds " +
                                   std::to_string(m_table.count) + "; all of these were read.");
}

/// The older PWN: the count, all positions, then all normals.
void TextReader::joinNormalsBelow() {
    if (!m_claimed || m_targets.size() != 3 || m_table.count != 2 * *m_claimed || m_table.count == 0 ||
        extensionOf(m_file.path()) != "pwn")
        return;
    const std::size_t n = m_table.count / 2;
    RecordTable joined;
    double* const out = joined.allocateDoubles(n, 6);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            out[6 * i + k] = values()[3 * i + k];
            out[6 * i + 3 + k] = values()[3 * (n + i) + k];
        }
    m_table = std::move(joined);
    m_tableNames = {"x", "y", "z", "nx", "ny", "nz"};
}

void TextReader::typeColumns(const std::vector<ColumnFacts>& facts) {
    for (std::size_t c = 0; c < facts.size(); ++c) {
        ScalarType type = typeOf(facts[c]);
        // ours, though all of their values may be 0
        if (lowerCase(m_tableNames[c]) == "mask" || m_tableNames[c].starts_with("support_shape_"))
            type = ScalarType::Float32;
        m_table.fields.push_back({m_tableNames[c], ScalarType::Float64, type, c * sizeof(double)});
    }
}

void TextReader::nameColumns() {
    const std::size_t columns = m_table.stride / sizeof(double);
    auto facts = columnFacts(values(), m_table.count, columns);
    const bool guessed = m_tableNames.empty();
    if (guessed)
        m_tableNames = guessNames(values(), m_table.count, facts);
    if (guessed && m_tableNames[0] == "number")
        tellCount();
    typeColumns(facts);
    judgeNormals(facts);
    nameCoordinates(!guessed && firstCounts(values(), m_table.count, facts));
}

void TextReader::tellCount() {
    m_model.messages.push_back("The first column counts the points and was taken for their number, not for x. If it is "
                               "x, say so by --columns, or File > Open With.");
}

/// Colours under the names of normals.
void TextReader::judgeNormals(const std::vector<ColumnFacts>& facts) {
    const RecordRoles roles = rolesOf(m_table.fields, false);
    if (!roles.hasNormals())
        return;
    std::vector<ColumnFacts> normals;
    for (const int each : roles.normal)
        normals.push_back(facts[static_cast<std::size_t>(each)]);
    const int most = mostLikeColours(normals);
    if (most == 0)
        return;
    if (!m_how.columns.empty())
        m_file.fail("nx, ny and nz hold whole numbers from 0 to " + std::to_string(most) +
                        ", as colours do, not directions",
                    "call them red,green,blue, or - to leave them out");
    m_model.messages.push_back("The normals are whole numbers from 0 to " + std::to_string(most) +
                               ", as colours are. If they are colours, say so by --columns, or File > Open With.");
}

/// Of x, y and z, where the head tells it: a comment, as files of other formats bring it.
void TextReader::takeUnit() {
    const auto places = coordinatesAmong(m_names);
    if (!places)
        return;
    const std::optional<std::string> unit = unitOfAxes(*places, m_heads, m_units);
    if (!unit)
        m_model.messages.emplace_back("x, y and z are not in one unit; their numbers were taken as they are.");
    else if (!unit->empty())
        m_model.comments.push_back("unit " + *unit);
}

/// Where none are called x, y and z: other names for them, else the first ones.
void TextReader::nameCoordinates(bool counted) {
    const RecordRoles roles = rolesOf(m_table.fields, false);
    if (std::find(roles.position.begin(), roles.position.end(), RecordRoles::none) == roles.position.end())
        return;
    if (!m_how.columns.empty()) // one of those named holds words
        m_file.fail("x, y and z must be columns of numbers", "name others");
    const auto known = coordinatesAmong(m_tableNames);
    m_sure = known.has_value();
    const std::size_t first = counted ? 1 : 0;
    const std::array<std::size_t, 3> taken = known.value_or(std::array{first, first + 1, first + 2});
    std::vector<std::string> named;
    for (std::size_t k = 0; k < 3; ++k) {
        named.push_back(inQuotes(m_tableNames[taken[k]]));
        m_table.fields[taken[k]].name = std::string(1, "xyz"[k]);
    }
    const std::string third = lowerCase(m_tableNames[taken[2]]);
    if (known && third.find('z') == std::string::npos && !third.starts_with("points:")) // a height
        m_model.up = base::UpAxis::Z;
    m_model.messages.push_back(known ? base::listed(named) + " were taken for x, y and z."
                                     : "The column names do not tell which are x, y and z; the first three" +
                                           std::string(counted ? " behind the points' numbers" : "") +
                                           " were taken. Others can be named: --columns, or File > Open With.");
}

std::vector<std::string> TextReader::takenColumns() const {
    std::vector<std::string> out;
    for (const int target : m_targets)
        out.push_back(target >= 0 && static_cast<std::size_t>(target) < m_table.fields.size()
                          ? m_table.fields[static_cast<std::size_t>(target)].name
                          : "-");
    return out;
}

TextRead TextReader::read() {
    m_progress.step(0, "Reading");
    m_model.format = extensionOf(m_file.path());
    if (m_model.format.empty())
        m_model.format = "text";
    const std::size_t begin = refuseOthers();
    RowRules rules{.separators = true, .comments = true};
    std::optional<TextRows> rows;
    rows.emplace(m_file, begin, rules, ProgressSpan{m_progress, 0, 0.1});
    m_names = commentNames(m_file.bytes().substr(begin, 4096));
    readHead(*rows);
    rules.decimalComma = hasDecimalCommas(*rows);
    rules.skipSingles = m_claimed.has_value(); // further counts may stand before further scans
    if (rules.decimalComma || rules.skipSingles)
        rows.emplace(m_file, begin, rules, ProgressSpan{m_progress, 0.1, 0.2});
    if (m_claimed) {
        m_firstRow -= 1;
        checkClaim(*rows);
        if (m_firstRow >= rows->count()) // nothing but counts
            m_file.fail("holds no points, only lines of one number", "choose a text file with rows of coordinates");
    }
    m_heads = m_names;
    m_ragged = rules.ragged = !m_how.columns.empty() && rows->isRagged(m_firstRow, m_how.columns.size());
    if (m_ragged)
        rows.emplace(m_file, begin, rules, ProgressSpan{m_progress, 0.1, 0.2});
    takeGivenNames(*rows);
    chooseColumns(*rows);
    parse(*rows);
    joinNormalsBelow();
    if (m_claimed && *m_claimed != m_table.count && !m_how.head)
        tellWrongCounts(begin);
    nameColumns();
    takeUnit();
    makePoints(m_model, m_file, m_table, rolesOf(m_table.fields, false), {}, {m_progress, 0.7, 1});
    TextRead out{std::move(m_model), takenColumns(), m_sure, {}};
    if (m_how.head)
        rows->forRows(m_firstRow, [&](std::string_view line) {
            const auto fields = rows->fields(line);
            out.rows.emplace_back(fields.begin(), fields.end());
            return out.rows.size() < 8;
        });
    return out;
}

} // namespace

FileModel readText(const FileBytes& file, const base::Progress& progress, const path&) {
    return TextReader(file, progress, {}).read().model;
}

TextRead readTextAs(const FileBytes& file, const base::Progress& progress, const TextReading& how) {
    return TextReader(file, progress, how).read();
}

} // namespace io
