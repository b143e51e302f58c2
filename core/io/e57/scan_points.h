// The points of an E57 file's scans as records side by side: spherical coordinates become cartesian ones, poses are
// applied, and fields under names of their own get those that attributes have here (io/README 2.14).
#pragma once

#include "core/io/e57/e57_scans.h"
#include "core/io/e57/paged_bytes.h"
#include "core/io/growing_bytes.h"
#include "core/io/record_points.h"

namespace io::e57 {

class ScanPoints {
  public:
    /// Chooses the columns that all scans need together.
    ScanPoints(const FileBytes& file, const PagedBytes& pages, const std::vector<Scan>& scans);
    ScanPoints(const ScanPoints&) = delete;
    ScanPoints& operator=(const ScanPoints&) = delete;

    /// Reads the points of one scan behind those that are there. Memory grows with what the bytes tell, not with the
    /// count that they claim.
    void read(std::size_t scan, const ProgressSpan& progress);
    /// The records; they are the object's.
    RecordTable table();

  private:
    struct Column {
        const char* name;  ///< of the field in a scan
        std::string given; ///< here
        ScalarType type;
        std::size_t offset;
        bool isGeneral; ///< copied as it is
    };
    void add(const char* name, const std::string& given, ScalarType type, bool isGeneral);
    void addGeneral(const PackedField& field);
    void fill(const Scan& scan, std::size_t number, const std::vector<PackedStream>& streams, std::uint64_t count);

    const FileBytes& m_file;
    const PagedBytes& m_pages;
    const std::vector<Scan>& m_scans;
    std::vector<Column> m_columns;
    std::vector<std::string> m_names; ///< those that columns point to
    bool m_normals = false, m_colours = false;
    bool m_wide = false; ///< some scan has colours of more than 8 bits
    std::size_t m_stride = 0, m_count = 0;
    GrowingBytes m_records;
};

} // namespace io::e57
