#include "core/io/e57/scan_points.h"

#include "core/base/parallel.h"
#include "core/io/wide_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace io::e57 {

static const char* const damaged = "the file is damaged or was cut off; fetch it again";

namespace {

constexpr std::size_t sectionHead = 32, packetHead = 6;

/// Fields that become positions, normals or colours, or only tell whether others mean anything.
constexpr std::string_view special[] = {"cartesianX",
                                        "cartesianY",
                                        "cartesianZ",
                                        "cartesianInvalidState",
                                        "sphericalRange",
                                        "sphericalAzimuth",
                                        "sphericalElevation",
                                        "sphericalInvalidState",
                                        "colorRed",
                                        "colorGreen",
                                        "colorBlue",
                                        "isColorInvalid",
                                        "normalX",
                                        "normalY",
                                        "normalZ",
                                        "isIntensityInvalid",
                                        "isTimeStampInvalid"};

/// What E57 calls otherwise than other formats do.
constexpr std::pair<std::string_view, const char*> renamed[] = {{"rowIndex", "row"},
                                                                {"columnIndex", "column"},
                                                                {"returnIndex", "return_number"},
                                                                {"returnCount", "number_of_returns"},
                                                                {"timeStamp", "time"}};

ScalarType typeOf(const PackedField& field) {
    if (field.kind == Kind::Single || field.name == "intensity")
        return ScalarType::Float32;
    const bool fits = field.least >= std::numeric_limits<std::int32_t>::min() &&
                      field.most <= std::numeric_limits<std::int32_t>::max();
    return field.kind == Kind::Integer && fits ? ScalarType::Int32 : ScalarType::Float64;
}

/// Of a scan: where its fields stand among its streams, -1 where they are not.
struct Places {
    explicit Places(const Scan& scan) {
        for (std::size_t k = 0; k < 3; ++k) {
            cartesian[k] = scan.find(std::string("cartesian") + "XYZ"[k]);
            normal[k] = scan.find(std::string("normal") + "XYZ"[k]);
        }
        spherical[0] = scan.find("sphericalRange");
        spherical[1] = scan.find("sphericalAzimuth");
        spherical[2] = scan.find("sphericalElevation");
        colour[0] = scan.find("colorRed"), colour[1] = scan.find("colorGreen"), colour[2] = scan.find("colorBlue");
        noColour = scan.find("isColorInvalid");
        isCartesian = all(cartesian);
        invalid = scan.find(isCartesian ? "cartesianInvalidState" : "sphericalInvalidState");
    }
    static bool all(const int (&fields)[3]) { return fields[0] >= 0 && fields[1] >= 0 && fields[2] >= 0; }

    int cartesian[3], spherical[3], normal[3], colour[3];
    int invalid = -1, noColour = -1;
    bool isCartesian = false;
};

class Values {
  public:
    Values(const std::vector<PackedStream>& streams, std::uint64_t record) : m_streams(streams), m_record(record) {}
    double operator[](int field) const { return m_streams[static_cast<std::size_t>(field)].value(m_record); }
    base::Vec3d vector(const int (&fields)[3]) const {
        return {(*this)[fields[0]], (*this)[fields[1]], (*this)[fields[2]]};
    }

  private:
    const std::vector<PackedStream>& m_streams;
    std::uint64_t m_record;
};

base::Vec3d placeOf(const Scan& scan, const Places& places, const Values& values) {
    if (places.invalid >= 0 && values[places.invalid] != 0) {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan, nan};
    }
    base::Vec3d p;
    if (places.isCartesian) {
        p = values.vector(places.cartesian);
    } else {
        const base::Vec3d s = values.vector(places.spherical);
        const double across = s.x * std::cos(s.z);
        p = {across * std::cos(s.y), across * std::sin(s.y), s.x * std::sin(s.z)};
    }
    return scan.pose.isIdentity() ? p : scan.pose.turned(p) + scan.pose.translation;
}

/// Least and most of a colour field: the limits that the scan tells, or the range of the field.
std::pair<double, double> colourRange(const Scan& scan, const PackedField& field) {
    if (scan.colourMost > scan.colourLeast)
        return {scan.colourLeast, scan.colourMost};
    if (field.kind == Kind::Integer && field.most > field.least)
        return {static_cast<double>(field.least), static_cast<double>(field.most)};
    return {0, 255};
}

/// 0..1 within that range.
double colourShare(const Scan& scan, const PackedField& field, double value) {
    const auto [least, most] = colourRange(scan, field);
    const double share = (value - least) / (most - least);
    return std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
}

bool hasWideColours(const Scan& scan, const Places& places) {
    return Places::all(places.colour) && std::any_of(places.colour, places.colour + 3, [&](int k) {
               const PackedField& field = scan.fields[static_cast<std::size_t>(k)];
               const auto [least, most] = colourRange(scan, field);
               return field.kind == Kind::Integer && most - least > 255;
           });
}

template <class T>
void put(char* at, T value) {
    std::memcpy(at, &value, sizeof value);
}

void putAs(ScalarType type, char* at, double value) {
    if (type == ScalarType::Float32)
        put(at, static_cast<float>(value));
    else if (type == ScalarType::Float64)
        put(at, value);
    else if (type == ScalarType::UInt16)
        put(at, static_cast<std::uint16_t>(value));
    else
        put(at, static_cast<std::int32_t>(std::isfinite(value) ? value : 0));
}

/// The streams of a scan from its packets, one after the other.
class Packets {
  public:
    Packets(const FileBytes& file, const PagedBytes& pages, const Scan& scan) : m_file(file), m_pages(pages) {
        const std::size_t at = pages.logical(scan.at);
        char head[sectionHead];
        pages.read(at, head);
        const auto length = load<std::uint64_t, false>(head + 8);
        if (head[0] != 1 || length < sectionHead || length > pages.size() - at)
            fail();
        m_at = pages.logical(load<std::uint64_t, false>(head + 16));
        m_end = at + static_cast<std::size_t>(length);
        if (m_at < at + sectionHead || m_at > m_end)
            fail();
    }
    /// Appends the next packet of data to the streams; false where there is none any more.
    bool next(std::vector<PackedStream>& streams) {
        while (m_at + packetHead <= m_end) {
            char head[packetHead];
            m_pages.read(m_at, head);
            const std::size_t size = std::size_t(load<std::uint16_t, false>(head + 2)) + 1;
            if (size < packetHead || size > m_end - m_at)
                fail();
            const std::size_t at = m_at;
            m_at += size;
            if (head[0] == 1) {
                take(at, size, load<std::uint16_t, false>(head + 4), streams);
                return true;
            }
            if (head[0] != 0 && head[0] != 2)
                fail();
        }
        return false;
    }

  private:
    void take(std::size_t at, std::size_t size, std::size_t count, std::vector<PackedStream>& streams) {
        m_buffer.resize(size);
        m_pages.read(at, {m_buffer.data(), size});
        std::size_t from = packetHead + 2 * count;
        if (count != streams.size() || from > size)
            fail();
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t length = load<std::uint16_t, false>(m_buffer.data() + packetHead + 2 * k);
            if (length > size - from)
                fail();
            streams[k].append(std::string_view(m_buffer).substr(from, length));
            from += length;
        }
    }
    [[noreturn]] void fail() const { m_file.fail("the packets of a scan make no sense", damaged); }

    const FileBytes& m_file;
    const PagedBytes& m_pages;
    std::size_t m_at = 0, m_end = 0; ///< logical
    std::string m_buffer;
};

} // namespace

void ScanPoints::add(const char* name, const std::string& given, ScalarType type, bool isGeneral) {
    m_columns.push_back({name, given, type, m_stride, isGeneral});
    m_stride += sizeOf(type);
}

void ScanPoints::addGeneral(const PackedField& field) {
    if (std::find(std::begin(special), std::end(special), field.name) != std::end(special))
        return;
    for (Column& column : m_columns)
        if (column.isGeneral && field.name == column.name) {
            if (column.type != typeOf(field)) // scans that do not agree
                column.type = ScalarType::Float64;
            return;
        }
    std::string given = field.name;
    for (const auto& [theirs, ours] : renamed)
        if (field.name == theirs)
            given = ours;
    add(m_names.emplace_back(field.name).c_str(), given, typeOf(field), true);
}

ScanPoints::ScanPoints(const FileBytes& file, const PagedBytes& pages, const std::vector<Scan>& scans)
    : m_file(file), m_pages(pages), m_scans(scans) {
    std::size_t fields = 0;
    bool exact = true;
    m_normals = true;
    for (const Scan& scan : scans) {
        const Places places(scan);
        if (!places.isCartesian && !Places::all(places.spherical))
            file.fail("a scan has neither cartesian nor spherical coordinates", "choose a file with points");
        unsigned bits = 0;
        for (const int k : places.isCartesian ? places.cartesian : places.spherical)
            bits += scan.fields[static_cast<std::size_t>(k)].bits();
        if (bits == 0)
            file.fail("a scan has all its points at one place", "choose a file with points");
        for (const int k : places.cartesian)
            exact &= places.isCartesian && scan.fields[static_cast<std::size_t>(k)].kind == Kind::Single;
        exact &= scan.pose.isIdentity();
        m_normals &= Places::all(places.normal);
        m_colours |= Places::all(places.colour);
        m_wide |= hasWideColours(scan, places);
        fields += scan.fields.size();
    }
    m_names.reserve(fields); // columns point into it
    for (std::size_t k = 0; k < 3; ++k)
        add("", std::string(1, "xyz"[k]), exact ? ScalarType::Float32 : ScalarType::Float64, false);
    for (std::size_t k = 0; k < 3 && m_normals; ++k)
        add("", std::string("n") + "xyz"[k], ScalarType::Float32, false);
    static constexpr const char* colours[] = {"red", "green", "blue"};
    for (std::size_t k = 0; k < 3 && m_colours; ++k)
        add("", colours[k], ScalarType::UInt8, false);
    for (std::size_t k = 0; k < 3 && m_wide; ++k)
        add("", wideColours[k], ScalarType::UInt16, false);
    if (scans.size() > 1)
        add("", "scan", ScalarType::UInt16, false);
    for (const Scan& scan : scans)
        for (const PackedField& field : scan.fields)
            addGeneral(field);
    m_stride = 0; // types may have changed
    for (Column& column : m_columns) {
        column.offset = m_stride;
        m_stride += sizeOf(column.type);
    }
}

void ScanPoints::fill(const Scan& scan, std::size_t number, const std::vector<PackedStream>& streams,
                      std::uint64_t count) {
    const Places places(scan);
    char* const first = m_records.grow(static_cast<std::size_t>(count) * m_stride);
    base::parallelFor(static_cast<std::size_t>(count), 1024, [&](std::size_t i) {
        const Values values(streams, i);
        char* const record = first + i * m_stride;
        std::size_t column = 0;
        const auto next = [&](double value) {
            putAs(m_columns[column].type, record + m_columns[column].offset, value);
            ++column;
        };
        const base::Vec3d p = placeOf(scan, places, values);
        next(p.x), next(p.y), next(p.z);
        if (m_normals) {
            const base::Vec3d n = values.vector(places.normal);
            const base::Vec3d turned = scan.pose.isIdentity() ? n : scan.pose.turned(n);
            next(turned.x), next(turned.y), next(turned.z);
        }
        double shares[3] = {1, 1, 1};
        if (Places::all(places.colour) && (places.noColour < 0 || values[places.noColour] == 0))
            for (std::size_t k = 0; k < 3; ++k)
                shares[k] = colourShare(scan, scan.fields[static_cast<std::size_t>(places.colour[k])],
                                        values[places.colour[k]]);
        for (std::size_t k = 0; k < 3 && m_colours; ++k)
            put(record + m_columns[column++].offset, static_cast<std::uint8_t>(shares[k] * 255 + 0.5));
        for (std::size_t k = 0; k < 3 && m_wide; ++k)
            next(shares[k] * 65535 + 0.5);
        if (m_scans.size() > 1)
            next(static_cast<double>(number));
        for (; column < m_columns.size();) {
            const int k = scan.find(m_columns[column].name);
            next(k >= 0 ? values[k] : 0.0);
        }
    });
    m_count += static_cast<std::size_t>(count);
}

void ScanPoints::read(std::size_t number, const ProgressSpan& progress) {
    const Scan& scan = m_scans[number];
    std::vector<PackedStream> streams;
    for (const PackedField& field : scan.fields)
        streams.emplace_back(field);
    Packets packets(m_file, m_pages, scan);
    std::uint64_t left = scan.count;
    constexpr std::uint64_t enough = 16384; // records that are worth a parallel loop
    for (bool more = true; left > 0 && more;) {
        more = packets.next(streams);
        std::uint64_t whole = left;
        for (const PackedStream& stream : streams)
            whole = std::min(whole, stream.available());
        if (whole == 0 || (more && whole < std::min(enough, left)))
            continue;
        progress.step(1 - static_cast<double>(left) / static_cast<double>(scan.count));
        fill(scan, number, streams, whole);
        for (PackedStream& stream : streams)
            stream.drop(whole);
        left -= whole;
    }
    if (left > 0)
        m_file.fail("scan " + std::to_string(number + 1) + " should have " + std::to_string(scan.count) +
                        " points, but " + std::to_string(scan.count - left) + " are there",
                    damaged);
}

RecordTable ScanPoints::table() {
    RecordTable out;
    for (const Column& column : m_columns)
        out.fields.push_back({column.given, column.type, column.type, column.offset});
    out.data = m_records.data();
    out.stride = m_stride;
    out.count = m_count;
    return out;
}

} // namespace io::e57
