// XML files as trees of plain elements; pugixml, which reads them, stays behind this header. No entities, no files
// named in the text, at most 64 levels.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace io {

struct XmlElement {
    std::string name; ///< with its prefix, "nor:normalX"
    std::string text; ///< of its own, not of its children
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<XmlElement> children;

    /// The first child of that name, or an element without anything.
    const XmlElement& child(std::string_view wanted) const;
    /// Empty where it is not there.
    std::string_view attribute(std::string_view wanted) const;
    /// The text as a number, whatever the locale.
    double number(double without) const;
    double numberOf(std::string_view wanted, double without) const { return child(wanted).number(without); }
};

/// The root element; its name is empty where the text is no XML.
XmlElement parseXml(std::string_view text);

} // namespace io
