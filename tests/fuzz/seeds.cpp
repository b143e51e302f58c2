#include "fuzz/seeds.h"

#include "core/base/random.h"
#include "core/io/e57/paged_bytes.h"
#include "core/io/formats.h"
#include "core/io/pictures/colour_png.h"
#include "core/session/command.h"
#include "core/session/scene/scene_ply.h"
#include "fuzz/fuzzed.h"
#include "support/crc32.h"
#include "support/gzip.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
// after <cstdio>, which it needs
#include <jpeglib.h>

namespace fs = std::filesystem;

static void put(const fs::path& file, std::string_view content) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

/// A few surfels with all that a native file can hold.
static io::FileModel fullModel() {
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = layout->colours = layout->masks = true;
    layout->add("label", surfel::ScalarType::UInt8);
    layout->add("time", surfel::ScalarType::Float64);
    model.points.layout = layout;
    model.hasSupports = true;
    model.origin = {500000, 4.5e6, 0};
    model.definition = surface::SurfaceDefinition();
    model.elements.push_back(
        {"element other 2\nproperty list uchar int ids\nproperty short s\n", std::string("\1\0\0\0\7\1\1\0\2\2", 10)});
    base::Random random(1);
    for (int i = 0; i < 6; ++i) {
        surfel::Surfel s;
        s.position = base::cast<float>(random.unitVector());
        s.normal = s.position;
        s.support = 0.5f;
        s.mask = 0.25f;
        const std::uint32_t words[] = {7, 0, 0x40000000u};
        model.points.append(s, words);
    }
    return model;
}

/// Points with a scanner channel, and so of a format that LASzip keeps in layers.
static io::FileModel lidarModel() {
    io::FileModel model;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->colours = true;
    for (const char* name : {"return_number", "number_of_returns", "scanner_channel"})
        layout->add(name, surfel::ScalarType::UInt8);
    layout->add("gps_time", surfel::ScalarType::Float64);
    model.points.layout = layout;
    base::Random random(2);
    for (std::uint32_t i = 0; i < 20; ++i) {
        surfel::Surfel s;
        s.position = base::cast<float>(random.unitVector());
        s.colour = surfel::rgba(i, 7, 2 * i);
        const std::uint32_t words[] = {1 + i % 2, 2, i / 4 % 3, i / 3, 0x40000000u};
        model.points.append(s, words);
    }
    return model;
}

/// Three points of 10, 10 and 4 bits a coordinate on pages of 64 bytes, with their checksums.
static std::string packedE57() {
    const std::string xml = "<e57Root><data3D><vectorChild><points type=\"CompressedVector\" fileOffset=\"48\" "
                            "recordCount=\"3\"><prototype>"
                            "<cartesianX type=\"Integer\" minimum=\"0\" maximum=\"1023\"/>"
                            "<cartesianY type=\"ScaledInteger\" minimum=\"0\" maximum=\"1023\" scale=\"0.1\"/>"
                            "<cartesianZ type=\"Integer\" minimum=\"-3\" "
                            "maximum=\"12\"/></prototype></points></vectorChild></data3D></e57Root>";
    const auto number = [](std::uint64_t value, int size) {
        return std::string(reinterpret_cast<const char*>(&value), static_cast<std::size_t>(size));
    };
    const auto physical = [](std::uint64_t logical) { return logical / 60 * 64 + logical % 60; };
    const std::string packet = std::string("\1\0\x17\0\3\0\4\0\4\0\2\0", 12) + "abcdefghij" + std::string(2, '\0');
    std::string body = std::string("\1\0\0\0\0\0\0\0", 8) + number(32 + packet.size(), 8) + number(physical(80), 8) +
                       number(0, 8) + packet + xml;
    std::string out = "ASTM-E57" + number(1, 4) + number(0, 4) + number(0, 8) +
                      number(physical(80 + packet.size()), 8) + number(xml.size(), 8) + number(64, 8) + body,
                paged;
    out.resize((out.size() + 59) / 60 * 60);
    for (std::size_t at = 0; at < out.size(); at += 60) {
        const std::string page = out.substr(at, 60);
        const std::uint32_t sum = io::e57::checksum(page);
        paged += page;
        for (int shift = 24; shift >= 0; shift -= 8)
            paged += static_cast<char>(sum >> shift);
    }
    return paged;
}

/// An archive whose entries stand in it as they are, so that mutations meet what is inside.
static std::string storedZip(const std::vector<std::pair<std::string, std::string>>& entries) {
    const auto number = [](std::size_t value, int size) {
        return std::string(reinterpret_cast<const char*>(&value), static_cast<std::size_t>(size));
    };
    std::string out, directory;
    for (const auto& [name, content] : entries) {
        const std::string common = number(20, 2) + number(0, 2) + number(0, 2) + number(0, 4) +
                                   number(test::crc32(content), 4) + number(content.size(), 4) +
                                   number(content.size(), 4) + number(name.size(), 2) + number(0, 2);
        directory += "PK\1\2" + number(20, 2) + common + number(0, 6) + number(0, 4) + number(out.size(), 4) + name;
        out += "PK\3\4" + common + name + content;
    }
    const std::size_t at = out.size();
    return out + directory + "PK\5\6" + number(0, 4) + number(entries.size(), 2) + number(entries.size(), 2) +
           number(directory.size(), 4) + number(at, 4) + number(0, 2);
}

/// Two triangles, placed twice, with colours and places in a picture.
static std::string package() {
    const std::string model =
        R"(<model unit="inch"><resources><m:colorgroup id="5"><m:color color="#FF0000"/><m:color color="#00FF0080"/></m:colorgroup>)"
        R"(<m:texture2d id="6" path="/p.png" contenttype="image/png"/><m:texture2dgroup id="7" texid="6"><m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0.5"/></m:texture2dgroup>)"
        R"(<object id="1" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="2"/><vertex x="1" y="1" z="0"/></vertices>)"
        R"(<triangles><triangle v1="0" v2="1" v3="2" pid="5" p1="0" p2="1" p3="1"/><triangle v1="1" v2="3" v3="2" pid="7" p1="0" p2="1" p3="0"/></triangles></mesh></object>)"
        R"(<object id="2"><components><component objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 5"/><component objectid="1"/></components></object></resources>)"
        R"(<build><item objectid="2"/><item objectid="1" p:path="/3D/3dmodel.model"/></build></model>)";
    const std::string relations =
        R"(<Relationships><Relationship Type="a/3dmodel" Target="/3D/3dmodel.model"/></Relationships>)";
    const std::uint32_t pixels[] = {0xff0000ffu, 0xff00ff00u};
    return storedZip(
        {{"_rels/.rels", relations}, {"p.png", io::encodePng(pixels, 2, 1, "p.png")}, {"3D/3dmodel.model", model}});
}

/// A triangle and a strip of nodes with every way of placing them.
static std::string sceneText() {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,2]}],"nodes":[{"translation":[1,0,0],"scale":[2,-2,2],"children":[1]},)"
           R"({"mesh":0,"rotation":[0,0,0.6,0.8]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}],"meshes":[{"primitives":[{"attributes":)"
           R"({"POSITION":0,"TEXCOORD_0":0,"_ROUGH":0},"indices":1,"material":0},{"mode":5,"attributes":{"POSITION":0,"NORMAL":0,"COLOR_0":0}}]}],)"
           R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"scale":[2,2],"rotation":1}}}}},)"
           R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1]}}],"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],"images":[{"uri":"p.png"}],)"
           R"("buffers":[{"byteLength":48,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAEAAAACAAAA"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36,"byteStride":12},{"buffer":0,"byteOffset":36,"byteLength":12}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}]})";
}

static std::string triangleStl() {
    std::string out(80, ' ');
    out += std::string("\2\0\0\0", 4);
    for (int t = 0; t < 2; ++t) {
        const float numbers[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, float(t)};
        out.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
        out.append(2, '\0');
    }
    return out;
}

static std::string bigEndianPly() {
    std::string out = "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty float x\nproperty double y\n"
                      "property float z\nproperty list uchar short l\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 2; ++i)
        out += std::string("\x3f\x80\0\0\x3f\xf0\0\0\0\0\0\0\x40\0\0\0\2\0\1\0\2", 21);
    return out + std::string("\3\0\0\0\0\0\0\0\1\0\0\0\1", 13);
}

/// 24 x 16 pixels.
static std::string jpeg(bool progressive, int components) {
    jpeg_compress_struct info{};
    jpeg_error_mgr errors{};
    info.err = jpeg_std_error(&errors);
    jpeg_create_compress(&info);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&info, &bytes, &size);
    info.image_width = 24, info.image_height = 16;
    info.input_components = components;
    info.in_color_space = components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&info);
    if (progressive)
        jpeg_simple_progression(&info);
    jpeg_start_compress(&info, TRUE);
    for (unsigned y = 0; y < 16; ++y) {
        unsigned char row[72];
        for (unsigned i = 0; i < 72; ++i)
            row[i] = static_cast<unsigned char>(7 * i + 11 * y);
        unsigned char* rows[] = {row};
        jpeg_write_scanlines(&info, rows, 1);
    }
    jpeg_finish_compress(&info);
    std::string out(reinterpret_cast<char*>(bytes), size);
    jpeg_destroy_compress(&info);
    std::free(bytes);
    return out;
}

/// All words that the table of commands knows.
static std::string words() {
    std::set<std::string> all{"samples", "1e999", "1e-300", "file://", "\\\\u0000"};
    for (const session::CommandRow& row : session::commandTable()) {
        all.insert(std::string("{\\\"op\\\":\\\"") + row.op + "\\\"");
        for (const session::CommandParameter& p : row.parameters) {
            all.insert(std::string("\\\"") + p.id + "\\\":");
            std::istringstream in(p.choices);
            for (std::string choice; in >> choice;)
                all.insert("\\\"" + choice + "\\\"");
        }
    }
    std::string out;
    for (const std::string& word : all)
        out += "\"" + word + "\"\n";
    return out;
}

void fuzz::writeSeeds(const fs::path& out) {
    fs::create_directories(out / "ply");
    io::write(out / "ply/native.ply", fullModel());
    ::put(out / "ply/big", bigEndianPly());
    for (const char* name : {"pcd/all.pcd", "las/extra.las", "laz/extra.laz"}) {
        fs::create_directories((out / name).parent_path());
        io::write(out / name, fullModel());
    }
    for (const char* name : {"las/modern.las", "laz/layered.laz"})
        io::write(out / name, lidarModel());
    ::put(out / "e57/packed", packedE57());
    ::put(out / "3mf/package", package());
    ::put(out / "gltf/scene", sceneText());
    io::write(out / "gltf/cloud.glb", fullModel());
    ::put(out / "stl/binary", triangleStl());
    ::put(out / "gzip/stored", test::storedGzip("1 2 3\n4 5 6\n") + test::storedGzip("7 8 9\n"));
    const std::uint32_t pixels[] = {0xff0000ffu, 0x8000ff00u, 0xffff0000u, 0xffffffffu, 0u, 0xff808080u};
    ::put(out / "picture/colour.png", io::encodePng(pixels, 3, 2, "colour.png"));
    ::put(out / "picture/grey.jpg", jpeg(false, 1));
    ::put(out / "picture/colour.jpg", jpeg(false, 3));
    ::put(out / "picture/progressive.jpg", jpeg(true, 3));
    ::put(out / "session.dict", words());
    session::Document document;
    session::Context context{document, {}, {}, {}, 0, {}, nullptr};
    session::run(context, {{"op", "new"}, {"sample", "moebius"}, {"count", 120}});
    fs::create_directories(out / "open");
    io::write(out / "open/sample.ply", document.fileModel());
    session::run(context, {{"op", "scene"}, {"do", "duplicate"}});
    io::write(out / "open/scene.ply", session::togetherAsParts(document.scene()));
}
