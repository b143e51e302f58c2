// What mesh files say, by readers that share nothing with ours: what our writers are held against.
#pragma once

#include "core/io/packed/zip_archive.h"
#include "core/mesh/mesh.h"

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QXmlStreamReader>
#include <sstream>

namespace mesh_files {

using base::Vec3d;

template <class T>
T take(const std::string& bytes, std::size_t& at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

/// What a file says, by a reader of its own: STL has its corners one by one.
struct Found {
    std::vector<Vec3d> positions, normals;
    std::vector<std::array<double, 4>> colours;
    std::vector<mesh::Triangle> triangles;
};

inline Found readPlyFile(const std::string& bytes) {
    Found out;
    std::size_t vertices = 0, faces = 0, at = bytes.find("end_header\n") + 11;
    std::istringstream head(bytes.substr(0, at));
    std::vector<std::string> names;
    for (std::string line; std::getline(head, line);) {
        std::istringstream words(line);
        std::string key, type, name;
        words >> key >> type >> name;
        if (key == "element")
            (type == "vertex" ? vertices : faces) = std::stoull(name);
        else if (key == "property" && type != "list")
            names.push_back(type + " " + name);
    }
    for (std::size_t i = 0; i < vertices; ++i) {
        std::map<std::string, double> values;
        for (const std::string& name : names)
            values[name.substr(name.find(' ') + 1)] = name.starts_with("double")  ? take<double>(bytes, at)
                                                      : name.starts_with("float") ? double(take<float>(bytes, at))
                                                                                  : take<std::uint8_t>(bytes, at);
        out.positions.push_back({values["x"], values["y"], values["z"]});
        if (values.contains("nx"))
            out.normals.push_back({values["nx"], values["ny"], values["nz"]});
        if (values.contains("red"))
            out.colours.push_back({values["red"], values["green"], values["blue"], values["alpha"]});
    }
    for (std::size_t f = 0; f < faces; ++f) {
        if (take<std::uint8_t>(bytes, at) != 3)
            return {};
        const auto a = take<std::uint32_t>(bytes, at), b = take<std::uint32_t>(bytes, at);
        out.triangles.push_back({a, b, take<std::uint32_t>(bytes, at)});
    }
    return at == bytes.size() ? out : Found{};
}

inline Found readObjFile(const std::string& bytes) {
    Found out;
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key;
        words >> key;
        Vec3d v, c;
        if (key == "v" && words >> v.x >> v.y >> v.z) {
            out.positions.push_back(v);
            if (words >> c.x >> c.y >> c.z)
                out.colours.push_back({std::round(255 * c.x), std::round(255 * c.y), std::round(255 * c.z), 255});
        } else if (key == "vn" && words >> v.x >> v.y >> v.z) {
            out.normals.push_back(v);
        } else if (key == "f") {
            mesh::Triangle t{};
            std::string corner;
            for (std::uint32_t& index : t) {
                words >> corner;
                index = static_cast<std::uint32_t>(std::stoul(corner)) - 1;
                const std::size_t slash = corner.find("//");
                if (slash != std::string::npos && std::stoul(corner.substr(slash + 2)) != index + 1)
                    return {};
            }
            out.triangles.push_back(t);
        }
    }
    return out;
}

inline Found readOffFile(const std::string& bytes) {
    Found out;
    std::istringstream in(bytes);
    std::string word;
    std::size_t vertices = 0, faces = 0, edges = 0;
    in >> word >> vertices >> faces >> edges;
    for (std::size_t i = 0; i < vertices; ++i) {
        Vec3d v;
        in >> v.x >> v.y >> v.z;
        out.positions.push_back(v);
        if (word.find('N') != std::string::npos) {
            in >> v.x >> v.y >> v.z;
            out.normals.push_back(v);
        }
        if (word.find('C') != std::string::npos) {
            std::array<double, 4> c{};
            in >> c[0] >> c[1] >> c[2] >> c[3];
            out.colours.push_back(c);
        }
    }
    for (std::size_t f = 0; f < faces; ++f) {
        int corners = 0;
        mesh::Triangle t{};
        in >> corners >> t[0] >> t[1] >> t[2];
        if (corners != 3)
            return {};
        out.triangles.push_back(t);
    }
    return out;
}

inline Found readStlFile(const std::string& bytes) {
    Found out;
    if (bytes.starts_with("solid")) {
        std::istringstream in(bytes);
        Vec3d v;
        for (std::string word; in >> word;)
            if (word == "vertex" && in >> v.x >> v.y >> v.z)
                out.positions.push_back(v);
    } else {
        std::size_t at = 80;
        const auto count = take<std::uint32_t>(bytes, at);
        for (std::uint32_t f = 0; f < count; ++f, at += 2)
            for (int k = 0; k < 4; ++k) {
                const auto x = take<float>(bytes, at), y = take<float>(bytes, at);
                const Vec3d v{x, y, take<float>(bytes, at)};
                (k == 0 ? out.normals : out.positions).push_back(v);
            }
    }
    for (std::uint32_t i = 0; i + 2 < out.positions.size(); i += 3)
        out.triangles.push_back({i, i + 1, i + 2});
    return out;
}

/// The buffer of a GLB file by its accessors; colours are told by their 16 bits, which are linear.
inline Found readGlbFile(const std::string& bytes) {
    Found out;
    std::size_t at = 12;
    const auto size = take<std::uint32_t>(bytes, at);
    const QJsonObject root =
        QJsonDocument::fromJson(QByteArray(bytes.data() + 20, static_cast<qsizetype>(size))).object();
    const std::size_t body = 28 + size;
    const QJsonObject primitive = root["meshes"].toArray()[0].toObject()["primitives"].toArray()[0].toObject();
    const QJsonArray shift = root["nodes"].toArray()[0].toObject()["translation"].toArray();
    const Vec3d origin{shift[0].toDouble(), shift[1].toDouble(), shift[2].toDouble()};
    const auto forValues = [&](const QJsonValue& number, const auto& each) {
        if (!number.isDouble())
            return;
        const QJsonObject accessor = root["accessors"].toArray()[number.toInt()].toObject();
        const QJsonObject view = root["bufferViews"].toArray()[accessor["bufferView"].toInt()].toObject();
        std::size_t next = body + static_cast<std::size_t>(view["byteOffset"].toInt());
        for (int i = 0; i < accessor["count"].toInt(); ++i)
            each(next);
    };
    const auto vectorAt = [&](std::size_t& next) {
        const auto x = take<float>(bytes, next), y = take<float>(bytes, next);
        return Vec3d{x, y, take<float>(bytes, next)};
    };
    const QJsonObject attributes = primitive["attributes"].toObject();
    forValues(attributes["POSITION"], [&](std::size_t& next) { out.positions.push_back(vectorAt(next) + origin); });
    forValues(attributes["NORMAL"], [&](std::size_t& next) { out.normals.push_back(vectorAt(next)); });
    forValues(attributes["COLOR_0"], [&](std::size_t& next) {
        std::array<double, 4> colour{};
        for (std::size_t k = 0; k < 4; ++k) {
            const double v = take<std::uint16_t>(bytes, next) / 65535.0;
            const double srgb = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
            colour[k] = std::round(255 * (k == 3 ? v : srgb));
        }
        out.colours.push_back(colour);
    });
    std::vector<std::uint32_t> corners;
    forValues(primitive["indices"], [&](std::size_t& next) { corners.push_back(take<std::uint32_t>(bytes, next)); });
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        out.triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return out;
}

/// What stands in the XML of a 3MF package, by Qt's reader.
inline Found read3mfFile(const std::string& bytes) {
    Found out;
    const io::FileBytes file("a.3mf", bytes);
    const auto entries = io::zipEntries(file);
    QXmlStreamReader xml(QByteArray::fromStdString(io::unpackedEntry(file, entries.back(), {})));
    std::vector<std::array<double, 4>> palette;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const auto number = [&](const char* name) { return xml.attributes().value(QLatin1String(name)); };
        if (xml.name() == QLatin1String("vertex")) {
            out.positions.push_back({number("x").toDouble(), number("y").toDouble(), number("z").toDouble()});
        } else if (xml.name() == QLatin1String("color")) {
            const std::uint32_t bits = number("color").mid(1).toUInt(nullptr, 16);
            palette.push_back(
                {double(bits >> 24), double(bits >> 16 & 255), double(bits >> 8 & 255), double(bits & 255)});
        } else if (xml.name() == QLatin1String("triangle")) {
            out.triangles.push_back({number("v1").toUInt(), number("v2").toUInt(), number("v3").toUInt()});
            out.colours.resize(palette.empty() ? 0 : out.positions.size());
            for (std::size_t k = 0; k < 3 && !palette.empty(); ++k) {
                out.colours[out.triangles.back()[k]] = palette[number(std::array{"p1", "p2", "p3"}[k]).toUInt()];
            }
        }
    }
    return xml.hasError() ? Found{} : out;
}

inline const std::map<std::string, Found (*)(const std::string&)> readers = {
    {"ply", readPlyFile}, {"obj", readObjFile}, {"off", readOffFile},
    {"stl", readStlFile}, {"glb", readGlbFile}, {"3mf", read3mfFile}};

} // namespace mesh_files
