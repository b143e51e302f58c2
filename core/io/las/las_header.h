// The public header of LAS 1.0 to 1.4 and the records of variable length behind it (io/README 2.12), of LAS and LAZ
// files.
//
// All that it claims is checked against the size of the file before anything is allocated.
#pragma once

#include "core/base/vec.h"
#include "core/io/file_bytes.h"
#include "core/io/las/las_fields.h"

namespace io {

/// A record of variable length, the coordinate system among them.
struct LasRecord {
    std::string user;
    unsigned id = 0;
    std::string_view whole; ///< with its head of 54 bytes
    std::string_view data;
};

constexpr std::size_t lasRecordHead = 54;

struct LasHeader {
    unsigned minor = 2;
    unsigned encoding = 0;   ///< global encoding; bit 0: GPS time is the adjusted standard one
    unsigned format = 0;     ///< of the points, below lasFormats
    bool compressed = false; ///< by LASzip
    std::size_t pointsAt = 0, stride = 0;
    std::uint64_t points = 0;
    base::Vec3d scale, offset;
    std::vector<LasRecord> records;

    const LasRecord* find(std::string_view user, unsigned id) const;
};

/// Throws base::Error where it is none, or makes no sense. The views are into the file.
LasHeader parseLasHeader(const FileBytes& file);

/// The fields that the record "Extra Bytes" describes, behind the first `size` bytes of a point; bytes that it leaves
/// undescribed have none, nor do whole numbers of 64 bits; `leftOut` gets the names of these.
std::vector<LasField> extraFields(const LasHeader& header, std::size_t size,
                                  std::vector<std::string>* leftOut = nullptr);

} // namespace io
