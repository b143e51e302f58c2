#include "core/io/las/las_points.h"

#include "core/base/parallel.h"
#include "core/io/number_text.h"
#include "core/io/origin_choice.h"
#include "core/io/wide_colours.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace io {

namespace {

constexpr std::size_t grain = 65536;

/// Whether `holds(record)` for any of the records.
template <class Holds>
bool anyRecord(const RecordTable& table, const Holds& holds) {
    std::atomic<bool> found = false;
    base::parallelChunks(table.count, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end && !found.load(std::memory_order_relaxed); ++i)
            if (holds(table.record(i)))
                found = true;
    });
    return found;
}

unsigned channel(const char* record, std::size_t rgb, std::size_t k) {
    return load<std::uint16_t, false>(record + rgb + 2 * k);
}

/// How colours of 16 bits become 8 (io/README 2.12).
enum class ColourScale { None, Bytes, Shifted, Full };

class LasPoints {
  public:
    LasPoints(const LasHeader& header, RecordTable& table)
        : m_header(header), m_table(table), m_layout(lasLayout(header.format)) {}
    void addFields();
    void tell(FileModel& model) const;

  private:
    void addField(const LasField& field);
    void addColours();
    ColourScale colourScale() const;

    const LasHeader& m_header;
    RecordTable& m_table;
    LasLayout m_layout;
    bool m_black = false;
    std::vector<std::string> m_leftOut; ///< names of extra bytes
};

void LasPoints::addField(const LasField& field) {
    if (!anyRecord(m_table, [&](const char* record) { return lasValue(field, record) != 0; }))
        return;
    const bool whole = field.bits == 0 && field.declared() == field.type;
    Field out{field.name, whole ? field.type : ScalarType::Float64, field.declared(), field.offset};
    if (!whole)
        out.made = [&table = m_table, field](std::size_t i) { return lasValue(field, table.record(i)); };
    m_table.fields.push_back(out);
}

ColourScale LasPoints::colourScale() const {
    const std::size_t rgb = m_layout.rgb;
    const auto any = [&](auto holds) {
        return anyRecord(m_table, [&](const char* record) {
            return holds(channel(record, rgb, 0)) || holds(channel(record, rgb, 1)) || holds(channel(record, rgb, 2));
        });
    };
    if (rgb == 0 || !any([](unsigned v) { return v != 0; }))
        return ColourScale::None;
    if (!any([](unsigned v) { return v > 255; }))
        return ColourScale::Bytes;
    return any([](unsigned v) { return v % 256 != 0; }) ? ColourScale::Full : ColourScale::Shifted;
}

void LasPoints::addColours() {
    const ColourScale scale = colourScale();
    const std::size_t rgb = m_layout.rgb;
    m_black = rgb > 0 && scale == ColourScale::None;
    if (scale == ColourScale::None)
        return;
    static constexpr const char* names[3] = {"red", "green", "blue"};
    for (std::size_t k = 0; k < 3; ++k) {
        Field field{names[k], ScalarType::Float64, ScalarType::UInt8, rgb + 2 * k};
        field.made = [&table = m_table, scale, rgb, k](std::size_t i) {
            const unsigned v = channel(table.record(i), rgb, k);
            return static_cast<double>(scale == ColourScale::Bytes     ? v
                                       : scale == ColourScale::Shifted ? v >> 8
                                                                       : (v + 128) / 257);
        };
        m_table.fields.push_back(field);
    }
    const bool fine = scale == ColourScale::Full && anyRecord(m_table, [&](const char* record) {
                          return channel(record, rgb, 0) % 257 != 0 || channel(record, rgb, 1) % 257 != 0 ||
                                 channel(record, rgb, 2) % 257 != 0;
                      });
    for (std::size_t k = 0; k < 3 && fine; ++k)
        m_table.fields.push_back({wideColours[k], ScalarType::UInt16, ScalarType::UInt16, rgb + 2 * k});
}

void LasPoints::addFields() {
    for (std::size_t k = 0; k < 3; ++k) {
        Field field{std::string(1, "xyz"[k]), ScalarType::Int32, ScalarType::Float64, 4 * k};
        field.scale = m_header.scale[k];
        field.shift = m_header.offset[k];
        m_table.fields.push_back(field);
    }
    addColours();
    for (const LasField& field : m_layout.fields)
        addField(field);
    for (const LasField& field : extraFields(m_header, m_layout.size, &m_leftOut))
        addField(field);
}

/// The records of variable length as an element of lists.
void keepRecords(const LasHeader& header, FileModel& model) {
    std::string body;
    std::size_t count = 0;
    for (const LasRecord& record : header.records) {
        if ((record.user == "LASF_Spec" && record.id == 4) || record.user == "laszip encoded" || record.user == "copc")
            continue; // those tell of the file, not of the points
        const auto size = static_cast<std::uint32_t>(record.whole.size());
        body.append(reinterpret_cast<const char*>(&size), sizeof size);
        body += record.whole;
        ++count;
    }
    if (count > 0)
        model.elements.push_back({"element " + std::string(lasRecordsElement) + " " + std::to_string(count) +
                                      "\nproperty list uint uchar record\n",
                                  std::move(body)});
}

void LasPoints::tell(FileModel& model) const {
    std::string grid(lasGridComment);
    for (std::size_t k = 0; k < 3; ++k)
        appendNumber(grid, m_header.scale[k]), grid += ' ';
    grid += "offset ";
    for (std::size_t k = 0; k < 3; ++k)
        appendNumber(grid, m_header.offset[k]), grid += ' ';
    model.comments.push_back(grid + "encoding " + std::to_string(m_header.encoding));
    keepRecords(m_header, model);
    if (m_black)
        model.messages.emplace_back("The colours were left out because all of them are black.");
    for (const std::string& name : m_leftOut)
        model.messages.push_back("The extra bytes " + name + " were left out, since no attribute can hold them.");
    if (m_layout.waveform > 0)
        model.messages.emplace_back("The packets of waveforms were left out.");
    model.format = std::string(m_header.compressed ? "laz" : "las") + " 1." + std::to_string(m_header.minor) +
                   " point format " + std::to_string(m_header.format);
    model.up = base::UpAxis::Z;
}

} // namespace

std::vector<std::uint64_t> lasSamplePlaces(std::uint64_t count) {
    const std::uint64_t wanted = std::min<std::uint64_t>(count, 4096);
    std::vector<std::uint64_t> out;
    for (std::uint64_t s = 0; s < wanted; ++s)
        out.push_back(count / wanted * s + (count % wanted) * s / wanted);
    return out;
}

base::Vec3d lasOrigin(const base::Vec3d& scale, std::span<const base::Vec3d> sample, std::uint64_t count) {
    base::Vec3d low, high;
    bool leaves = false;
    for (std::size_t s = 0; s < sample.size(); ++s)
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = sample[s][k];
            low[k] = s == 0 ? x : std::min(low[k], x);
            high[k] = s == 0 ? x : std::max(high[k], x);
            leaves |= std::abs(x) > 0x1p23 * std::abs(scale[k]);
        }
    const base::Vec3d usual = chooseOrigin(sample, static_cast<std::size_t>(count)), middle = (low + high) * 0.5;
    if (!(usual == base::Vec3d{}) || !leaves || !base::isFinite(middle))
        return usual;
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    const double round = extent > 0 ? std::pow(10.0, std::floor(std::log10(extent))) : 1;
    return base::Vec3d{std::round(middle.x / round) * round, std::round(middle.y / round) * round,
                       std::round(middle.z / round) * round};
}

FileModel lasPoints(const FileBytes& file, const LasHeader& header, RecordTable& table, const ProgressSpan& progress) {
    progress.step(0);
    FileModel model;
    LasPoints points(header, table);
    points.addFields();
    points.tell(model);
    std::vector<base::Vec3d> sample;
    for (const std::uint64_t i : lasSamplePlaces(table.count)) {
        base::Vec3d p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = valueOf(table, table.fields[k], static_cast<std::size_t>(i));
        sample.push_back(p);
    }
    makePoints(model, file, table, rolesOf(table.fields, false), {lasOrigin(header.scale, sample, table.count), true},
               {progress.progress, progress.from, progress.to});
    return model;
}

} // namespace io
