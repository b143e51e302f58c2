#include "core/io/xml_stream.h"

#include <expat.h>
#include <new>

namespace io {

std::string_view XmlTag::operator[](std::string_view wanted) const {
    for (const auto& [key, value] : attributes)
        if (key == wanted)
            return value;
    return {};
}

static std::string_view withoutPrefix(const char* name) {
    const std::string_view whole(name);
    return whole.substr(whole.rfind(':') + 1); // npos + 1 is 0
}

struct XmlStream::Parser {
    XML_Parser expat = XML_ParserCreate(nullptr);
    std::function<void(const XmlTag&)> begin;
    std::function<void(std::string_view)> end;
    XmlTag tag;
    std::exception_ptr thrown; ///< nothing may be thrown through the library
    int depth = 0;

    template <class Work>
    void guarded(const Work& work) {
        constexpr int deepest = 64;
        try {
            if (!thrown && depth <= deepest)
                work();
        } catch (...) {
            thrown = std::current_exception();
        }
        if (thrown || depth > deepest)
            XML_StopParser(expat, XML_FALSE);
    }
    static void onBegin(void* self, const XML_Char* name, const XML_Char** attributes) {
        Parser& parser = *static_cast<Parser*>(self);
        ++parser.depth;
        parser.guarded([&] {
            parser.tag.name = withoutPrefix(name);
            parser.tag.attributes.clear();
            for (; attributes[0]; attributes += 2)
                parser.tag.attributes.emplace_back(withoutPrefix(attributes[0]), attributes[1]);
            parser.begin(parser.tag);
        });
    }
    static void onEnd(void* self, const XML_Char* name) {
        Parser& parser = *static_cast<Parser*>(self);
        parser.guarded([&] { parser.end(withoutPrefix(name)); });
        --parser.depth;
    }
    static void onDoctype(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
        XML_StopParser(static_cast<Parser*>(self)->expat, XML_FALSE);
    }
};

XmlStream::XmlStream(std::function<void(const XmlTag&)> begin, std::function<void(std::string_view)> end)
    : m_parser(std::make_unique<Parser>()) {
    if (!m_parser->expat)
        throw std::bad_alloc();
    m_parser->begin = std::move(begin);
    m_parser->end = std::move(end);
    XML_SetUserData(m_parser->expat, m_parser.get());
    XML_SetElementHandler(m_parser->expat, Parser::onBegin, Parser::onEnd);
    XML_SetStartDoctypeDeclHandler(m_parser->expat, Parser::onDoctype);
}

XmlStream::~XmlStream() {
    XML_ParserFree(m_parser->expat);
}

bool XmlStream::take(std::string_view piece, bool last) {
    const XML_Status status =
        XML_Parse(m_parser->expat, piece.data(), static_cast<int>(piece.size()), last ? XML_TRUE : XML_FALSE);
    if (m_parser->thrown)
        std::rethrow_exception(m_parser->thrown);
    return status == XML_STATUS_OK;
}

} // namespace io
