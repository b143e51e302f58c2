#include "core/session/commands/scans/viewpoints.h"

#include "core/io/number_text.h"

#include <sstream>

namespace session {

using base::Vec3d;

namespace {

struct Viewpoint {
    std::size_t begin; ///< of its numbers in the comment
    Vec3d place;
};

std::optional<Viewpoint> viewpointIn(const std::string& comment) {
    constexpr std::string_view word = "viewpoint ";
    const std::size_t at = comment.rfind(word);
    if (at != 0 && !(at != std::string::npos && comment.starts_with("scan ")))
        return {};
    Viewpoint out{at + word.size(), {}};
    std::istringstream in(comment.substr(out.begin));
    in.imbue(std::locale::classic());
    const bool told = static_cast<bool>(in >> out.place.x >> out.place.y >> out.place.z);
    return told && base::isFinite(out.place) ? std::optional(out) : std::nullopt;
}

/// Ordered grids without a comment were seen from the origin, as their formats say.
bool isGrid(const surfel::AttributeLayout& layout) {
    return layout.find("row") && layout.find("column");
}

} // namespace

std::vector<std::string> movedViewpoints(std::vector<std::string> comments, const surfel::AttributeLayout& layout,
                                         const selection::Affine& map) {
    const auto numbersOf = [&](const Vec3d& place) {
        const Vec3d to = map(place);
        std::string out;
        for (const double each : {to.x, to.y, to.z})
            io::appendNumber(out, each), out += ' ';
        return out + "1 0 0 0";
    };
    bool any = false;
    for (std::string& comment : comments)
        if (const std::optional<Viewpoint> found = viewpointIn(comment))
            comment.replace(found->begin, std::string::npos, numbersOf(found->place)), any = true;
    if (!any && isGrid(layout))
        comments.push_back("viewpoint " + numbersOf({}));
    return comments;
}

std::optional<process::Eyes> eyesOf(const Document& document, const surfel::SurfelList& points) {
    process::Eyes out;
    for (const std::string& comment : document.provenance().comments)
        if (const std::optional<Viewpoint> found = viewpointIn(comment))
            out.places.push_back(found->place);
    if (out.places.empty() && isGrid(*points.layout))
        out.places.emplace_back();
    if (out.places.empty())
        return {};
    const surfel::Attribute* scan = points.layout->find("scan");
    if (!scan && out.places.size() > 1)
        return {};
    if (scan) // of one place, too: other scans may have been moved onto the file's
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double number = surfel::read(*scan, points.extraOf(i));
            if (!(number >= 0 && number < static_cast<double>(out.places.size())))
                return {};
            out.of.push_back(static_cast<std::uint32_t>(number));
        }
    for (Vec3d& place : out.places)
        place = place - document.provenance().origin;
    return out;
}

} // namespace session
