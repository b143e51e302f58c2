// The model parts of a 3MF package (3MF Core Specification 1.3, Materials and Properties, Production), as they stand in
// its XML: objects, colours and what is to be built. threemf_reader.cpp makes a model of them.
#pragma once

#include "core/io/packed/zip_archive.h"
#include "core/io/scene/scene_points.h"
#include "core/io/xml_stream.h"

#include <array>
#include <functional>
#include <map>

namespace io::threemf {

constexpr std::uint32_t nothing = 0xffffffffu;

/// One object where another or the build wants it.
struct Placed {
    std::string part; ///< "" for the one that names it
    std::uint32_t object = nothing;
    Placement placement;
};

struct Triangle {
    std::array<std::uint32_t, 3> corners;
    std::uint32_t group = nothing; ///< of properties
    std::array<std::uint32_t, 3> properties;
};

struct Object {
    std::vector<base::Vec3d> vertices;
    std::vector<Triangle> triangles;
    std::vector<Placed> components;
    std::uint32_t group = nothing, property = nothing; ///< of triangles that name none
};

/// Colours, or places in a picture.
struct Group {
    std::vector<surfel::Colour> colours;
    std::vector<mesh::Polygons::Place> places;
    std::uint32_t picture = nothing; ///< id of the part's picture
};

struct Picture {
    std::string entry;
    bool clamped = false;
};

struct Part {
    std::string unit = "millimeter";
    std::map<std::uint32_t, Object> objects;
    std::map<std::uint32_t, Group> groups;
    std::map<std::uint32_t, Picture> pictures;
    std::vector<Placed> build;
};

/// `left` is how many bytes all entries together may still become; it is counted down. Throws base::Error where they
/// become more, and where the entry is damaged; base::Cancelled.
void unpackWithin(const FileBytes& file, const ZipEntry& entry, std::size_t& left, const base::Progress& progress,
                  const std::function<void(std::string_view)>& sink);

/// Throws as unpackWithin does, and base::Error where the entry is no XML.
Part readPart(const FileBytes& file, const ZipEntry& entry, std::size_t& left, const base::Progress& progress);

/// The name of the entry that the build stands in; empty where the package does not tell.
std::string rootPart(const FileBytes& file, const std::vector<ZipEntry>& entries, std::size_t& left,
                     const base::Progress& progress);

} // namespace io::threemf
