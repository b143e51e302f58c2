#include "core/io/threemf/threemf_parts.h"

#include "core/io/number_text.h"

#include <limits>

namespace io::threemf {

namespace {

const char* const damaged = "the file is damaged; export it again";

std::uint32_t idOf(std::string_view text) {
    const auto count = countOf(text);
    return count && *count < nothing ? static_cast<std::uint32_t>(*count) : nothing;
}

/// Entries are named without the slash that parts begin with.
std::string entryName(std::string_view part) {
    return std::string(part.starts_with('/') ? part.substr(1) : part);
}

/// "#RRGGBB" or "#RRGGBBAA"; white where it is neither.
surfel::Colour colourOf(std::string_view text) {
    surfel::Colour out = surfel::white;
    if ((text.size() != 7 && text.size() != 9) || text[0] != '#')
        return out;
    for (unsigned k = 0; 2 * k + 2 < text.size(); ++k) {
        unsigned value = 0;
        for (const char c : text.substr(1 + 2 * k, 2)) {
            const int digit = c >= '0' && c <= '9'   ? c - '0'
                              : c >= 'a' && c <= 'f' ? c - 'a' + 10
                              : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                     : -1;
            if (digit < 0)
                return surfel::white;
            value = 16 * value + static_cast<unsigned>(digit);
        }
        out = (out & ~(255u << 8 * k)) | value << 8 * k;
    }
    return out;
}

/// Twelve numbers: the images of the axes, then the shift.
Placement placementOf(std::string_view text) {
    Placement out;
    double numbers[12];
    for (double& number : numbers) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        const char* const end = parseNumber(text.data(), text.data() + text.size(), number);
        if (!end)
            return out;
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            out.linear[r][c] = numbers[3 * c + r];
    out.shift = {numbers[9], numbers[10], numbers[11]};
    return out;
}

class PartReader {
  public:
    explicit PartReader(const FileBytes& file) : m_file(file) {}
    void begin(const XmlTag& tag);
    void end(std::string_view name);
    Part take() { return std::move(m_part); }

  private:
    void vertex(const XmlTag& tag);
    void triangle(const XmlTag& tag);
    double number(const XmlTag& tag, std::string_view name) const;
    static Placed placed(const XmlTag& tag) {
        return {entryName(tag["path"]), idOf(tag["objectid"]), placementOf(tag["transform"])};
    }

    const FileBytes& m_file;
    Part m_part;
    Object* m_object = nullptr;
    Group* m_group = nullptr;
};

double PartReader::number(const XmlTag& tag, std::string_view name) const {
    const auto value = numberOf(tag[name]);
    if (!value)
        m_file.fail("a " + std::string(tag.name) + " has no number " + std::string(name), damaged);
    return *value;
}

void PartReader::vertex(const XmlTag& tag) {
    m_object->vertices.push_back({number(tag, "x"), number(tag, "y"), number(tag, "z")});
}

void PartReader::triangle(const XmlTag& tag) {
    Triangle out;
    out.corners = {idOf(tag["v1"]), idOf(tag["v2"]), idOf(tag["v3"])};
    out.group = idOf(tag["pid"]);
    const std::uint32_t first = idOf(tag["p1"]), second = idOf(tag["p2"]), third = idOf(tag["p3"]);
    out.properties = {first, second == nothing ? first : second, third == nothing ? first : third};
    if (first == nothing || out.group == nothing) // what the triangle does not tell is the object's
        out.group = m_object->group;
    if (first == nothing)
        out.properties.fill(m_object->property);
    m_object->triangles.push_back(out);
}

void PartReader::begin(const XmlTag& tag) {
    const std::string_view name = tag.name;
    if (name == "vertex" && m_object)
        vertex(tag);
    else if (name == "triangle" && m_object)
        triangle(tag);
    else if (name == "object") {
        m_object = &m_part.objects[idOf(tag["id"])];
        *m_object = {};
        m_object->group = idOf(tag["pid"]);
        m_object->property = idOf(tag["pindex"]);
    } else if (name == "component" && m_object)
        m_object->components.push_back(placed(tag));
    else if (name == "item")
        m_part.build.push_back(placed(tag));
    else if (name == "basematerials" || name == "colorgroup" || name == "texture2dgroup") {
        m_group = &m_part.groups[idOf(tag["id"])];
        *m_group = {};
        m_group->picture = idOf(tag["texid"]);
    } else if ((name == "base" || name == "color") && m_group)
        m_group->colours.push_back(colourOf(tag[name == "base" ? "displaycolor" : "color"]));
    else if (name == "tex2coord" && m_group)
        m_group->places.push_back({static_cast<float>(number(tag, "u")), static_cast<float>(number(tag, "v"))});
    else if (name == "texture2d")
        m_part.pictures[idOf(tag["id"])] = {entryName(tag["path"]), tag["tilestyleu"] == "clamp"};
    else if (name == "model")
        for (const char* unit : {"micron", "centimeter", "inch", "foot", "meter"})
            m_part.unit = tag["unit"] == unit ? unit : m_part.unit;
}

void PartReader::end(std::string_view name) {
    if (name == "object")
        m_object = nullptr;
    else if (name == "basematerials" || name == "colorgroup" || name == "texture2dgroup")
        m_group = nullptr;
}

void parse(const FileBytes& file, const ZipEntry& entry, XmlStream& xml, std::size_t& left,
           const base::Progress& progress) {
    bool good = true;
    unpackWithin(file, entry, left, progress, [&](std::string_view piece) { good = good && xml.take(piece, false); });
    if (!good || !xml.take({}, true))
        file.fail(inQuotes(entry.name) + " in it is no XML", damaged);
}

} // namespace

void unpackWithin(const FileBytes& file, const ZipEntry& entry, std::size_t& left, const base::Progress& progress,
                  const std::function<void(std::string_view)>& sink) {
    unpackEntry(file, entry, progress, [&](std::string_view piece) {
        if (piece.size() > left)
            file.fail("becomes too long when all of it is unpacked", "do not open it, unless you trust it");
        left -= piece.size();
        sink(piece);
    });
}

Part readPart(const FileBytes& file, const ZipEntry& entry, std::size_t& left, const base::Progress& progress) {
    PartReader reader(file);
    XmlStream xml([&](const XmlTag& tag) { reader.begin(tag); }, [&](std::string_view name) { reader.end(name); });
    parse(file, entry, xml, left, progress);
    return reader.take();
}

std::string rootPart(const FileBytes& file, const std::vector<ZipEntry>& entries, std::size_t& left,
                     const base::Progress& progress) {
    std::string out;
    for (const ZipEntry& entry : entries)
        if (entry.name == "_rels/.rels") {
            const auto begin = [&](const XmlTag& tag) {
                if (tag["Type"].ends_with("/3dmodel"))
                    out = entryName(tag["Target"]);
            };
            XmlStream xml(begin, [](std::string_view) {});
            parse(file, entry, xml, left, progress);
            break;
        }
    return out;
}

} // namespace io::threemf
