// LAS: 1.2 where that holds the points, else 1.4 (io/README 2.12). The coordinates lie on the grid of whole numbers
// that they were read from, where the file came from LAS; else on one far finer than the floats inside. What the point
// formats have no field for becomes extra bytes.
#include "core/io/las/las_writer.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/io/binary_output.h"
#include "core/io/file_coordinates.h"
#include "core/io/las/las_header.h"
#include "core/io/las/las_points.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/wide_colours.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>

namespace io {

namespace {

constexpr double mostWhole = 2147483647.0;
constexpr std::size_t grain = 4096;

const surfel::Attribute* attributeOf(const FileModel& model, std::string_view name) {
    return model.points.layout->find(std::string(name));
}

/// The largest value of an attribute, 0 where there is none.
double largest(const FileModel& model, std::string_view name) {
    double out = 0;
    if (const surfel::Attribute* attribute = attributeOf(model, name))
        for (std::size_t i = 0; i < model.points.size(); ++i)
            out = std::max(out, surfel::read(*attribute, model.points.extraOf(i)));
    return out;
}

} // namespace

/// The smallest format that has a field for everything.
unsigned LasRecords::chooseFormat() const {
    const bool rgb = m_model.points.layout->colours, gps = attributeOf(m_model, "gps_time");
    const surfel::Attribute* angle = attributeOf(m_model, "scan_angle");
    const bool modern = attributeOf(m_model, "scanner_channel") || attributeOf(m_model, "nir") ||
                        (angle && angle->type != ScalarType::Int8) || m_model.points.size() > 0xffffffffu ||
                        largest(m_model, "return_number") > 7 || largest(m_model, "number_of_returns") > 7 ||
                        largest(m_model, "classification") > 31 || largest(m_model, "classification_flags") > 7;
    if (modern)
        return attributeOf(m_model, "nir") ? 8 : rgb ? 7 : 6;
    return (rgb ? 2u : 0u) + (gps ? 1u : 0u);
}

/// The grid of the LAS file that the points were read from, if they still fit it.
bool LasRecords::takeGrid() {
    for (const std::string& comment : m_model.comments) {
        if (!comment.starts_with(lasGridComment))
            continue;
        std::istringstream words(comment.substr(lasGridComment.size()));
        std::string part;
        double numbers[7];
        std::size_t found = 0;
        while (words >> part && found < 7)
            if (const auto number = numberOf(part))
                numbers[found++] = *number;
        if (found < 7 || !(numbers[6] >= 0 && numbers[6] <= 65535))
            continue;
        m_scale = {numbers[0], numbers[1], numbers[2]};
        m_offset = {numbers[3], numbers[4], numbers[5]};
        m_encoding = static_cast<unsigned>(numbers[6]);
        return fitsGrid();
    }
    return false;
}

bool LasRecords::fitsGrid() const {
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = (m_low[k] - m_offset[k]) / m_scale[k], high = (m_high[k] - m_offset[k]) / m_scale[k];
        if (!(std::abs(low) < mostWhole && std::abs(high) < mostWhole))
            return false;
    }
    return true;
}

void LasRecords::chooseGrid() {
    m_low = m_high = fileCoordinates(m_model, 0);
    for (std::size_t i = 1; i < m_model.points.size(); ++i) {
        const base::Vec3d p = fileCoordinates(m_model, i);
        for (std::size_t k = 0; k < 3; ++k)
            m_low[k] = std::min(m_low[k], p[k]), m_high[k] = std::max(m_high[k], p[k]);
    }
    if (takeGrid())
        return;
    m_encoding = 0;
    m_offset = m_model.origin;
    double reach = 0;
    for (std::size_t k = 0; k < 3; ++k)
        reach = std::max({reach, std::abs(m_low[k] - m_offset[k]), std::abs(m_high[k] - m_offset[k])});
    const double scale = reach > 0 ? std::pow(10.0, std::ceil(std::log10(reach / (mostWhole - 2)))) : 1e-3;
    m_scale = {scale, scale, scale};
    if (!(scale > 0) || !fitsGrid())
        throw base::Error("cannot be written as LAS: its coordinates are too far apart for whole numbers", {},
                          "write it as PLY");
}

void LasRecords::addExtra(const std::string& name, ScalarType type, std::function<double(std::size_t)> value) {
    static constexpr unsigned codes[] = {2, 1, 4, 3, 6, 5, 9, 10};
    std::string entry(192, '\0');
    entry[2] = static_cast<char>(codes[static_cast<std::size_t>(type)]);
    name.copy(entry.data() + 4, 31);
    m_description += entry;
    m_columns.push_back({{name, type, m_stride}, std::move(value)});
    m_stride += sizeOf(type);
}

void LasRecords::chooseColumns() {
    const surfel::AttributeLayout& has = *m_model.points.layout;
    const auto& items = m_model.points.items;
    for (const surfel::Attribute& attribute : has.attributes()) {
        const auto value = [this, attribute](std::size_t i) {
            return surfel::read(attribute, m_model.points.extraOf(i));
        };
        const bool wide =
            std::find(std::begin(wideColours), std::end(wideColours), attribute.name) != std::end(wideColours);
        const LasField* field = m_layout.find(attribute.name);
        if (wide && has.colours)
            continue;
        if (field && (field->declared() == attribute.type || field->declared() == ScalarType::Float32))
            m_columns.push_back({*field, value});
        else
            addExtra(attribute.name, attribute.type, value);
    }
    for (std::size_t k = 0; k < 3 && has.normals; ++k)
        addExtra(std::string("Normal") + "XYZ"[k], ScalarType::Float32,
                 [&items, k](std::size_t i) { return static_cast<double>(items[i].normal[k]); });
    if (m_model.hasSupports)
        addExtra("support_radius", ScalarType::Float32,
                 [&items](std::size_t i) { return static_cast<double>(items[i].support); });
    if (has.masks)
        addExtra("mask", ScalarType::Float32, [&items](std::size_t i) { return static_cast<double>(items[i].mask); });
}

LasRecords::LasRecords(const FileModel& model) : m_model(model) {
    m_format = chooseFormat();
    m_layout = lasLayout(m_format);
    m_stride = m_layout.size;
    chooseGrid();
    chooseColumns();
    for (std::size_t k = 0; k < 3; ++k)
        m_wide[k] = model.points.layout->colours ? attributeOf(model, wideColours[k]) : nullptr;
}

/// 16 bits of a channel: those that were read where the 8 bits are still theirs.
unsigned LasRecords::channelOf(std::size_t i, unsigned k) const {
    const unsigned byte = m_model.points.items[i].colour >> (8 * k) & 0xff;
    if (m_wide[k]) {
        const auto read = static_cast<unsigned>(surfel::read(*m_wide[k], m_model.points.extraOf(i)));
        if ((read + 128) / 257 == byte)
            return read;
    }
    return byte * 257;
}

void LasRecords::fill(std::size_t i, char* out) const {
    std::fill_n(out, m_stride, '\0');
    const base::Vec3d p = fileCoordinates(m_model, i);
    for (std::size_t k = 0; k < 3; ++k) {
        const double whole = std::round((p[k] - m_offset[k]) / m_scale[k]);
        const auto value = static_cast<std::int32_t>(std::clamp(whole, -mostWhole, mostWhole));
        std::memcpy(out + 4 * k, &value, sizeof value);
    }
    for (const LasColumn& column : m_columns)
        putLasValue(column.field, out, column.value(i));
    for (unsigned k = 0; k < 3 && m_layout.rgb > 0; ++k) {
        const auto value = static_cast<std::uint16_t>(channelOf(i, k));
        std::memcpy(out + m_layout.rgb + 2 * k, &value, sizeof value);
    }
}

namespace {

/// Numbers and text at their places in a header.
class HeaderBytes {
  public:
    explicit HeaderBytes(std::size_t size) : m_bytes(size, '\0') {}
    template <class T>
    void put(std::size_t at, T value) {
        std::memcpy(m_bytes.data() + at, &value, sizeof value);
    }
    void text(std::size_t at, std::string_view value) { value.copy(m_bytes.data() + at, value.size()); }
    const std::string& bytes() const { return m_bytes; }

  private:
    std::string m_bytes;
};

std::string recordOf(std::string_view user, unsigned id, std::string_view data) {
    HeaderBytes head(lasRecordHead);
    head.text(2, user);
    head.put(18, static_cast<std::uint16_t>(id));
    head.put(20, static_cast<std::uint16_t>(data.size()));
    return head.bytes() + std::string(data);
}

/// Records that were read with the points; `count` becomes their number.
std::string keptRecords(const FileModel& model, std::size_t& count) {
    std::string out;
    for (const OpaqueElement& element : model.elements) {
        if (!element.declaration.starts_with("element " + std::string(lasRecordsElement) + " "))
            continue;
        const std::string_view body = element.body;
        for (std::size_t at = 0; at + 4 <= body.size();) {
            const std::size_t size = load<std::uint32_t, false>(body.data() + at);
            if (size < lasRecordHead || size > body.size() - at - 4)
                break;
            const std::string_view record = body.substr(at + 4, size);
            if (load<std::uint16_t, false>(record.data() + 20) == size - lasRecordHead) {
                out += record;
                ++count;
            }
            at += 4 + size;
        }
    }
    return out;
}

} // namespace

std::string LasRecords::header(std::string_view further, std::size_t furtherCount, bool compressed) const {
    const std::size_t n = m_model.points.size();
    const bool latest = m_layout.isLayered || !m_description.empty();
    const std::size_t size = latest ? 375 : 227;
    std::size_t count = furtherCount;
    std::string records = keptRecords(m_model, count);
    if (!m_description.empty()) {
        if (m_description.size() > 65535)
            throw base::Error("cannot be written as LAS: it has more than 341 further attributes", {},
                              "write it as PLY");
        records += recordOf("LASF_Spec", 4, m_description);
        ++count;
    }
    records += further;
    HeaderBytes out(size);
    out.text(0, "LASF");
    out.put(6, static_cast<std::uint16_t>(m_encoding));
    out.put(24, std::uint8_t(1));
    out.put(25, std::uint8_t(latest ? 4 : 2));
    out.text(26, "OTHER");
    out.text(58, "Pointclay");
    out.put(94, static_cast<std::uint16_t>(size));
    out.put(96, static_cast<std::uint32_t>(size + records.size()));
    out.put(100, static_cast<std::uint32_t>(count));
    out.put(104, static_cast<std::uint8_t>(m_format | (compressed ? 0x80u : 0u)));
    out.put(105, static_cast<std::uint16_t>(m_stride));
    const surfel::Attribute* returns = attributeOf(m_model, "return_number");
    std::uint64_t of[15] = {};
    for (std::size_t i = 0; i < n && returns; ++i)
        if (const double k = surfel::read(*returns, m_model.points.extraOf(i)); k >= 1 && k <= 15)
            ++of[static_cast<std::size_t>(k) - 1];
    if (!m_layout.isLayered) {
        out.put(107, static_cast<std::uint32_t>(n));
        for (std::size_t k = 0; k < 5; ++k)
            out.put(111 + 4 * k, static_cast<std::uint32_t>(of[k]));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        out.put(131 + 8 * k, m_scale[k]);
        out.put(155 + 8 * k, m_offset[k]);
        const auto onGrid = [&](double x) {
            return std::round((x - m_offset[k]) / m_scale[k]) * m_scale[k] + m_offset[k];
        };
        out.put(179 + 16 * k, onGrid(m_high[k]));
        out.put(187 + 16 * k, onGrid(m_low[k]));
    }
    if (latest) {
        out.put(247, static_cast<std::uint64_t>(n));
        for (std::size_t k = 0; k < 15; ++k)
            out.put(255 + 8 * k, of[k]);
    }
    return out.bytes() + records;
}

void writeLas(const path& target, const FileModel& model, const base::Progress& progress) {
    const LasRecords records(model);
    SafeFile file(target);
    file.write(records.header({}, 0, false));
    constexpr std::size_t block = 64 * grain;
    const std::size_t n = model.points.size();
    std::string buffer(std::min(block, n) * records.stride(), '\0');
    for (std::size_t first = 0; first < n; first += block) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), "Writing");
        const std::size_t rows = std::min(block, n - first);
        base::parallelFor(rows, grain,
                          [&](std::size_t i) { records.fill(first + i, buffer.data() + i * records.stride()); });
        file.write({buffer.data(), rows * records.stride()});
    }
    progress.step(1, "Writing");
    file.commit();
}

} // namespace io
