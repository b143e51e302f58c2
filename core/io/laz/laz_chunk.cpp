// One chunk of a LAZ file, in both directions: the first point as it is, then the others by the models of their items.
#include "core/base/cancel_scope.h"
#include "core/io/laz/laz_setup.h"
#include "core/io/laz/point_coding.h"

namespace io::laz {

namespace {

constexpr std::uint64_t pause = 1024; ///< points between two looks at the cancel flag and at the end of the bytes

/// The items of formats 0 to 5, all from one stream.
template <class Coder>
class PlainPoints {
  public:
    PlainPoints(const Setup& setup, const char* first) : m_last(first, setup.stride), m_point(first) {
        std::size_t at = 0;
        for (const ItemRow& row : setup.items) {
            if (row.item == Item::Gps11)
                m_gps = at, m_time.emplace(first + at, false);
            else if (row.item == Item::Rgb12)
                m_rgb = at;
            else if (row.item == Item::Wave13)
                m_wave = at;
            else if (row.item == Item::Byte)
                m_extra = at, m_bytes.resize(row.size);
            at += row.size;
        }
    }
    void code(Coder& coder, char* record) {
        m_point.code(coder, record);
        if (m_time)
            m_time->code(coder, record + m_gps);
        if (m_rgb > 0)
            m_colour.code(coder, m_last.data() + m_rgb, record + m_rgb);
        if (m_wave > 0)
            m_waves.code(coder, m_last.data() + m_wave, record + m_wave);
        for (std::size_t k = 0; k < m_bytes.size(); ++k)
            m_bytes[k].code(coder, m_last.data() + m_extra + k, record + m_extra + k);
        m_last.assign(record, m_last.size());
    }

  private:
    std::string m_last;
    Point10 m_point;
    std::optional<GpsTime> m_time;
    Rgb m_colour;
    WavePacket m_waves;
    std::vector<ExtraByte> m_bytes;
    std::size_t m_gps = 0, m_rgb = 0, m_wave = 0, m_extra = 0;
};

LayeredItems layeredItems(const Setup& setup) {
    LayeredItems out;
    out.extra = setup.stride;
    std::size_t at = 0;
    for (const ItemRow& row : setup.items) {
        out.mendsChannels = row.version >= 4;
        if (row.item == Item::Rgb14 || row.item == Item::RgbNir14)
            out.rgb = at;
        if (row.item == Item::RgbNir14)
            out.nir = at + Rgb::size;
        if (row.item == Item::Wave14)
            out.wave = at;
        if (row.item == Item::Byte14)
            out.extra = at, out.extraCount = row.size;
        at += row.size;
    }
    return out;
}

/// Bytes of a record that a layer holds, and which bits of them.
struct LayerPlace {
    std::size_t at, size;
    unsigned mask = 255;
};

std::vector<LayerPlace> layerPlaces(const LayeredItems& items) {
    std::vector<LayerPlace> out{{0, 8}, {8, 4}, {16, 1}, {15, 1, 0xcf}, {12, 2}, {18, 2}, {17, 1}, {20, 2}, {22, 8}};
    if (items.rgb > 0)
        out.push_back({items.rgb, Rgb::size});
    if (items.nir > 0)
        out.push_back({items.nir, Nir::size});
    if (items.wave > 0)
        out.push_back({items.wave, WavePacket::size});
    for (std::size_t k = 0; k < items.extraCount; ++k)
        out.push_back({items.extra + k, 1});
    return out;
}

bool changes(std::string_view records, std::size_t stride, const LayerPlace& place) {
    for (std::size_t at = stride; at < records.size(); at += stride)
        for (std::size_t k = place.at; k < place.at + place.size; ++k)
            if (((byteAt(records.data() + at + k) ^ byteAt(records.data() + k)) & place.mask) != 0)
                return true;
    return false;
}

/// Grows by a point and calls `code(record)` for all but the first; false where `overran()` becomes true.
template <class Code, class Overran>
bool unpackPoints(std::size_t stride, std::uint64_t points, std::string& out, const Code& code,
                  const Overran& overran) {
    for (std::uint64_t k = 1; k < points; ++k) {
        if (k % pause == 0) {
            base::CancelScope::check();
            if (overran())
                return false;
        }
        out.append(stride, '\0');
        code(out.data() + out.size() - stride);
    }
    return !overran();
}

bool unpackLayers(std::string_view bytes, const Setup& setup, std::uint64_t points, std::string& out) {
    const LayeredItems items = layeredItems(setup);
    std::size_t at = setup.stride + 4 + 4 * items.layers();
    if (bytes.size() < at || get<std::uint32_t>(bytes.data() + setup.stride) < points)
        return false;
    std::vector<Decoder> decoders(items.layers());
    std::vector<Decoder*> layers(items.layers(), nullptr);
    for (std::size_t k = 0; k < decoders.size(); ++k) {
        const std::size_t size = get<std::uint32_t>(bytes.data() + setup.stride + 4 + 4 * k);
        if (size > bytes.size() - at)
            return false;
        if (size > 0 || k == Place) {
            decoders[k] = Decoder(bytes.substr(at, size));
            layers[k] = &decoders[k];
        }
        at += size;
    }
    LayeredPoints<Decoder> chunk(items, bytes.data(), layers);
    return unpackPoints(
        setup.stride, points, out, [&](char* record) { chunk.code(record); },
        [&] { return std::any_of(decoders.begin(), decoders.end(), [](const Decoder& d) { return d.overran(); }); });
}

std::string packLayers(std::string records, const Setup& setup) {
    const LayeredItems items = layeredItems(setup);
    const std::vector<LayerPlace> places = layerPlaces(items);
    std::vector<bool> kept;
    for (const LayerPlace& place : places)
        kept.push_back(kept.empty() || changes(records, setup.stride, place));
    std::vector<Encoder> encoders(items.layers());
    std::vector<Encoder*> layers;
    for (Encoder& encoder : encoders)
        layers.push_back(&encoder);
    LayeredPoints<Encoder> chunk(items, records.data(), layers);
    for (std::size_t at = setup.stride; at < records.size(); at += setup.stride)
        chunk.code(records.data() + at);
    std::string out = records.substr(0, setup.stride), bodies;
    const auto number = [&](std::size_t value) {
        char four[4];
        set(four, static_cast<std::uint32_t>(value));
        out.append(four, 4);
    };
    number(records.size() / setup.stride);
    for (std::size_t k = 0; k < encoders.size(); ++k) {
        const std::string body = kept[k] ? encoders[k].finish() : std::string();
        number(body.size());
        bodies += body;
    }
    return out + bodies;
}

} // namespace

bool unpackChunk(std::string_view bytes, const Setup& setup, std::uint64_t points, std::string& out) {
    out.append(bytes.substr(0, setup.stride));
    if (setup.layered)
        return unpackLayers(bytes, setup, points, out);
    Decoder decoder(bytes.substr(setup.stride));
    PlainPoints<Decoder> chunk(setup, bytes.data());
    return unpackPoints(
        setup.stride, points, out, [&](char* record) { chunk.code(decoder, record); },
        [&] { return decoder.overran(); });
}

std::string packChunk(std::string_view records, const Setup& setup) {
    std::string copy(records); // which coding writes to
    if (setup.layered)
        return packLayers(std::move(copy), setup);
    Encoder encoder;
    PlainPoints<Encoder> chunk(setup, copy.data());
    for (std::size_t at = setup.stride; at < copy.size(); at += setup.stride)
        chunk.code(encoder, copy.data() + at);
    return copy.substr(0, setup.stride) + encoder.finish();
}

} // namespace io::laz
