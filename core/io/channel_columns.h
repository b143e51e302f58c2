// All that points carry, as columns of binary records of fixed size: what the writers of PLY and PCD have in common.
#pragma once

#include "core/base/progress.h"
#include "core/io/file_model.h"
#include "core/io/safe_file.h"

#include <functional>

namespace io {

struct ChannelColumn {
    std::string name;
    surfel::ScalarType type = surfel::ScalarType::Float32;
    std::size_t offset = 0; ///< in a record
    /// Puts the values of points [begin, end); `out` is the column in the first record.
    std::function<void(std::size_t begin, std::size_t end, char* out, std::size_t stride)> fill;
};

struct ChannelOptions {
    /// One column `rgb` of four bytes, blue first, or `rgba` where not all are opaque; else `red green blue alpha`.
    bool packedColour = false;
    /// `local_x local_y local_z` where the coordinates do not bring back the floats inside (io/README 2.3).
    bool locals = false;
};

/// x y z (doubles where there is an origin), nx ny nz, colours, support_radius, mask, local_x ..., then the further
/// attributes in their order and types. Refers to `model`, which must outlive it.
class ChannelColumns {
  public:
    ChannelColumns(const FileModel& model, const ChannelOptions& options);

    const std::vector<ChannelColumn>& columns() const { return m_columns; }
    std::size_t stride() const { return m_stride; }
    /// The records of all points, in parallel, with progress. Throws base::Error and base::Cancelled.
    void write(SafeFile& file, const base::Progress& progress) const;

  private:
    void addPositions();
    void addColours(bool packed);
    void addAttribute(const surfel::Attribute& attribute);
    template <class T, class Value>
    void add(const std::string& name, surfel::ScalarType type, const Value& value);

    const FileModel& m_model;
    std::vector<ChannelColumn> m_columns;
    std::size_t m_stride = 0;
};

} // namespace io
