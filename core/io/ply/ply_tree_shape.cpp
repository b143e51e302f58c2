#include "core/io/ply/ply_tree_shape.h"

#include "core/io/ply/ply_records.h"

namespace io {

static const PlyElement& declared() {
    static const PlyElement element{"pointclay_tree",
                                    1,
                                    {{"blocks", ScalarType::UInt8, true, ScalarType::UInt32},
                                     {"nodes", ScalarType::UInt8, true, ScalarType::UInt32},
                                     {"check", ScalarType::UInt32, true, ScalarType::UInt8}}};
    return element;
}

bool isTreeShape(const PlyElement& element) {
    return element.name == declared().name;
}

tree::TreeShape treeShapeOf(const FileBytes& file, const PlyElement& element, std::string_view body) {
    if (element.declaration() != declared().declaration())
        return {};
    std::vector<std::string_view> lists;
    RecordWalker(file, body, element, false).pass(0, [&](const PlyProperty& p, std::size_t at, std::size_t items) {
        lists.push_back(body.substr(at + sizeOf(p.countType), items * sizeOf(p.type)));
    });
    std::uint64_t check[2];
    if (lists[2].size() != sizeof check)
        return {};
    std::memcpy(check, lists[2].data(), sizeof check);
    tree::TreeShape out;
    out.blocks.assign(lists[0].begin(), lists[0].end());
    out.nodes.assign(lists[1].begin(), lists[1].end());
    out.check = {check[0], check[1]};
    return out;
}

std::string treeShapeDeclaration(const tree::TreeShape& shape) {
    return shape.empty() ? std::string() : declared().declaration();
}

/// Lengths are counted in 32 bits: so many blocks hold half a million million surfels.
static void appendList(std::string& out, const std::vector<std::uint8_t>& values) {
    const auto count = static_cast<std::uint32_t>(values.size());
    out.append(reinterpret_cast<const char*>(&count), sizeof count);
    out.append(values.begin(), values.end());
}

std::string treeShapeBody(const tree::TreeShape& shape) {
    std::string out;
    if (shape.empty())
        return out;
    appendList(out, shape.blocks);
    appendList(out, shape.nodes);
    const std::uint64_t check[2] = {shape.check.lo, shape.check.hi};
    out += '\4'; // numbers of 32 bits
    out.append(reinterpret_cast<const char*>(check), sizeof check);
    return out;
}

} // namespace io
