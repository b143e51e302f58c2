#include "core/io/gltf/gltf_output.h"

#include "core/base/parallel.h"
#include "core/base/srgb.h"
#include "core/io/file_name.h"
#include "core/io/safe_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

namespace io::gltf {

using nlohmann::ordered_json;

namespace {

/// Bytes as they are, or in base 64.
class Output {
  public:
    Output(SafeFile& file, bool asText) : m_file(file), m_asText(asText) {}
    void write(std::string_view bytes) {
        if (!m_asText)
            return m_file.write(bytes);
        m_left.append(bytes);
        const std::size_t whole = m_left.size() / 3 * 3;
        m_file.write(encoded(std::string_view(m_left).substr(0, whole)));
        m_left.erase(0, whole);
    }
    void finish() {
        const std::size_t missing = m_left.empty() ? 0 : 3 - m_left.size();
        m_left.append(missing, '\0');
        std::string text = encoded(m_left);
        std::fill_n(text.end() - static_cast<std::ptrdiff_t>(missing), missing, '=');
        m_file.write(text);
    }

  private:
    static std::string encoded(std::string_view bytes) {
        constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string out;
        out.reserve(bytes.size() / 3 * 4);
        for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k)
                bits = bits << 8 | static_cast<unsigned char>(bytes[i + k]);
            for (int shift = 18; shift >= 0; shift -= 6)
                out += letters[bits >> shift & 63];
        }
        return out;
    }

    SafeFile& m_file;
    bool m_asText;
    std::string m_left;
};

constexpr const char* place = "data:application/octet-stream;base64,";

ordered_json describe(const std::vector<OutputList>& lists, const base::Vec3d& origin, bool asText) {
    ordered_json root, attributes = ordered_json::object();
    root["asset"] = {{"version", "2.0"}, {"generator", "Pointclay"}};
    root["scene"] = 0;
    root["scenes"] = {{{"nodes", {0}}}};
    ordered_json node{{"mesh", 0}}, primitive;
    if (!(origin == base::Vec3d{}))
        node["translation"] = {origin.x, origin.y, origin.z};
    root["nodes"] = ordered_json::array({node});
    primitive["mode"] = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const OutputList& list = lists[i];
        const bool corners = list.name.empty();
        ordered_json view{{"buffer", 0}, {"byteOffset", at}, {"byteLength", list.count * list.stride}};
        if (!corners)
            view["byteStride"] = list.stride;
        view["target"] = corners ? 34963 : 34962;
        const std::size_t numbers = corners ? 3 * list.count : list.count;
        ordered_json accessor{{"bufferView", i},
                              {"componentType", static_cast<int>(list.component)},
                              {"count", numbers},
                              {"type", list.type}};
        if (list.normalised)
            accessor["normalized"] = true;
        if (!list.least.empty())
            accessor["min"] = list.least, accessor["max"] = list.most;
        root["bufferViews"].push_back(view);
        root["accessors"].push_back(accessor);
        at += list.count * list.stride;
        if (corners)
            primitive["indices"] = i, primitive["mode"] = 4;
        else
            attributes[list.name] = i;
    }
    primitive["attributes"] = attributes;
    root["meshes"] = {{{"primitives", ordered_json::array({primitive})}}};
    ordered_json buffer{{"byteLength", at}};
    if (asText)
        buffer["uri"] = place;
    root["buffers"] = ordered_json::array({buffer});
    return root;
}

void writeNumbers(Output& output, const std::vector<OutputList>& lists, std::size_t size,
                  const base::Progress& progress) {
    constexpr std::size_t block = std::size_t(1) << 17;
    std::size_t done = 0;
    for (const OutputList& list : lists)
        for (std::size_t first = 0; first < list.count; first += block) {
            progress.step(static_cast<double>(done) / static_cast<double>(size), "Writing");
            std::string buffer(std::min(block, list.count - first) * list.stride, '\0');
            base::parallelFor(std::min(block, list.count - first), 2048,
                              [&](std::size_t i) { list.put(first + i, buffer.data() + i * list.stride); });
            output.write(buffer);
            done += buffer.size();
        }
}

std::string word(std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    return {reinterpret_cast<const char*>(&bits), sizeof bits};
}

} // namespace

void writeLists(const std::filesystem::path& target, std::vector<OutputList> lists, const base::Vec3d& origin,
                const base::Progress& progress) {
    const bool asText = extensionOf(target) == "gltf";
    std::erase_if(lists, [](const OutputList& list) { return list.count == 0; });
    std::size_t size = 0;
    for (const OutputList& list : lists)
        size += list.count * list.stride;
    std::string text = describe(lists, origin, asText).dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    if (size + text.size() + 28 > std::numeric_limits<std::uint32_t>::max())
        throw base::Error("needs more than the 4 GiB that glTF can have", target.string(), "write PLY, or thin it");
    SafeFile file(target);
    Output output(file, asText);
    const std::size_t split = asText ? text.find(place) + std::string_view(place).size() : text.size();
    if (!asText)
        file.write("glTF" + word(2) + word(28 + text.size() + size) + word(text.size()) + "JSON");
    file.write(std::string_view(text).substr(0, split));
    if (!asText)
        file.write(word(size) + std::string("BIN\0", 4));
    writeNumbers(output, lists, size, progress);
    if (asText) {
        output.finish();
        file.write(std::string_view(text).substr(split));
    }
    file.commit();
}

static OutputList vectorList(const char* name, std::size_t count,
                             const std::function<base::Vec3f(std::size_t)>& vector) {
    OutputList out{name};
    out.count = count;
    out.put = [vector](std::size_t i, char* to) {
        const base::Vec3f v = vector(i);
        std::memcpy(to, &v, sizeof v);
    };
    return out;
}

OutputList positionList(std::size_t count, const std::function<base::Vec3f(std::size_t)>& position) {
    OutputList out = vectorList("POSITION", count, position);
    constexpr float infinite = std::numeric_limits<float>::infinity();
    base::Vec3f least{infinite, infinite, infinite}, most = -least;
    for (std::size_t i = 0; i < count; ++i) {
        const base::Vec3f p = position(i);
        for (std::size_t k = 0; k < 3; ++k)
            least[k] = std::min(least[k], p[k]), most[k] = std::max(most[k], p[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        out.least.push_back(static_cast<double>(least[k]));
        out.most.push_back(static_cast<double>(most[k]));
    }
    return out;
}

OutputList normalList(std::size_t count, const std::function<base::Vec3f(std::size_t)>& normal) {
    return vectorList("NORMAL", count, normal);
}

OutputList colourList(std::size_t count, const std::function<std::uint32_t(std::size_t)>& colour) {
    std::array<std::uint16_t, 256> linear{};
    for (std::size_t i = 0; i < 256; ++i)
        linear[i] = static_cast<std::uint16_t>(base::linearOf(static_cast<float>(i) / 255) * 65535 + 0.5f);
    OutputList out{"COLOR_0", Component::UInt16, "VEC4", 8, count};
    out.normalised = true;
    out.put = [linear, colour](std::size_t i, char* to) {
        const std::uint32_t c = colour(i);
        const std::uint16_t channels[4] = {linear[c & 255], linear[c >> 8 & 255], linear[c >> 16 & 255],
                                           static_cast<std::uint16_t>((c >> 24) * 257)};
        std::memcpy(to, channels, sizeof channels);
    };
    return out;
}

} // namespace io::gltf
