#include "core/session/commands/scans/viewpoints.h"

#include <sstream>

namespace session {

using base::Vec3d;

static std::vector<Vec3d> toldIn(const std::vector<std::string>& comments) {
    constexpr std::string_view word = "viewpoint ";
    std::vector<Vec3d> out;
    for (const std::string& comment : comments) {
        const std::size_t at = comment.rfind(word);
        if (at != 0 && !(at != std::string::npos && comment.starts_with("scan ")))
            continue;
        std::istringstream in(comment.substr(at + word.size()));
        in.imbue(std::locale::classic());
        if (Vec3d place; in >> place.x >> place.y >> place.z && base::isFinite(place))
            out.push_back(place);
    }
    return out;
}

std::optional<process::Eyes> eyesOf(const Document& document, const surfel::SurfelList& points) {
    process::Eyes out;
    out.places = toldIn(document.provenance().comments);
    if (out.places.empty() && points.layout->find("row") && points.layout->find("column"))
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
