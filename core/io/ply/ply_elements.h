// Elements of a PLY body as bytes: how far they reach, their scalars as a table, and the whole of them for writing
// back.
//
// Every size is checked against the bytes that are there before anything is allocated or passed over. Errors are
// base::Error with the file's name and the place.
#pragma once

#include "core/io/ply/ply_header.h"
#include "core/io/record_table.h"
#include "core/io/text/text_rows.h"

namespace io {

/// Bytes from `offset` that the element takes in a binary body of the file.
std::size_t binaryExtent(const FileBytes& file, const PlyElement& element, std::size_t offset, bool bigEndian);

/// The scalars of a binary element whose extent has been checked: in place, or packed where lists lie between them.
RecordTable binaryTable(const FileBytes& file, const PlyElement& element, std::size_t offset, bool bigEndian);

/// The element's records in little-endian binary, its extent having been checked.
std::string littleEndianBody(const FileBytes& file, const PlyElement& element, std::size_t offset, std::size_t extent,
                             bool bigEndian);

/// The scalars of an ascii element that is written in the rows from `firstRow` on. REQUIRES: so many rows are there.
RecordTable asciiTable(const FileBytes& file, const TextRows& rows, std::size_t firstRow, const PlyElement& element,
                       const ProgressSpan& progress);

/// The same rows, lists and all, in little-endian binary.
std::string littleEndianBody(const FileBytes& file, const TextRows& rows, std::size_t firstRow,
                             const PlyElement& element);

} // namespace io
