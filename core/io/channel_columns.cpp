#include "core/io/channel_columns.h"

#include "core/base/parallel.h"
#include "core/io/file_coordinates.h"
#include "core/io/record_roles.h"

#include <algorithm>
#include <cstring>

namespace io {

using surfel::ScalarType;

static constexpr std::size_t grain = 2048;       // rows per chunk
static constexpr std::size_t block = 64 * grain; // rows per write, some 4 MB, and between two looks at the cancel flag

template <class T, class Value>
void ChannelColumns::add(const std::string& name, ScalarType type, const Value& value) {
    m_columns.push_back(
        {name, type, m_stride, [value](std::size_t begin, std::size_t end, char* out, std::size_t stride) {
             for (std::size_t i = begin; i < end; ++i, out += stride) {
                 const T each = static_cast<T>(value(i));
                 std::memcpy(out, &each, sizeof each);
             }
         }});
    m_stride += sizeof(T);
}

void ChannelColumns::addPositions() {
    const auto& items = m_model.points.items;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string name(1, "xyz"[k]);
        if (hasOrigin(m_model))
            add<double>(name, ScalarType::Float64, [this, k](std::size_t i) { return fileCoordinates(m_model, i)[k]; });
        else
            add<float>(name, ScalarType::Float32, [&items, k](std::size_t i) { return items[i].position[k]; });
    }
}

void ChannelColumns::addColours(bool packed) {
    const auto& items = m_model.points.items;
    if (!packed) {
        for (unsigned k = 0; k < 4; ++k)
            add<std::uint8_t>(channelColours[k], ScalarType::UInt8,
                              [&items, k](std::size_t i) { return items[i].colour >> (8 * k); });
        return;
    }
    const bool opaque =
        std::all_of(items.begin(), items.end(), [](const surfel::Surfel& s) { return s.colour >> 24 == 255; });
    const auto turned = [&items](std::size_t i) {
        const surfel::Colour c = items[i].colour;
        return (c & 0xff00ff00u) | (c & 0xffu) << 16 | (c >> 16 & 0xffu);
    };
    if (opaque)
        add<std::uint32_t>("rgb", ScalarType::Float32, [turned](std::size_t i) { return turned(i) & 0xffffffu; });
    else
        add<std::uint32_t>("rgba", ScalarType::UInt32, turned);
}

/// Words of integers hold them widened: the low bytes are the value.
void ChannelColumns::addAttribute(const surfel::Attribute& attribute) {
    const std::uint32_t* const first = m_model.points.extra.data() + attribute.firstWord;
    const std::size_t words = m_model.points.layout->words();
    const auto word = [first, words](std::size_t i) { return first[i * words]; };
    switch (attribute.type) {
    case ScalarType::Int8:
    case ScalarType::UInt8:
        return add<std::uint8_t>(attribute.name, attribute.type, word);
    case ScalarType::Int16:
    case ScalarType::UInt16:
        return add<std::uint16_t>(attribute.name, attribute.type, word);
    case ScalarType::Int32:
    case ScalarType::UInt32:
    case ScalarType::Float32:
        return add<std::uint32_t>(attribute.name, attribute.type, word);
    case ScalarType::Float64:
        return add<std::uint64_t>(attribute.name, attribute.type, [first, words](std::size_t i) {
            return static_cast<std::uint64_t>(first[i * words + 1]) << 32 | first[i * words];
        });
    }
}

ChannelColumns::ChannelColumns(const FileModel& model, const ChannelOptions& options) : m_model(model) {
    const auto& items = m_model.points.items;
    const surfel::AttributeLayout& layout = *m_model.points.layout;
    addPositions();
    if (layout.normals)
        for (std::size_t k = 0; k < 3; ++k)
            add<float>(std::string("n") + "xyz"[k], ScalarType::Float32,
                       [&items, k](std::size_t i) { return items[i].normal[k]; });
    if (layout.colours)
        addColours(options.packedColour);
    if (m_model.hasSupports)
        add<float>("support_radius", ScalarType::Float32, [&items](std::size_t i) { return items[i].support; });
    if (layout.masks)
        add<float>("mask", ScalarType::Float32, [&items](std::size_t i) { return items[i].mask; });
    if (options.locals && !coordinatesAreExact(m_model))
        for (std::size_t k = 0; k < 3; ++k)
            add<float>(localNames[k], ScalarType::Float32, [&items, k](std::size_t i) { return items[i].position[k]; });
    for (const surfel::Attribute& attribute : layout.attributes())
        addAttribute(attribute);
}

void ChannelColumns::write(SafeFile& file, const base::Progress& progress) const {
    const std::size_t n = m_model.points.size();
    std::string buffer(std::min(block, n) * m_stride, '\0');
    for (std::size_t first = 0; first < n; first += block) {
        progress.step(static_cast<double>(first) / static_cast<double>(n), "Writing");
        const std::size_t rows = std::min(block, n - first);
        base::parallelChunks(rows, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            for (const ChannelColumn& column : m_columns)
                column.fill(first + begin, first + end, buffer.data() + begin * m_stride + column.offset, m_stride);
        });
        file.write({buffer.data(), rows * m_stride});
    }
}

} // namespace io
