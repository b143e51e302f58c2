// From LAS records to points: what the readers of LAS and LAZ have in common once the records lie side by side.
#pragma once

#include "core/io/las/las_header.h"
#include "core/io/record_points.h"

namespace io {

/// The element in which the records of variable length (coordinate systems) come along and are written back.
constexpr std::string_view lasRecordsElement = "las_records";
/// A comment with the grid of whole numbers on which the coordinates lie, so that they are written back on the same:
/// "las scale X Y Z offset X Y Z encoding N".
constexpr std::string_view lasGridComment = "las scale ";

/// Fields that are zero in all points tell nothing and are left out, and so are colours that are all black. The records
/// must stay until this returns.
FileModel lasPoints(const FileBytes& file, const LasHeader& header, RecordTable& table, const ProgressSpan& progress);

/// Which records are looked at before an origin is chosen.
std::vector<std::uint64_t> lasSamplePlaces(std::uint64_t count);
/// By those and the grid: where the usual choice sees no need for an origin, but floats would leave the grid, the
/// middle gets one.
base::Vec3d lasOrigin(const base::Vec3d& scale, std::span<const base::Vec3d> sample, std::uint64_t count);

/// The same for a file that LASzip has compressed. Throws base::Error and base::Cancelled.
FileModel readLaz(const FileBytes& file, const LasHeader& header, const base::Progress& progress);

} // namespace io
