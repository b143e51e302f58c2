// E57: one scan with all that the points have. The fields of ASTM E2807 where it has any, those of its extension for
// normals, and our own for the rest (io/README 2.14). Every field is as wide as whole bytes, so that a packet's streams
// are the columns' bytes.
#include "core/base/random.h"
#include "core/io/channel_columns.h"
#include "core/io/e57/paged_bytes.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/record_table.h"

#include <algorithm>
#include <cstdio>
#include <set>

namespace io {

namespace {

constexpr std::size_t pageSize = 1024, payload = pageSize - 4, headSize = 48, sectionHead = 32;

constexpr std::size_t physical(std::size_t logical) {
    return logical / payload * pageSize + logical % payload;
}

/// Bytes cut into pages, each with its checksum.
class PagedOutput {
  public:
    explicit PagedOutput(SafeFile& file) : m_file(file) {}
    void write(std::string_view bytes) {
        while (!bytes.empty()) {
            const std::size_t part = std::min(bytes.size(), payload - m_page.size());
            m_page.append(bytes.substr(0, part));
            bytes.remove_prefix(part);
            if (m_page.size() == payload)
                close();
        }
    }
    void finish() {
        if (m_page.empty())
            return;
        m_page.resize(payload, '\0');
        close();
    }

  private:
    void close() {
        const std::uint32_t sum = e57::checksum(m_page);
        for (int shift = 24; shift >= 0; shift -= 8)
            m_page += static_cast<char>(sum >> shift);
        m_file.write(m_page);
        m_page.clear();
    }
    SafeFile& m_file;
    std::string m_page;
};

template <class T>
void put(std::string& out, std::size_t value) {
    const T bits = static_cast<T>(value);
    out.append(reinterpret_cast<const char*>(&bits), sizeof bits);
}

/// A name that XML can have.
std::string elementName(const std::string& name) {
    static constexpr std::pair<std::string_view, const char*> known[] = {{"x", "cartesianX"},
                                                                         {"y", "cartesianY"},
                                                                         {"z", "cartesianZ"},
                                                                         {"nx", "nor:normalX"},
                                                                         {"ny", "nor:normalY"},
                                                                         {"nz", "nor:normalZ"},
                                                                         {"red", "colorRed"},
                                                                         {"green", "colorGreen"},
                                                                         {"blue", "colorBlue"},
                                                                         {"intensity", "intensity"},
                                                                         {"row", "rowIndex"},
                                                                         {"column", "columnIndex"},
                                                                         {"return_number", "returnIndex"},
                                                                         {"number_of_returns", "returnCount"},
                                                                         {"time", "timeStamp"}};
    for (const auto& [ours, theirs] : known)
        if (name == ours)
            return theirs;
    std::string out = name;
    for (char& c : out)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-'))
            c = '_';
    if ((out[0] >= '0' && out[0] <= '9') || out[0] == '-')
        out.insert(0, 1, '_');
    return "pointclay:" + out;
}

/// The smallest whole number of a type, which E57 counts from.
std::int64_t leastOf(ScalarType type) {
    return type == ScalarType::Int8    ? -128
           : type == ScalarType::Int16 ? -32768
           : type == ScalarType::Int32 ? -2147483648
                                       : 0;
}

/// The columns' names in XML, no two the same without their prefixes, by which readers know them.
std::vector<std::string> elementNames(const std::vector<ChannelColumn>& columns) {
    const auto bare = [](const std::string& name) { return name.substr(name.rfind(':') + 1); }; // npos + 1 is 0
    std::set<std::string> taken;
    std::vector<std::string> out;
    for (const ChannelColumn& column : columns) {
        const std::string first = elementName(column.name);
        std::string name = first;
        for (int copy = 2; !taken.insert(bare(name)).second; ++copy)
            name = "pointclay:" + bare(first) + "_" + std::to_string(copy);
        out.push_back(name);
    }
    return out;
}

std::string fieldText(const ChannelColumn& column, const std::string& name) {
    if (surfel::isReal(column.type))
        return "<" + name + " type=\"Float\"" + (column.type == ScalarType::Float32 ? " precision=\"single\"" : "") +
               "/>\n";
    const std::int64_t least = leastOf(column.type), most = least + (std::int64_t(1) << (8 * sizeOf(column.type))) - 1;
    return "<" + name + " type=\"Integer\" minimum=\"" + std::to_string(least) + "\" maximum=\"" +
           std::to_string(most) + "\"/>\n";
}

/// The same points have the same one, others another.
std::string guidOf(const FileModel& model, std::uint64_t salt) {
    std::uint64_t a = base::mix(model.points.size() + salt), b = salt;
    for (const surfel::Surfel& s : model.points.items) {
        a = base::mix(a ^ std::bit_cast<std::uint32_t>(s.position.x));
        b = base::mix(b ^ a ^ std::bit_cast<std::uint32_t>(s.position.y));
        a ^= std::bit_cast<std::uint32_t>(s.position.z);
    }
    char out[48];
    std::snprintf(out, sizeof out, "{%08X-%04X-4%03X-8%03X-%012llX}", static_cast<unsigned>(a >> 32),
                  static_cast<unsigned>(a >> 16 & 0xffff), static_cast<unsigned>(a & 0xfff),
                  static_cast<unsigned>(b >> 48 & 0xfff), static_cast<unsigned long long>(b & 0xffffffffffffull));
    return out;
}

std::string xmlOf(const FileModel& model, const std::vector<ChannelColumn>& columns) {
    std::string out =
        R"(<?xml version="1.0" encoding="UTF-8"?>
<e57Root type="Structure" xmlns="http://www.astm.org/COMMIT/E57/2010-e57-v1.0" xmlns:nor="http://www.libe57.org/E57_NOR_surface_normals.txt" xmlns:pointclay="urn:pointclay:e57">
<formatName type="String">ASTM E57 3D Imaging Data File</formatName>
<guid type="String">)" +
        guidOf(model, 1) + R"(</guid>
<versionMajor type="Integer">1</versionMajor>
<versionMinor type="Integer">0</versionMinor>
<e57LibraryVersion type="String">Pointclay</e57LibraryVersion>
<coordinateMetadata type="String"/>
<data3D type="Vector" allowHeterogeneousChildren="1">
<vectorChild type="Structure">
<guid type="String">)" +
        guidOf(model, 2) + "</guid>\n<name type=\"String\">points</name>\n";
    if (model.points.layout->colours) {
        out += "<colorLimits type=\"Structure\">\n";
        for (const char* colour : {"Red", "Green", "Blue"})
            out += std::string("<color") + colour + "Minimum type=\"Integer\">0</color" + colour + "Minimum>\n<color" +
                   colour + "Maximum type=\"Integer\">255</color" + colour + "Maximum>\n";
        out += "</colorLimits>\n";
    }
    out += "<points type=\"CompressedVector\" fileOffset=\"" + std::to_string(physical(headSize)) +
           "\" recordCount=\"" + std::to_string(model.points.size()) + "\">\n<prototype type=\"Structure\">\n";
    const std::vector<std::string> names = elementNames(columns);
    for (std::size_t k = 0; k < columns.size(); ++k)
        out += fieldText(columns[k], names[k]);
    return out + "</prototype>\n<codecs type=\"Vector\" allowHeterogeneousChildren=\"1\"/>\n</points>\n</vectorChild>\n"
                 "</data3D>\n<images2D type=\"Vector\" allowHeterogeneousChildren=\"1\"/>\n</e57Root>\n";
}

/// How points go into packets of no more than 64 KiB.
struct Packets {
    std::size_t fields, recordBytes, points, each;

    explicit Packets(const FileModel& model, const std::vector<ChannelColumn>& columns)
        : fields(columns.size()), recordBytes(0), points(model.points.size()) {
        for (const ChannelColumn& column : columns)
            recordBytes += sizeOf(column.type);
        each = std::max<std::size_t>(1, (65536 - 4 - head()) / recordBytes);
    }
    std::size_t head() const { return 6 + 2 * fields; }
    std::size_t size(std::size_t count) const { return (head() + count * recordBytes + 3) / 4 * 4; }
    std::size_t allBytes() const { return points / each * size(each) + (points % each == 0 ? 0 : size(points % each)); }
};

/// Points [begin, end) as a packet of data.
std::string packetOf(const std::vector<ChannelColumn>& columns, const Packets& packets, std::size_t begin,
                     std::size_t end) {
    const std::size_t count = end - begin, size = packets.size(count);
    std::string out("\1\0", 2);
    put<std::uint16_t>(out, size - 1);
    put<std::uint16_t>(out, columns.size());
    for (const ChannelColumn& column : columns)
        put<std::uint16_t>(out, count * sizeOf(column.type));
    for (const ChannelColumn& column : columns) {
        const std::size_t width = sizeOf(column.type), at = out.size();
        out.resize(at + count * width);
        column.fill(begin, end, out.data() + at, width);
        if (leastOf(column.type) < 0) // counted from the smallest number
            for (std::size_t i = at + width - 1; i < out.size(); i += width)
                out[i] = static_cast<char>(out[i] ^ 0x80);
    }
    out.resize(size, '\0');
    return out;
}

} // namespace

void writeE57(const path& target, const FileModel& model, const base::Progress& progress) {
    const ChannelColumns all(model, {});
    std::vector<ChannelColumn> columns = all.columns();
    if (model.points.layout->colours) // the first of that name is the colour's; E57 has no transparency
        columns.erase(std::find_if(columns.begin(), columns.end(),
                                   [](const ChannelColumn& column) { return column.name == "alpha"; }));
    const Packets packets(model, columns);
    const std::string xml = xmlOf(model, columns);
    const std::size_t xmlAt = headSize + sectionHead + packets.allBytes(), length = xmlAt + xml.size();
    std::string head = "ASTM-E57";
    put<std::uint32_t>(head, 1);
    put<std::uint32_t>(head, 0);
    for (const std::size_t each : {(length + payload - 1) / payload * pageSize, physical(xmlAt), xml.size(), pageSize})
        put<std::uint64_t>(head, each);
    put<std::uint64_t>(head, 1); // a section of points, and seven bytes of nothing
    for (const std::size_t each : {sectionHead + packets.allBytes(), physical(headSize + sectionHead), std::size_t(0)})
        put<std::uint64_t>(head, each);
    SafeFile file(target);
    PagedOutput output(file);
    output.write(head);
    for (std::size_t begin = 0; begin < packets.points; begin += packets.each) {
        progress.step(static_cast<double>(begin) / static_cast<double>(packets.points), "Writing");
        output.write(packetOf(columns, packets, begin, std::min(packets.points, begin + packets.each)));
    }
    output.write(xml);
    output.finish();
    file.commit();
}

} // namespace io
