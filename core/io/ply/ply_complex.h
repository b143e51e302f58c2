// How the cells of a complex hang together, as two elements of a PLY file beside its points (complexes/README 4):
//
//     element complex_cell       dimension, list boundary            numbers of cells, in the order of the records
//     element complex_tangent    at, list cells, x y z, nx ny nz     prescribed tangents, in file coordinates
#pragma once

#include "core/io/ply/ply_header.h"
#include "core/surface/connectivity.h"

#include <string_view>

namespace io {

bool isOfComplex(const PlyElement& element);

class PlyComplex {
  public:
    /// Adds what an element tells. `body`: in little-endian binary, its extent having been checked.
    void take(const FileBytes& file, const PlyElement& element, std::string_view body);
    bool any() const { return !m_connectivity.cells.empty(); }
    /// Throws base::Error in the file's name where the cells break a rule.
    surface::Connectivity made(const FileBytes& file, const base::Vec3d& origin) const;

  private:
    surface::Connectivity m_connectivity;
    std::vector<base::Vec3d> m_positions; ///< of tangents
};

/// Header lines and records; nothing for null.
std::string complexDeclaration(const surface::Connectivity* connectivity);
std::string complexBody(const surface::Connectivity* connectivity, const base::Vec3d& origin);

} // namespace io
