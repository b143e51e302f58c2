#include "core/io/record_points.h"

#include "core/base/large_memory.h"
#include "core/base/parallel.h"
#include "core/base/unit_normal.h"
#include "core/io/origin_choice.h"
#include "core/io/wide_colours.h"
#include "core/process/estimation/keep_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace io {

namespace {

constexpr std::size_t grain = 2048;       // rows per chunk: their surfels stay in the second-level cache
constexpr std::size_t slab = 256 * grain; // rows between two looks at the cancel flag, some 10 ms

/// Rows [begin, end) of a table on their way to surfels.
struct Rows {
    const RecordTable& table;
    std::size_t begin, end;
};

/// Calls `sink(row, value)` with the typed values of one column.
template <class Sink>
void forColumn(const Rows& rows, const Field& field, const Sink& sink) {
    if (field.made || field.isScaled()) {
        for (std::size_t i = rows.begin; i < rows.end; ++i)
            sink(i, valueOf(rows.table, field, i));
        return;
    }
    withType(field.stored, [&]<class T>() {
        const char* bytes = rows.table.record(rows.begin) + field.offset;
        const std::size_t stride = rows.table.stride;
        if (rows.table.bigEndian)
            for (std::size_t i = rows.begin; i < rows.end; ++i, bytes += stride)
                sink(i, load<T, true>(bytes));
        else
            for (std::size_t i = rows.begin; i < rows.end; ++i, bytes += stride)
                sink(i, load<T, false>(bytes));
    });
}

void runSlabs(std::size_t n, const ProgressSpan& progress,
              const std::function<void(std::size_t begin, std::size_t end, std::size_t chunk)>& body) {
    for (std::size_t first = 0; first < n; first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(n));
        const std::size_t size = std::min(slab, n - first);
        base::parallelChunks(size, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            body(first + begin, first + end, first / grain + chunk);
        });
    }
}

/// A name under which every format can write the attribute and find it again: no blanks, no name of a fixed channel,
/// and no name twice.
std::string attributeName(std::string name, const surfel::AttributeLayout& layout) {
    for (char& c : name)
        c = c > ' ' && c < 0x7f && c != ',' && c != ';' && c != '"' ? c : '_';
    if (name.empty())
        name = "unnamed";
    std::string out = name;
    for (int copy = 2; isChannelName(out) || layout.find(out); ++copy)
        out = name + "_" + std::to_string(copy);
    return out;
}

/// The conversion of one table; each method takes one role for a range of rows.
class PointMaker {
  public:
    PointMaker(FileModel& model, const FileBytes& file, const RecordTable& table, const RecordRoles& roles)
        : m_model(model), m_file(file), m_points(model.points), m_table(table), m_roles(roles) {}

    void run(const PointOptions& options, const ProgressSpan& progress);

  private:
    const Field& field(int index) const { return m_table.fields[static_cast<std::size_t>(index)]; }
    std::vector<base::Vec3d> sample() const;
    double columnMax(int index) const;
    bool anyFine(int index) const;
    void makeLayout(const PointOptions& options);
    void chooseScales();
    void chooseAttributes();
    void convert(const Rows& rows, std::size_t chunk);
    void positions(const Rows& rows);
    void exactPositions(const Rows& rows);
    void normals(const Rows& rows);
    void colours(const Rows& rows);
    void attributes(const Rows& rows);
    std::size_t countBad(const Rows& rows) const;
    void dropBad();
    void keepFaces(std::span<const std::uint32_t> numbers);
    void judgeSupports();

    FileModel& m_model;
    const FileBytes& m_file;
    surfel::SurfelList& m_points;
    const RecordTable& m_table;
    const RecordRoles& m_roles;
    double m_scale[4] = {1, 1, 1, 1}; ///< of the colour channels
    std::vector<Field> m_attributes;  ///< columns that become attributes, in their order
    std::vector<std::size_t> m_bad;   ///< per chunk
};

std::vector<base::Vec3d> PointMaker::sample() const {
    const std::size_t wanted = std::min<std::size_t>(m_table.count, 4096);
    std::vector<base::Vec3d> out;
    for (std::size_t s = 0; s < wanted; ++s) {
        // Where the s-th of `wanted` equal parts starts, without overflow.
        const std::size_t i = m_table.count / wanted * s + (m_table.count % wanted) * s / wanted;
        base::Vec3d p;
        for (std::size_t k = 0; k < 3; ++k)
            if (m_roles.position[k] != RecordRoles::none)
                p[k] = valueOf(m_table, field(m_roles.position[k]), i);
        if (base::isFinite(p))
            out.push_back(p);
    }
    return out;
}

double PointMaker::columnMax(int index) const {
    std::vector<double> most(base::chunkCount(m_table.count, grain), 0.0);
    base::parallelChunks(m_table.count, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        double found = 0;
        forColumn({m_table, begin, end}, field(index), [&](std::size_t, auto value) {
            const double v = static_cast<double>(value);
            found = v > found ? v : found; // false for nan
        });
        most[chunk] = found;
    });
    return *std::max_element(most.begin(), most.end());
}

void PointMaker::chooseScales() {
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if (sizeOf(field(m_roles.colour[k]).declared) > 1)
            most = std::max(most, columnMax(m_roles.colour[k]));
    for (std::size_t k = 0; k < 4; ++k) {
        if (m_roles.colour[k] == RecordRoles::none)
            continue;
        const ScalarType type = field(m_roles.colour[k]).declared;
        const double largest = k == 3 && sizeOf(type) > 1 ? columnMax(m_roles.colour[3]) : most;
        if (sizeOf(type) == 1)
            m_scale[k] = 1;
        else if (surfel::isReal(type) && largest <= 1)
            m_scale[k] = 255;
        else
            m_scale[k] = largest > 255 ? 1 / 257.0 : 1;
    }
}

/// Whether a column of colours holds 16 bits that its bytes do not bring back.
bool PointMaker::anyFine(int index) const {
    if (surfel::isReal(field(index).declared))
        return false;
    std::vector<std::uint8_t> fine(base::chunkCount(m_table.count, grain), 0);
    base::parallelChunks(m_table.count, grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        forColumn({m_table, begin, end}, field(index), [&](std::size_t, auto value) {
            const double v = static_cast<double>(value);
            fine[chunk] |= v > 0 && v < 65536 && std::fmod(v, 257) != 0 ? 1 : 0;
        });
    });
    return std::find(fine.begin(), fine.end(), 1) != fine.end();
}

void PointMaker::chooseAttributes() {
    for (const int index : m_roles.attributes)
        m_attributes.push_back(field(index));
    const auto& colour = m_roles.colour;
    const bool wide = m_roles.hasColours() && std::all_of(m_scale, m_scale + 3, [](double s) { return s < 1; });
    if (!wide || std::none_of(colour.begin(), colour.begin() + 3, [&](int index) { return anyFine(index); }))
        return;
    for (std::size_t k = 0; k < 3; ++k) {
        Field& added = m_attributes.emplace_back(field(colour[k]));
        added.name = wideColours[k];
        added.declared = ScalarType::UInt16;
    }
}

void PointMaker::makeLayout(const PointOptions& options) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = m_roles.hasNormals();
    layout->oriented = layout->normals && options.oriented;
    layout->colours = m_roles.hasColours();
    layout->masks = m_roles.mask != RecordRoles::none;
    for (const Field& source : m_attributes)
        layout->add(attributeName(source.name, *layout), source.declared);
    m_points.layout = layout;
}

void PointMaker::positions(const Rows& rows) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (m_roles.position[k] == RecordRoles::none)
            continue;
        const double origin = m_model.origin[k];
        forColumn(rows, field(m_roles.position[k]), [&](std::size_t i, auto value) {
            m_points.items[i].position[k] = static_cast<float>(static_cast<double>(value) - origin);
        });
    }
}

/// The exact floats that the native writer put beside its doubles, wherever the two still agree: a program that moved
/// the points without knowing ours moved the doubles only.
void PointMaker::exactPositions(const Rows& rows) {
    for (std::size_t k = 0; k < 3; ++k)
        forColumn(rows, field(m_roles.local[k]), [&](std::size_t i, auto value) {
            const double stated = valueOf(m_table, field(m_roles.position[k]), i);
            if (static_cast<double>(value) + m_model.origin[k] == stated)
                m_points.items[i].position[k] = static_cast<float>(value);
        });
}

void PointMaker::normals(const Rows& rows) {
    for (std::size_t k = 0; k < 3; ++k)
        forColumn(rows, field(m_roles.normal[k]),
                  [&](std::size_t i, auto value) { m_points.items[i].normal[k] = static_cast<float>(value); });
    for (std::size_t i = rows.begin; i < rows.end; ++i)
        m_points.items[i].normal = base::unitNormal(m_points.items[i].normal);
}

void PointMaker::colours(const Rows& rows) {
    for (unsigned k = 0; k < 4; ++k) {
        if (m_roles.colour[k] == RecordRoles::none)
            continue;
        const unsigned shift = 8 * k;
        forColumn(rows, field(m_roles.colour[k]), [&](std::size_t i, auto value) {
            unsigned byte;
            if constexpr (std::is_same_v<decltype(value), std::uint8_t>) {
                byte = value;
            } else {
                const double scaled = static_cast<double>(value) * m_scale[k];
                byte = scaled > 0 ? static_cast<unsigned>(std::min(255.0, std::floor(scaled + 0.5))) : 0u;
            }
            surfel::Colour& colour = m_points.items[i].colour;
            colour = (colour & ~(0xffu << shift)) | byte << shift;
        });
    }
}

void PointMaker::attributes(const Rows& rows) {
    const std::size_t words = m_points.layout->words();
    for (std::size_t a = 0; a < m_attributes.size(); ++a) {
        const Field& source = m_attributes[a];
        const surfel::Attribute& attribute = m_points.layout->attributes()[a];
        std::uint32_t* const first = m_points.extra.data();
        forColumn(rows, source, [&](std::size_t i, auto value) {
            std::uint32_t* const out = first + i * words;
            using T = decltype(value);
            if (source.stored != source.declared) {
                surfel::write(attribute, {out, words}, static_cast<double>(value));
            } else if constexpr (std::is_same_v<T, double>) {
                const auto bits = std::bit_cast<std::uint64_t>(value);
                out[attribute.firstWord] = static_cast<std::uint32_t>(bits);
                out[attribute.firstWord + 1] = static_cast<std::uint32_t>(bits >> 32);
            } else if constexpr (std::is_same_v<T, float>) {
                out[attribute.firstWord] = std::bit_cast<std::uint32_t>(value);
            } else {
                out[attribute.firstWord] = static_cast<std::uint32_t>(value);
            }
        });
    }
}

std::size_t PointMaker::countBad(const Rows& rows) const {
    std::size_t bad = 0;
    for (std::size_t i = rows.begin; i < rows.end; ++i)
        bad += base::isFinite(m_points.items[i].position) ? 0 : 1;
    return bad;
}

void PointMaker::convert(const Rows& rows, std::size_t chunk) {
    positions(rows);
    if (m_roles.hasLocals())
        exactPositions(rows);
    if (m_roles.hasNormals())
        normals(rows);
    if (m_roles.hasColours())
        colours(rows);
    if (m_roles.support != RecordRoles::none)
        forColumn(rows, field(m_roles.support),
                  [&](std::size_t i, auto value) { m_points.items[i].support = static_cast<float>(value); });
    if (m_roles.mask != RecordRoles::none)
        forColumn(rows, field(m_roles.mask), [&](std::size_t i, auto value) {
            const auto mask = static_cast<float>(value);
            m_points.items[i].mask = mask > 0 ? std::min(mask, 1.0f) : 0.0f; // nan becomes 0
        });
    attributes(rows);
    m_bad[chunk] = countBad(rows);
}

void PointMaker::dropBad() {
    for (const std::size_t bad : m_bad)
        m_model.dropped += bad;
    std::vector<std::uint32_t> numbers(m_model.polygons.size() > 0 ? m_points.items.size() : 0,
                                       std::numeric_limits<std::uint32_t>::max());
    if (m_model.dropped == 0) {
        std::iota(numbers.begin(), numbers.end(), 0u);
        keepFaces(numbers);
        return;
    }
    std::uint32_t kept = 0;
    process::keepPoints(m_points, [&](std::size_t i) {
        const bool finite = base::isFinite(m_points.items[i].position);
        if (finite && !numbers.empty())
            numbers[i] = kept;
        kept += finite ? 1 : 0;
        return finite;
    });
    if (kept == 0)
        m_file.fail("holds no finite points", "choose a file with numbers for coordinates");
    m_model.messages.push_back(std::to_string(m_model.dropped) +
                               (m_model.dropped == 1 ? " point was" : " points were") +
                               " left out because a coordinate is not finite.");
    keepFaces(numbers);
}

/// Faces follow their points to new numbers; `numbers` has the largest one for points that were dropped.
void PointMaker::keepFaces(std::span<const std::uint32_t> numbers) {
    if (const std::size_t lost = m_model.polygons.renumber(numbers); lost > 0)
        m_model.messages.push_back(std::to_string(lost) + (lost == 1 ? " face was" : " faces were") +
                                   " left out because a corner is not a point of the file.");
}

void PointMaker::judgeSupports() {
    if (m_roles.support == RecordRoles::none)
        return;
    m_model.hasSupports = std::all_of(m_points.items.begin(), m_points.items.end(), [](const surfel::Surfel& s) {
        return s.support > 0 && std::isfinite(s.support);
    });
    if (m_model.hasSupports)
        return;
    for (surfel::Surfel& s : m_points.items)
        s.support = 0;
    m_model.messages.push_back("The support radii were left out because not all of them are positive.");
}

void PointMaker::run(const PointOptions& options, const ProgressSpan& progress) {
    m_model.origin = options.origin ? *options.origin : chooseOrigin(sample(), m_table.count);
    if (m_roles.hasColours())
        chooseScales();
    chooseAttributes();
    makeLayout(options);
    m_bad.assign(base::chunkCount(m_table.count, grain), 0);
    m_points.items.reserve(m_table.count);
    base::preferLargePages(m_points.items.data(), m_table.count * sizeof(surfel::Surfel));
    m_points.items.resize(m_table.count);
    m_points.extra.resize(m_table.count * m_points.layout->words());
    runSlabs(m_table.count, progress, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        convert({m_table, begin, end}, chunk);
    });
    dropBad();
    judgeSupports();
    if (m_roles.position[2] == RecordRoles::none)
        m_model.messages.push_back("The points have no z; it was set to 0.");
}

} // namespace

void makePoints(FileModel& model, const FileBytes& file, const RecordTable& table, const RecordRoles& roles,
                const PointOptions& options, const ProgressSpan& progress) {
    if (table.count == 0)
        file.fail("holds no points", "choose a file with at least one");
    PointMaker(model, file, table, roles).run(options, progress);
}

} // namespace io
