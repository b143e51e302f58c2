// A binary PLY of 27 bytes a point, as scanners' own programs write, to points in memory (BUDGETS P12).
#include "app/bench/workload.h"
#include "core/base/error.h"
#include "core/io/formats.h"

#include <cstring>
#include <fstream>
#include <unistd.h>

namespace bench {

namespace {

constexpr std::size_t bytesPerPoint = 27;

/// A file that goes away with its last user.
class ScanFile {
  public:
    explicit ScanFile(Scene& scene) : m_path(freshPath()) {
        std::ofstream out(m_path, std::ios::binary);
        out << "ply\nformat binary_little_endian 1.0\nelement vertex " << scene.size()
            << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
               "property float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
        m_header = static_cast<std::size_t>(out.tellp());
        for (const surfel::Surfel& s : scene.unsorted().items) {
            out.write(reinterpret_cast<const char*>(&s.position), 12);
            out.write(reinterpret_cast<const char*>(&s.normal), 12);
            out.write(reinterpret_cast<const char*>(&s.colour), 3);
        }
        out.close();
        if (!out)
            throw base::Error("cannot be written", m_path.string(), "free some space there or set TMPDIR");
    }
    ~ScanFile() {
        std::error_code ignored;
        std::filesystem::remove(m_path, ignored);
    }
    ScanFile(const ScanFile&) = delete;
    ScanFile& operator=(const ScanFile&) = delete;
    const std::filesystem::path& path() const { return m_path; }
    std::size_t header() const { return m_header; }

  private:
    static std::filesystem::path freshPath() {
        static int count = 0;
        const std::string name = "pointclay-bench-" + std::to_string(::getpid()) + "-" + std::to_string(count++);
        return std::filesystem::temp_directory_path() / (name + ".ply");
    }
    std::filesystem::path m_path;
    std::size_t m_header = 0;
};

Run loading(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene)] {
        const io::FileModel model = io::read(file->path());
        keep(model);
        return model.points.size();
    };
}

/// The least that any loader must do: the bytes from the file into arrays.
Run naiveLoading(Scene& scene) {
    return [file = std::make_shared<ScanFile>(scene), points = scene.size()] {
        std::ifstream in(file->path(), std::ios::binary);
        in.seekg(static_cast<std::streamoff>(file->header()));
        std::vector<char> bytes(points * bytesPerPoint);
        in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        std::vector<base::Vec3f> positions(points), normals(points);
        std::vector<surfel::Colour> colours(points);
        const char* at = bytes.data();
        for (std::size_t i = 0; i < points; ++i, at += bytesPerPoint) {
            std::memcpy(&positions[i], at, 12);
            std::memcpy(&normals[i], at + 12, 12);
            unsigned char rgb[3];
            std::memcpy(rgb, at + 24, 3);
            colours[i] = surfel::rgba(rgb[0], rgb[1], rgb[2]);
        }
        keep(positions);
        keep(normals);
        keep(colours);
        return points;
    };
}

} // namespace

std::vector<Workload> fileWorkloads() {
    return {{"load-ply", "point", "a binary PLY of 27 bytes a point, read and checked",
             "a loop copying the bytes into arrays", loading, naiveLoading}};
}

} // namespace bench
