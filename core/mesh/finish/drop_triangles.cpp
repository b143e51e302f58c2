#include "core/mesh/finish/drop_triangles.h"

#include <span>

namespace mesh {

namespace {

constexpr std::uint32_t none = ~0u;

/// Of `each` values per vertex.
template <class T>
void keepOnly(std::vector<T>& values, std::span<const std::uint32_t> numbers, std::size_t each = 1) {
    if (values.empty())
        return;
    std::size_t count = 0;
    for (std::size_t i = 0; i < numbers.size() * each; ++i)
        if (numbers[i / each] != none)
            values[count++] = values[i];
    values.resize(count);
}

} // namespace

std::size_t keepTriangles(Mesh& mesh, const std::function<bool(std::size_t)>& keep) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (keep(t))
            mesh.triangles[kept++] = mesh.triangles[t];
    const std::size_t out = mesh.triangles.size() - kept;
    mesh.triangles.resize(kept);
    return out;
}

void dropUnused(Mesh& mesh) {
    std::vector<std::uint32_t> numbers(mesh.positions.size(), none);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t)
            numbers[v] = 0;
    std::uint32_t next = 0;
    for (std::uint32_t& number : numbers)
        if (number != none)
            number = next++;
    keepOnly(mesh.positions, numbers);
    keepOnly(mesh.normals, numbers);
    keepOnly(mesh.colours, numbers);
    keepOnly(mesh.masks, numbers);
    keepOnly(mesh.kinds, numbers);
    keepOnly(mesh.extra, numbers, mesh.layout->words());
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t)
            v = numbers[v];
}

void dropSmallPieces(Mesh& mesh, const Orientation& pieces, std::size_t least) {
    keepTriangles(mesh, [&](std::size_t t) { return pieces.pieceSizes[pieces.pieceOf[t]] >= least; });
    dropUnused(mesh);
}

} // namespace mesh
