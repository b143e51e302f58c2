#include "core/io/e57/e57_scans.h"

#include "core/io/number_text.h"

#include <charconv>
#include <cmath>

namespace io::e57 {

static const char* const damaged = "the file is damaged or was cut off; fetch it again";

base::Vec3d Pose::turned(const base::Vec3d& p) const {
    const base::Vec3d axis{x, y, z};
    const base::Vec3d twice = cross(axis, p) * 2.0;
    return p + twice * w + cross(axis, twice);
}

int Scan::find(std::string_view wanted) const {
    for (std::size_t k = 0; k < fields.size(); ++k)
        if (fields[k].name == wanted)
            return static_cast<int>(k);
    return -1;
}

namespace {

std::int64_t wholeOf(std::string_view text, std::int64_t without) {
    std::int64_t out = without;
    std::from_chars(text.data(), text.data() + text.size(), out);
    return out;
}

PackedField fieldOf(const FileBytes& file, const XmlElement& element) {
    PackedField out;
    const std::string_view type = element.attribute("type");
    const std::size_t colon = element.name.find(':');
    out.name = colon == std::string::npos ? element.name : element.name.substr(colon + 1);
    if (type == "Float") {
        out.kind = element.attribute("precision") == "single" ? Kind::Single : Kind::Double;
        return out;
    }
    if (type != "Integer" && type != "ScaledInteger")
        file.fail("a scan has the field " + inQuotes(element.name) + " of type " + inQuotes(type) +
                      ", which is not known",
                  damaged);
    out.kind = type == "Integer" ? Kind::Integer : Kind::Scaled;
    out.least = wholeOf(element.attribute("minimum"), out.least);
    out.most = wholeOf(element.attribute("maximum"), out.most);
    out.scale = numberOf(element.attribute("scale")).value_or(1);
    out.offset = numberOf(element.attribute("offset")).value_or(0);
    if (out.least > out.most)
        file.fail("a scan has the field " + inQuotes(element.name) + " with an empty range", damaged);
    return out;
}

Pose poseOf(const FileBytes& file, const XmlElement& element) {
    Pose out;
    const XmlElement &rotation = element.child("rotation"), &translation = element.child("translation");
    if (!rotation.name.empty()) {
        // E57 writes a number that is zero as an element without text.
        out.w = rotation.numberOf("w", 0), out.x = rotation.numberOf("x", 0);
        out.y = rotation.numberOf("y", 0), out.z = rotation.numberOf("z", 0);
        const double norm = std::sqrt(out.w * out.w + out.x * out.x + out.y * out.y + out.z * out.z);
        if (!(norm > 0.5 && norm < 2))
            file.fail("the pose of a scan is no rotation", damaged);
        out.w /= norm, out.x /= norm, out.y /= norm, out.z /= norm;
    }
    out.translation = {translation.numberOf("x", 0), translation.numberOf("y", 0), translation.numberOf("z", 0)};
    if (!base::isFinite(out.translation))
        file.fail("the pose of a scan is not finite", damaged);
    return out;
}

} // namespace

std::vector<Scan> scansOf(const FileBytes& file, const XmlElement& root) {
    if (root.name != "e57Root")
        file.fail("the XML section is not one of E57", damaged);
    std::vector<Scan> out;
    for (const XmlElement& each : root.child("data3D").children) {
        const XmlElement& points = each.child("points");
        const auto count = countOf(points.attribute("recordCount"));
        if (points.attribute("type") != "CompressedVector" || count == 0u)
            continue;
        Scan scan;
        scan.name = each.child("name").text;
        const auto at = countOf(points.attribute("fileOffset"));
        if (!count || !at)
            file.fail("a scan does not tell where its points are", damaged);
        scan.count = *count, scan.at = *at;
        for (const XmlElement& field : points.child("prototype").children)
            scan.fields.push_back(fieldOf(file, field));
        if (scan.fields.size() > 1000)
            file.fail("a scan has more than 1000 fields", damaged);
        scan.pose = poseOf(file, each.child("pose"));
        const XmlElement& limits = each.child("colorLimits");
        scan.colourLeast = limits.numberOf("colorRedMinimum", 0);
        scan.colourMost = limits.numberOf("colorRedMaximum", 0);
        out.push_back(std::move(scan));
        if (out.size() > 65535)
            file.fail("holds more than 65535 scans", "split the file");
    }
    if (out.empty())
        file.fail("holds no points", "choose a file with scans");
    return out;
}

} // namespace io::e57
