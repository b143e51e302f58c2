// E57 (ASTM E2807): all scans of the file together, each at its pose (io/README 2.14). Pictures are left out.
#include "core/io/e57/scan_points.h"
#include "core/io/number_text.h"
#include "core/io/readers.h"

namespace io {

namespace {

const char* const damaged = "the file is damaged or was cut off; fetch it again";

XmlElement xmlOf(const FileBytes& file, const e57::PagedBytes& pages) {
    const char* const head = file.bytes().data();
    const std::size_t at = pages.logical(load<std::uint64_t, false>(head + 24));
    const auto size = load<std::uint64_t, false>(head + 32);
    if (size > pages.size() - at)
        file.fail("the XML section is said to end outside of the file", damaged);
    std::string text(static_cast<std::size_t>(size), '\0');
    pages.read(at, text);
    const XmlElement root = parseXml(text);
    if (root.name.empty())
        file.fail("the XML section is damaged", damaged);
    return root;
}

/// "NAME viewpoint tx ty tz qw qx qy qz", or without the name where it is the only one.
std::string viewpointOf(const e57::Scan& scan, bool named) {
    std::string out = named ? "scan " + scan.name + " viewpoint" : "viewpoint";
    const e57::Pose& pose = scan.pose;
    for (const double each :
         {pose.translation.x, pose.translation.y, pose.translation.z, pose.w, pose.x, pose.y, pose.z})
        appendNumber(out += ' ', each);
    return out;
}

} // namespace

FileModel readE57(const FileBytes& file, const base::Progress& progress, const path&) {
    progress.step(0, "Reading");
    if (file.size() < 48 || !file.bytes().starts_with("ASTM-E57"))
        file.fail("is no E57 file", "choose one that begins with ASTM-E57");
    const e57::PagedBytes pages(file, static_cast<std::size_t>(load<std::uint64_t, false>(file.bytes().data() + 40)),
                                progress);
    const XmlElement root = xmlOf(file, pages);
    const std::vector<e57::Scan> scans = e57::scansOf(file, root);
    e57::ScanPoints points(file, pages, scans);
    for (std::size_t k = 0; k < scans.size(); ++k) {
        const auto part = [&](std::size_t i) {
            return 0.1 + 0.5 * static_cast<double>(i) / static_cast<double>(scans.size());
        };
        points.read(k, {progress, part(k), part(k + 1)});
    }
    FileModel model;
    model.format = "e57";
    for (const e57::Scan& scan : scans) // of several all, so that the k-th is that of scan k
        if (scans.size() > 1 || !scan.pose.isIdentity())
            model.comments.push_back(viewpointOf(scan, scans.size() > 1));
    if (scans.size() > 1)
        model.messages.push_back("The " + std::to_string(scans.size()) +
                                 " scans were put together at their poses; the attribute 'scan' tells them apart.");
    if (const std::size_t pictures = root.child("images2D").children.size(); pictures > 0)
        model.messages.push_back("The pictures of the file (" + std::to_string(pictures) + ") were left out.");
    const RecordTable table = points.table();
    makePoints(model, file, table, rolesOf(table.fields, false), {}, {progress, 0.6, 1});
    return model;
}

} // namespace io
