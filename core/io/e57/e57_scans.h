// The scans of an E57 file, as its XML section describes them (io/README 2.14).
#pragma once

#include "core/base/vec.h"
#include "core/io/e57/packed_stream.h"
#include "core/io/file_bytes.h"
#include "core/io/xml_document.h"

#include <vector>

namespace io::e57 {

/// Where a scan stands: a point p of it is at rotation p + translation.
struct Pose {
    double w = 1, x = 0, y = 0, z = 0; ///< unit quaternion
    base::Vec3d translation;

    bool isIdentity() const { return w == 1 && translation == base::Vec3d{}; }
    base::Vec3d turned(const base::Vec3d& p) const;
};

struct Scan {
    std::string name;
    std::vector<PackedField> fields; ///< in the order of their streams
    std::uint64_t count = 0;         ///< of records, as claimed
    std::uint64_t at = 0;            ///< physical offset of the section
    Pose pose;
    double colourLeast = 0, colourMost = 0; ///< equal where nothing is said

    /// Index of the field, or -1.
    int find(std::string_view wanted) const;
    bool has(std::string_view wanted) const { return find(wanted) >= 0; }
};

/// Those that have points. Throws base::Error where the XML is not one of E57 or a scan makes no sense.
std::vector<Scan> scansOf(const FileBytes& file, const XmlElement& root);

} // namespace io::e57
