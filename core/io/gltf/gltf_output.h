// Lists of numbers as a glTF 2.0 file with one buffer, whether they are the points of a cloud or of a mesh: what both
// writers have in common.
#pragma once

#include "core/base/progress.h"
#include "core/base/vec.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace io::gltf {

/// What a list's numbers are, as glTF counts them.
enum class Component { Int8 = 5120, UInt8 = 5121, Int16 = 5122, UInt16 = 5123, UInt32 = 5125, Float32 = 5126 };

struct OutputList {
    std::string name; ///< "POSITION"; "" for the corners of triangles
    Component component = Component::Float32;
    const char* type = "VEC3";
    std::size_t stride = 12; ///< bytes from one to the next; a multiple of 4
    std::size_t count = 0;
    std::function<void(std::size_t i, char* out)> put = {}; ///< called from many threads
    bool normalised = false;
    std::vector<double> least = {}, most = {}; ///< of positions, which have to tell
};

/// Triangles where a list without a name is among them, else points. They stand at `origin`. As text with the buffer in
/// base 64 where the name ends in .gltf. Throws base::Error where that has more than 4 GiB; base::Cancelled.
void writeLists(const std::filesystem::path& target, std::vector<OutputList> lists, const base::Vec3d& origin,
                const base::Progress& progress);

/// The list of positions with what it has to tell.
OutputList positionList(std::size_t count, const std::function<base::Vec3f(std::size_t)>& position);
OutputList normalList(std::size_t count, const std::function<base::Vec3f(std::size_t)>& normal);
/// Colours as glTF has them: linear, in 16 bits, which bring back the 8 bits of sRGB.
OutputList colourList(std::size_t count, const std::function<std::uint32_t(std::size_t)>& colour);

} // namespace io::gltf
