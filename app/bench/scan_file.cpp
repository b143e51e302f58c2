#include "app/bench/scan_file.h"

#include "core/base/error.h"

#include <fstream>
#include <unistd.h>

namespace bench {

static std::filesystem::path freshPath() {
    static int count = 0;
    const std::string name = "pointclay-bench-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
    return std::filesystem::temp_directory_path() / (name + ".ply");
}

ScanFile::ScanFile(Scene& scene, Normals normals) : m_file{freshPath(), 0, scene.size(), normals == Normals::With} {
    std::ofstream out(m_file.path, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << scene.size()
        << "\nproperty float x\nproperty float y\nproperty float z\n"
        << (m_file.normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "")
        << "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
    m_file.header = static_cast<std::size_t>(out.tellp());
    for (const surfel::Surfel& s : scene.unsorted().items) {
        out.write(reinterpret_cast<const char*>(&s.position), 12);
        if (m_file.normals)
            out.write(reinterpret_cast<const char*>(&s.normal), 12);
        out.write(reinterpret_cast<const char*>(&s.colour), 3);
    }
    out.close();
    if (!out)
        throw base::Error("cannot be written", m_file.path.string(), "free some space there or set TMPDIR");
}

ScanFile::~ScanFile() {
    std::error_code ignored;
    std::filesystem::remove(m_file.path, ignored);
}

} // namespace bench
