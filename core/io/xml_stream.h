// XML text that comes in pieces and may be longer than memory has room for: what it begins and ends, in its order;
// expat, which reads it, stays behind this header. No document types, and so no entities of their own and no files.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace io {

/// Names are without their prefixes ("path" for "p:path"). Views live as long as the call.
struct XmlTag {
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string_view>> attributes;

    /// Empty where it is not there.
    std::string_view operator[](std::string_view wanted) const;
};

class XmlStream {
  public:
    XmlStream(std::function<void(const XmlTag&)> begin, std::function<void(std::string_view name)> end);
    ~XmlStream();
    XmlStream(const XmlStream&) = delete;
    XmlStream& operator=(const XmlStream&) = delete;

    /// The next piece; false where the text is no XML. What the functions throw comes out here.
    bool take(std::string_view piece, bool last);

  private:
    struct Parser;
    std::unique_ptr<Parser> m_parser;
};

} // namespace io
