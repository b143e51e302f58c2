// PCD, the format of the Point Cloud Library: ascii, binary, and binary_compressed, which holds one field of all points
// after the other (io/README 2.11).
#include "core/io/pcd/lzf.h"
#include "core/io/pcd/pcd_header.h"
#include "core/io/readers.h"
#include "core/io/record_points.h"
#include "core/io/text/text_rows.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace io {

namespace {

const char* const cutOff = "the file is damaged or was cut off; fetch it again";

/// The bytes of a packed colour, from the lowest.
constexpr const char* packedNames[4] = {"blue", "green", "red", "alpha"};

class PcdReader {
  public:
    PcdReader(const FileBytes& file, const base::Progress& progress) : m_file(file), m_progress(progress) {}
    FileModel read();

  private:
    void readAscii();
    void readBinary();
    void readCompressed();
    void nameBinaryFields();
    void addPackedColour(const PcdField& field);
    void addGrid();
    const PcdField* packedColour() const;

    const FileBytes& m_file;
    const base::Progress& m_progress;
    PcdHeader m_header;
    RecordTable m_table;
    FileModel m_model;
};

/// Elements of a field of several are attributes with their numbers.
std::string nameOf(const PcdField& field, std::size_t element) {
    return field.elements == 1 ? field.name : field.name + "_" + std::to_string(element + 1);
}

const PcdField* PcdReader::packedColour() const {
    const auto found = std::find_if(m_header.fields.begin(), m_header.fields.end(),
                                    [](const PcdField& field) { return field.isPackedColour(); });
    return found == m_header.fields.end() ? nullptr : &*found;
}

/// Its fourth byte counts only in `rgba`, and there only where some point is not wholly transparent.
void PcdReader::addPackedColour(const PcdField& field) {
    std::size_t channels = 3;
    const char* const alpha = m_table.data + field.offset + 3;
    for (std::size_t i = 0; field.name == "rgba" && channels == 3 && i < m_table.count; ++i)
        channels = alpha[i * m_table.stride] != 0 ? 4 : 3;
    for (std::size_t k = 0; k < channels; ++k)
        m_table.fields.push_back({packedNames[k], ScalarType::UInt8, ScalarType::UInt8, field.offset + k});
}

void PcdReader::nameBinaryFields() {
    for (const PcdField& field : m_header.fields) {
        if (field.isPadding())
            continue;
        if (&field == packedColour()) {
            addPackedColour(field);
            continue;
        }
        for (std::size_t k = 0; k < field.elements; ++k) {
            const std::size_t offset = field.offset + k * field.size;
            if (const auto type = field.scalar()) {
                m_table.fields.push_back({nameOf(field, k), *type, *type, offset});
                continue;
            }
            Field wide{nameOf(field, k), ScalarType::Float64, ScalarType::Float64, offset};
            wide.made = [this, offset, isSigned = field.type == 'I'](std::size_t i) {
                const char* const bytes = m_table.record(i) + offset;
                return isSigned ? static_cast<double>(load<std::int64_t, false>(bytes))
                                : static_cast<double>(load<std::uint64_t, false>(bytes));
            };
            m_table.fields.push_back(wide);
        }
    }
}

void PcdReader::readBinary() {
    const std::size_t room = (m_file.size() - m_header.bodyOffset) / m_header.stride;
    if (m_header.points > room)
        m_file.fail("the header declares " + std::to_string(m_header.points) + " points, but the body holds " +
                        std::to_string(room),
                    cutOff);
    m_table.data = m_file.bytes().data() + m_header.bodyOffset;
    m_table.stride = m_header.stride;
    m_table.count = m_header.points;
    nameBinaryFields();
}

void PcdReader::readCompressed() {
    const std::size_t begin = m_header.bodyOffset, left = m_file.size() - begin;
    if (left < 8)
        m_file.fail("ends before its compressed body", cutOff);
    const std::size_t packed = load<std::uint32_t, false>(m_file.bytes().data() + begin);
    const std::size_t whole = load<std::uint32_t, false>(m_file.bytes().data() + begin + 4);
    if (packed > left - 8)
        m_file.failAtByte(begin,
                          "the compressed body should have " + std::to_string(packed) + " bytes, but " +
                              std::to_string(left - 8) + " are there",
                          cutOff);
    if (whole / m_header.stride != m_header.points || whole % m_header.stride != 0 || whole > lzfMost(packed))
        m_file.failAtByte(begin + 4,
                          "the compressed body does not hold the " + std::to_string(m_header.points) +
                              " points that the header declares",
                          cutOff);
    const auto columns = std::make_unique_for_overwrite<char[]>(whole);
    m_progress.step(0.1, "Reading");
    if (!unpackLzf(m_file.bytes().substr(begin + 8, packed), {columns.get(), whole}))
        m_file.failAtByte(begin + 8, "the compressed body is damaged", cutOff);
    m_progress.step(0.3, "Reading");
    m_table.owned = std::make_unique_for_overwrite<char[]>(whole);
    m_table.data = m_table.owned.get();
    m_table.stride = m_header.stride;
    m_table.count = m_header.points;
    base::parallelChunks(m_table.count, 4096, [&](std::size_t first, std::size_t last, std::size_t) {
        for (const PcdField& field : m_header.fields) {
            const std::size_t size = field.size * field.elements;
            const char* const column = columns.get() + field.offset * m_table.count;
            for (std::size_t i = first; i < last; ++i)
                std::memcpy(m_table.owned.get() + i * m_table.stride + field.offset, column + i * size, size);
        }
    });
    nameBinaryFields();
}

void PcdReader::readAscii() {
    RowRules rules;
    rules.comments = true;
    const TextRows rows(m_file, m_header.bodyOffset, rules, {m_progress, 0, 0.2});
    if (m_header.points > rows.count())
        m_file.fail("the header declares " + std::to_string(m_header.points) + " points, but the body ends after " +
                        std::to_string(rows.count()),
                    cutOff);
    std::vector<int> targets;
    int kept = 0, colour = -1;
    for (const PcdField& field : m_header.fields)
        for (std::size_t k = 0; k < field.elements; ++k) {
            if (&field == packedColour())
                colour = kept;
            targets.push_back(field.isPadding() ? -1 : kept++);
            if (!field.isPadding() && &field != packedColour())
                m_table.fields.push_back({nameOf(field, k), ScalarType::Float64,
                                          field.scalar().value_or(ScalarType::Float64),
                                          static_cast<std::size_t>(kept - 1) * sizeof(double)});
        }
    rows.checkRoom(m_header.points, targets.size());
    double* const out = m_table.allocateDoubles(m_header.points, static_cast<std::size_t>(kept));
    rows.parse(0, m_header.points, targets, static_cast<std::size_t>(kept), out, {m_progress, 0.2, 0.7});
    if (colour < 0)
        return;
    // Of a real its bits are the colour; they replace the number, so that its bytes can be read as those of a binary
    // file.
    const PcdField packed = *packedColour();
    const auto at = static_cast<std::size_t>(colour);
    for (std::size_t i = 0; i < m_table.count; ++i) {
        double& value = out[i * static_cast<std::size_t>(kept) + at];
        const auto bits = packed.type == 'F' ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
                          : value >= -2147483648.0 && value <= 4294967295.0
                              ? static_cast<std::uint32_t>(static_cast<std::int64_t>(value))
                              : 0u;
        value = std::bit_cast<double>(static_cast<std::uint64_t>(bits));
    }
    PcdField moved = packed;
    moved.offset = at * sizeof(double);
    addPackedColour(moved);
}

/// Where a point stands in the grid, so that it is known when the empty cells are gone.
void PcdReader::addGrid() {
    if (!m_header.isGrid())
        return;
    const auto add = [&](const char* name, auto cell) {
        Field field{name, ScalarType::Float64, ScalarType::Int32, 0};
        field.made = [cell](std::size_t i) { return static_cast<double>(cell(i)); };
        m_table.fields.push_back(field);
    };
    add("row", [w = m_header.width](std::size_t i) { return i / w; });
    add("column", [w = m_header.width](std::size_t i) { return i % w; });
}

FileModel PcdReader::read() {
    m_progress.step(0, "Reading");
    m_header = parsePcdHeader(m_file);
    switch (m_header.data) {
    case PcdData::Ascii:
        readAscii();
        m_model.format = "pcd ascii";
        break;
    case PcdData::Binary:
        readBinary();
        m_model.format = "pcd binary";
        break;
    case PcdData::Compressed:
        readCompressed();
        m_model.format = "pcd binary_compressed";
        break;
    }
    addGrid();
    m_model.comments = m_header.comments;
    if (!m_header.viewpoint.empty() && m_header.viewpoint != "0 0 0 1 0 0 0")
        m_model.comments.push_back("viewpoint " + m_header.viewpoint);
    const RecordRoles roles = rolesOf(m_table.fields, false);
    if (roles.position[0] == RecordRoles::none || roles.position[1] == RecordRoles::none)
        m_file.fail("the points have no fields x and y", "choose a file with coordinates");
    makePoints(m_model, m_file, m_table, roles, {}, {m_progress, m_header.data == PcdData::Ascii ? 0.7 : 0.4, 1});
    return std::move(m_model);
}

} // namespace

FileModel readPcd(const FileBytes& file, const base::Progress& progress, const path&) {
    return PcdReader(file, progress).read();
}

} // namespace io
