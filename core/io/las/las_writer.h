// A model as LAS records: the point format, the grid of whole numbers and the columns are chosen once, then each point
// fills a record. What the writers of LAS and LAZ have in common; internal to the room.
#pragma once

#include "core/io/file_model.h"
#include "core/io/las/las_fields.h"

#include <functional>

namespace io {

/// A field that a channel or an attribute of the model fills.
struct LasColumn {
    LasField field;
    std::function<double(std::size_t i)> value;
};

/// Refers to the model, which must outlive it. Any number of threads may fill records. Throws base::Error where whole
/// numbers of 32 bits cannot hold the coordinates.
class LasRecords {
  public:
    explicit LasRecords(const FileModel& model);
    LasRecords(const LasRecords&) = delete;
    LasRecords& operator=(const LasRecords&) = delete;

    unsigned format() const { return m_format; }
    std::size_t stride() const { return m_stride; }
    const LasLayout& layout() const { return m_layout; }
    void fill(std::size_t i, char* out) const;
    /// The public header and the records of variable length, `further` (so many) the last of them.
    std::string header(std::string_view further, std::size_t furtherCount, bool compressed) const;

  private:
    unsigned chooseFormat() const;
    bool takeGrid();
    bool fitsGrid() const;
    void chooseGrid();
    void chooseColumns();
    void addExtra(const std::string& name, ScalarType type, std::function<double(std::size_t)> value);
    unsigned channelOf(std::size_t i, unsigned k) const;

    const FileModel& m_model;
    unsigned m_format = 0, m_encoding = 0;
    LasLayout m_layout;
    std::size_t m_stride = 0;
    base::Vec3d m_scale, m_offset, m_low, m_high;
    std::vector<LasColumn> m_columns;
    std::string m_description; ///< of the extra bytes
    const surfel::Attribute* m_wide[3] = {};
};

} // namespace io
