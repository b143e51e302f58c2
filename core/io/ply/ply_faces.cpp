#include "core/io/ply/ply_faces.h"

#include "core/io/ply/ply_records.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace io {

bool isFace(const PlyElement& element) {
    return element.name == "face" || element.name == "faces";
}

bool isStrips(const PlyElement& element) {
    return element.name == "tristrips";
}

static bool listsVertices(const PlyProperty& property) {
    return property.isList && (property.name == "vertex_indices" || property.name == "vertex_index");
}

/// Triangles of a strip; every other one runs the other way round.
static void addStrips(std::span<const std::int64_t> strip, mesh::Polygons& out) {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < strip.size(); ++k) {
        if (strip[k] < 0)
            begin = k + 1;
        if (k < begin + 2)
            continue;
        const bool odd = (k - begin) % 2 != 0;
        for (const std::size_t corner : {odd ? k - 1 : k - 2, odd ? k - 2 : k - 1, k})
            out.corners.push_back(static_cast<std::uint32_t>(strip[corner]));
        out.close();
    }
}

namespace {

/// What faces look like: a colour, places in a picture, the picture's number. Lists have entries where the element has
/// the properties.
class FaceLooks {
  public:
    FaceLooks(const PlyElement& element, std::string_view body, bool bigEndian, mesh::Polygons& out)
        : m_body(body), m_bigEndian(bigEndian), m_out(out) {
        for (const PlyProperty& p : element.properties) {
            m_places |= isPlace(p);
            m_colours |= !p.isList && channelOf(p) >= 0;
        }
    }
    void visit(const PlyProperty& property, std::size_t at, std::size_t items) {
        if (isPlace(property)) {
            at += sizeOf(property.countType);
            for (std::size_t k = 0; k < items; ++k, at += sizeOf(property.type))
                m_numbers.push_back(static_cast<float>(loadReal(property.type, m_body.data() + at, m_bigEndian)));
        } else if (!property.isList && property.name == "texnumber") {
            const std::int64_t number = loadInteger(property.type, m_body.data() + at, m_bigEndian);
            m_picture = number < 0 || number >= mesh::Polygons::noPicture ? mesh::Polygons::noPicture
                                                                          : static_cast<std::uint32_t>(number);
        } else if (const int channel = channelOf(property); channel >= 0 && !property.isList) {
            takeColour(property, channel, at);
        }
    }
    /// The face that was visited, with so many corners.
    void close(std::size_t corners) {
        if (m_colours)
            m_out.colours.push_back(m_colour);
        if (m_places) {
            m_out.pictureOf.push_back(m_picture);
            for (std::size_t k = 0; k < corners; ++k)
                m_out.places.push_back(m_numbers.size() == 2 * corners
                                           ? mesh::Polygons::Place{m_numbers[2 * k], m_numbers[2 * k + 1]}
                                           : mesh::Polygons::Place());
        }
        m_numbers.clear();
        m_colour = surfel::white;
        m_picture = 0;
    }

  private:
    static bool isPlace(const PlyProperty& property) { return property.isList && property.name == "texcoord"; }
    static int channelOf(const PlyProperty& property) {
        static constexpr std::string_view names[] = {"red", "green", "blue"};
        for (int k = 0; k < 3; ++k)
            if (property.name == names[k] || property.name == "diffuse_" + std::string(names[k]))
                return k;
        return -1;
    }
    /// Bytes as they are, wider integers over 257, reals from 0 to 1.
    void takeColour(const PlyProperty& property, int channel, std::size_t at) {
        const double value = loadReal(property.type, m_body.data() + at, m_bigEndian);
        const double scaled = surfel::isReal(property.type) ? value * 255
                              : sizeOf(property.type) > 1   ? value / 257
                                                            : value;
        const auto byte = scaled > 0 ? static_cast<surfel::Colour>(std::min(255.0, std::floor(scaled + 0.5))) : 0;
        m_colour = (m_colour & ~(surfel::Colour(0xff) << (8 * channel))) | byte << (8 * channel);
    }

    std::string_view m_body;
    bool m_bigEndian, m_places = false, m_colours = false;
    mesh::Polygons& m_out;
    std::vector<float> m_numbers;
    surfel::Colour m_colour = surfel::white;
    std::uint32_t m_picture = 0;
};

} // namespace

mesh::Polygons polygonsOf(const FileBytes& file, std::string_view body, const PlyElement& element, std::size_t offset,
                          bool bigEndian) {
    constexpr std::int64_t none = std::numeric_limits<std::uint32_t>::max();
    mesh::Polygons out;
    if (std::none_of(element.properties.begin(), element.properties.end(), listsVertices))
        return out;
    const bool strips = isStrips(element);
    const RecordWalker walker(file, body, element, bigEndian);
    FaceLooks looks(element, body, bigEndian, out);
    std::vector<std::int64_t> list;
    for (std::size_t i = 0; i < element.count; ++i) {
        list.clear();
        offset = walker.pass(offset, [&](const PlyProperty& property, std::size_t at, std::size_t items) {
            if (!listsVertices(property)) {
                if (!strips)
                    looks.visit(property, at, items);
                return;
            }
            at += sizeOf(property.countType);
            for (std::size_t k = 0; k < items; ++k, at += sizeOf(property.type))
                list.push_back(loadInteger(property.type, body.data() + at, bigEndian));
        });
        if (strips) {
            addStrips(list, out);
            continue;
        }
        for (const std::int64_t corner : list)
            out.corners.push_back(static_cast<std::uint32_t>(corner < 0 ? none : std::min(corner, none)));
        out.close();
        looks.close(list.size());
    }
    return out;
}

} // namespace io
