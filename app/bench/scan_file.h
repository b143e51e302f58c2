// A scene's points as a file of 27 bytes each, as scanners' own programs write, or of 15 without normals.
#pragma once

#include "app/bench/naive/naive_file.h"
#include "app/bench/scene.h"

namespace bench {

/// In the folder for temporary files; goes away with its last user.
class ScanFile {
  public:
    enum class Normals { With, Without };
    /// Throws base::Error where it cannot be written.
    explicit ScanFile(Scene& scene, Normals normals = Normals::With);
    ~ScanFile();
    ScanFile(const ScanFile&) = delete;
    ScanFile& operator=(const ScanFile&) = delete;
    const PointFile& operator*() const { return m_file; }
    const PointFile* operator->() const { return &m_file; }

  private:
    PointFile m_file;
};

} // namespace bench
