#include "core/session/scene/pose_file.h"

#include "core/base/error.h"
#include "core/io/file_bytes.h"
#include "core/io/number_text.h"
#include "core/session/path_text.h"

#include <cmath>
#include <optional>
#include <string_view>

namespace session {

namespace fs = std::filesystem;

static constexpr const char* advice = "a line is bmesh FILE tx ty tz qx qy qz qw";

bool isPoseFile(const fs::path& path) {
    return path.extension() == ".conf" || path.extension() == ".CONF";
}

/// Words between blanks.
static std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t begin = line.find_first_not_of(" \t\r", at);
        if (begin == std::string_view::npos)
            break;
        at = std::min(line.find_first_of(" \t\r", begin), line.size());
        out.push_back(line.substr(begin, at - begin));
    }
    return out;
}

static base::Mat3d rotationOf(double x, double y, double z, double w) {
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
             {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
             {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

static std::optional<process::Rigid> poseOf(const std::vector<std::string_view>& words) {
    double v[7] = {};
    for (std::size_t k = 0; k < 7; ++k) {
        const auto number = io::numberOf(words[k + 2]);
        if (!number || !std::isfinite(*number))
            return {};
        v[k] = *number;
    }
    const double size = std::sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5] + v[6] * v[6]);
    if (!(size > 0) || !std::isfinite(size))
        return {};
    return process::Rigid{transposed(rotationOf(v[3] / size, v[4] / size, v[5] / size, v[6] / size)),
                          {v[0], v[1], v[2]}};
}

std::vector<PosedFile> posesIn(const fs::path& file) {
    const io::FileBytes bytes(file);
    std::vector<PosedFile> out;
    std::string_view rest = bytes.bytes();
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::vector<std::string_view> words = wordsOf(rest.substr(0, end));
        const bool posed = !words.empty() && (words[0] == "bmesh" || words[0] == "mesh");
        const std::optional<process::Rigid> pose = posed && words.size() == 9 ? poseOf(words) : std::nullopt;
        if (posed && !pose)
            bytes.failAt(static_cast<std::size_t>(rest.data() - bytes.bytes().data()), "this is no pose", advice);
        if (pose)
            out.push_back({file.parent_path() / pathOf(std::string(words[1])), *pose});
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (out.empty())
        throw base::Error("holds no poses of scans", file.string(), advice);
    return out;
}

} // namespace session
