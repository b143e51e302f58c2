#include "core/io/xml_document.h"

#include "core/io/number_text.h"

#include <pugixml.hpp>

namespace io {

static XmlElement elementOf(const pugi::xml_node& node, int depth) {
    XmlElement out;
    out.name = node.name();
    out.text = node.text().get();
    for (const pugi::xml_attribute& each : node.attributes())
        out.attributes.emplace_back(each.name(), each.value());
    for (const pugi::xml_node& each : node.children())
        if (each.type() == pugi::node_element && depth < 64)
            out.children.push_back(elementOf(each, depth + 1));
    return out;
}

XmlElement parseXml(std::string_view text) {
    pugi::xml_document document;
    if (!document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_trim_pcdata))
        return {};
    return elementOf(document.document_element(), 0);
}

const XmlElement& XmlElement::child(std::string_view wanted) const {
    static const XmlElement nothing;
    for (const XmlElement& each : children)
        if (each.name == wanted)
            return each;
    return nothing;
}

std::string_view XmlElement::attribute(std::string_view wanted) const {
    for (const auto& [key, value] : attributes)
        if (key == wanted)
            return value;
    return {};
}

double XmlElement::number(double without) const {
    return io::numberOf(text).value_or(without);
}

} // namespace io
