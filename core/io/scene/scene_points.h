// The points of files that are scenes: meshes and clouds placed many times, each by a transform. What the readers of
// such formats fill while they walk through one, and what makePoints() takes then.
#pragma once

#include "core/base/mat3.h"
#include "core/io/file_bytes.h"
#include "core/io/file_model.h"
#include "core/io/record_points.h"

#include <map>

namespace io {

/// An affine map: x -> linear x + shift.
struct Placement {
    base::Mat3d linear = base::Mat3d::identity();
    base::Vec3d shift;

    base::Vec3d operator()(const base::Vec3d& x) const { return linear * x + shift; }
    /// First `o`, then this.
    Placement operator*(const Placement& o) const { return {linear * o.linear, (*this)(o.shift)}; }
    bool onlyShifts() const {
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                if (linear[r][c] != (r == c ? 1 : 0))
                    return false;
        return true;
    }
    bool mirrors() const { return base::determinant(linear) < 0; }
};

struct ScenePoint {
    base::Vec3d position;
    base::Vec3f normal;
    surfel::Colour colour = surfel::white;
};

class ScenePoints {
  public:
    /// `bytes`: of the file and all that it names.
    ScenePoints(const FileBytes& file, std::size_t bytes) : m_file(file), m_bytes(bytes) {}
    ScenePoints(const ScenePoints&) = delete;
    ScenePoints& operator=(const ScenePoints&) = delete;

    /// Counts `more` points, or values of columns. A scene can name one mesh without end: throws base::Error for more
    /// than 32 points for each byte of the file, none of which stood for so many of an honest one.
    void announce(std::size_t more);
    std::uint32_t size() const { return static_cast<std::uint32_t>(m_points.size()); }
    void add(const ScenePoint& point) { m_points.push_back(point); }
    ScenePoint& operator[](std::size_t i) { return m_points[i]; }

    void tellsNormals() { m_normals = true; }
    void tellsColours() { m_colours = true; }
    /// Values of a further column for the points from `first` on; 0 for those that bring none.
    void set(const std::string& column, ScalarType type, std::size_t first, const std::vector<double>& values);

    /// Moves all into the model, whose polygons count them.
    void finish(FileModel& model, const ProgressSpan& progress);

  private:
    struct Column {
        ScalarType type;
        std::vector<double> values;
    };
    const FileBytes& m_file;
    std::vector<ScenePoint> m_points;
    std::map<std::string, Column> m_columns;
    bool m_normals = false, m_colours = false;
    std::size_t m_bytes, m_announced = 0;
};

} // namespace io
