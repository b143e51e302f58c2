// PTX of Leica's Cyclone: scans of a grid each, one behind the other, in their scanner's coordinates (io/README 2.18).
#include "core/io/number_text.h"
#include "core/io/readers.h"
#include "core/io/scene/scene_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace io {

namespace {

const char* const damaged = "the file is damaged or was cut off; fetch it again";

/// Lines with something in them, one after the other.
class Lines {
  public:
    explicit Lines(const FileBytes& file) : m_file(file) { skip(); }
    bool atEnd() const { return m_at >= m_file.size(); }
    std::size_t left() const { return m_file.size() - m_at; }
    double done() const { return static_cast<double>(m_at) / static_cast<double>(m_file.size()); }

    /// The numbers of the next line, no more than `most`; fails for fewer than `least`.
    std::size_t numbers(double* out, std::size_t least, std::size_t most) {
        const std::string_view bytes = m_file.bytes();
        const std::size_t begin = m_at, end = std::min(bytes.find_first_of("\r\n", m_at), bytes.size());
        const char* next = bytes.data() + begin;
        std::size_t found = 0;
        while (found < most) {
            while (next < bytes.data() + end && (*next == ' ' || *next == '\t'))
                ++next;
            const char* const after = parseNumber(next, bytes.data() + end, out[found]);
            if (!after)
                break;
            next = after;
            ++found;
        }
        if (found < least)
            m_file.failAt(begin, "needs " + std::to_string(least) + " numbers", damaged);
        m_at = end;
        skip();
        return found;
    }
    /// A line with a whole number.
    std::size_t count() {
        const std::size_t begin = m_at;
        double value = 0;
        numbers(&value, 1, 1);
        if (!(value >= 1 && value <= 1e9) || value != std::floor(value))
            m_file.failAt(begin, "is no number of rows or columns", damaged);
        return static_cast<std::size_t>(value);
    }

  private:
    void skip() { m_at = std::min(m_file.bytes().find_first_not_of(" \t\r\n", m_at), m_file.size()); }

    const FileBytes& m_file;
    std::size_t m_at = 0;
};

/// Quaternion w x y z of a rotation, by its largest part.
std::array<double, 4> quaternionOf(const base::Mat3d& m) {
    const double squares[4] = {1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
                               1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]};
    const auto largest = static_cast<std::size_t>(std::max_element(squares, squares + 4) - squares);
    const double a = m[2][1] - m[1][2], b = m[0][2] - m[2][0], c = m[1][0] - m[0][1];
    const double xy = m[0][1] + m[1][0], zx = m[0][2] + m[2][0], yz = m[1][2] + m[2][1];
    const double s = squares[largest];
    const std::array<double, 4> rows[4] = {{s, a, b, c}, {a, s, xy, zx}, {b, xy, s, yz}, {c, zx, yz, s}};
    std::array<double, 4> out = rows[largest];
    double norm = 0;
    for (const double each : out)
        norm += each * each;
    for (double& each : out)
        each /= std::sqrt(norm);
    return out;
}

class PtxReader {
  public:
    PtxReader(const FileBytes& file, const base::Progress& progress)
        : m_file(file), m_progress(progress), m_lines(file), m_points(file, file.size()) {}
    FileModel read();

  private:
    void readScan();
    Placement readPose();

    const FileBytes& m_file;
    const base::Progress& m_progress;
    Lines m_lines;
    ScenePoints m_points;
    FileModel m_model;
    std::size_t m_scans = 0, m_empty = 0;
};

/// The scanner's place and axes, which the matrix repeats, then the matrix that rows of coordinates go through.
Placement PtxReader::readPose() {
    double numbers[4];
    for (int i = 0; i < 4; ++i)
        m_lines.numbers(numbers, 3, 3);
    Placement out;
    for (int i = 0; i < 4; ++i) {
        m_lines.numbers(numbers, 4, 4);
        for (int k = 0; k < 3; ++k)
            (i < 3 ? out.linear[k][i] : out.shift[static_cast<std::size_t>(k)]) = numbers[k];
    }
    return out;
}

void PtxReader::readScan() {
    const std::size_t columns = m_lines.count(), rows = m_lines.count();
    const Placement pose = readPose();
    const std::size_t first = m_points.size();
    std::vector<double> values[3]; // intensity, row, column
    bool coloured = false;
    for (std::size_t i = 0; i < columns * rows; ++i) { // ends with the file at the latest
        if (i % 65536 == 0)
            m_progress.step(0.5 * m_lines.done(), "Reading");
        if (m_lines.atEnd())
            m_file.fail("a scan promises " + std::to_string(columns * rows) + " points, but holds " + std::to_string(i),
                        damaged);
        double n[7] = {0, 0, 0, 0, 255, 255, 255};
        const std::size_t found = m_lines.numbers(n, 3, 7);
        if (n[0] == 0 && n[1] == 0 && n[2] == 0) {
            ++m_empty;
            continue;
        }
        ScenePoint point{pose({n[0], n[1], n[2]}), {}, surfel::white};
        for (unsigned k = 0; found == 7 && k < 3; ++k) {
            const auto byte =
                static_cast<surfel::Colour>(std::isfinite(n[4 + k]) ? std::clamp(n[4 + k], 0.0, 255.0) : 0);
            point.colour = (point.colour & ~(255u << 8 * k)) | byte << 8 * k;
        }
        coloured |= found == 7;
        m_points.announce(1);
        m_points.add(point);
        values[0].push_back(n[3]);
        values[1].push_back(static_cast<double>(i % rows));
        values[2].push_back(static_cast<double>(i / rows));
    }
    if (coloured)
        m_points.tellsColours();
    m_points.set("intensity", ScalarType::Float32, first, values[0]);
    m_points.set("row", ScalarType::Int32, first, values[1]);
    m_points.set("column", ScalarType::Int32, first, values[2]);
    m_points.set("scan", ScalarType::Int32, first,
                 std::vector<double>(m_points.size() - first, static_cast<double>(m_scans)));
    std::string comment = "scan " + std::to_string(m_scans++) + " viewpoint";
    for (std::size_t k = 0; k < 3; ++k)
        appendNumber(comment += ' ', pose.shift[k]);
    for (const double each : quaternionOf(pose.linear))
        appendNumber(comment += ' ', each);
    m_model.comments.push_back(comment);
}

FileModel PtxReader::read() {
    while (!m_lines.atEnd())
        readScan();
    if (m_points.size() == 0)
        m_file.fail("holds no points", "choose a file with scans");
    m_model.format = "ptx";
    if (m_empty > 0)
        m_model.messages.push_back(std::to_string(m_empty) + " places of the grids saw nothing and were left out.");
    if (m_scans > 1)
        m_model.messages.push_back("The " + std::to_string(m_scans) +
                                   " scans were put together at their poses; the attribute 'scan' tells them apart.");
    m_points.finish(m_model, {m_progress, 0.5, 1});
    return std::move(m_model);
}

} // namespace

FileModel readPtx(const FileBytes& file, const base::Progress& progress, const path&) {
    progress.step(0, "Reading");
    return PtxReader(file, progress).read();
}

} // namespace io
