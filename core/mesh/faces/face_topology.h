// How the faces of a file are connected: which of them meet in an edge, which way each is turned, where the edges
// are sharp, whether the whole is closed.
//
// Any faces will do. Corners at the same place count as one vertex, whatever their numbers (STL repeats every corner,
// OBJ and PLY those along seams); along the boundary also those that differ by round-off alone, and corners that lie on
// sides of others cut these (tee_joints.h). Faces listed twice count once. Where three faces and more meet in an edge,
// those with the solid on both sides are left out (face_cells.h), and so are those with two corners at one place. Edges
// of one, three or more faces hold nothing together; faces without area belong to the patch beside them, and have no
// direction of their own.
//
//     patch      faces connected over edges of exactly two faces whose dihedral angle is at most `sharp`
//     fan        the corners of one patch around a vertex: they share a normal
//     turned out a closed piece that was inside out looks outwards now (turn_outwards.h)
//     reversed   the face runs the other way round than most (by area) of the piece it belongs to
//     closed     every edge has an even number of faces, as given or without repetitions: there is no boundary
#pragma once

#include "core/base/vec.h"
#include "core/mesh/mesh.h"

#include <span>
#include <vector>

namespace mesh {

/// An edge between two triangles whose dihedral angle is larger than what counts as smooth.
struct SharpEdge {
    base::Vec3d from, to;
    std::uint32_t left = 0, right = 0; ///< triangles; both may belong to one patch, around the end of the edge
    bool convex = true;                ///< as seen from where the triangles' normals point
    double turn = 0;                   ///< between the normals, radians
    std::uint32_t ends[2] = {};        ///< where it begins and ends, as a number of the place
    bool atBorder[2] = {};             ///< has an edge there another number of triangles than two?
    double rough = 0; ///< mean turn of the smooth edges at both ends, by length, radians: is it an edge among bumps?
};

/// An edge of one triangle only.
struct BorderEdge {
    base::Vec3d from, to;
    std::uint32_t ends[2] = {}; ///< as numbers of the places
    std::uint32_t corner = 0;   ///< 3 t + k: it is the side of triangle t from corner k to the next, or a part of that
};

constexpr std::uint32_t noBody = ~0u; ///< faces that enclose nothing

struct FaceTopology {
    std::vector<Triangle> triangles;    ///< those of the file without repetitions and what is inside, turned alike and
                                        ///< outwards; corners as in the file
    std::vector<std::uint32_t> sources; ///< of each triangle: its number among those given
    std::vector<base::Vec3d> normals;   ///< unit normal of each triangle; zero where it has no area
    std::vector<double> areas;          ///< of each triangle
    std::vector<std::uint32_t> patches; ///< of each triangle, numbered from 0 in the order of their first triangles
    std::vector<std::uint32_t> bodies;  ///< of each triangle: the closed piece of faces it belongs to, or noBody
    std::vector<std::uint8_t> sealed;   ///< of each body: 1 where it has no hole at all
    std::vector<std::uint32_t> pieces;  ///< of each triangle: what hangs together over edges, of however many faces
    std::vector<std::uint32_t> fans;    ///< of each corner (3 t + k), numbered from 0
    std::size_t patchCount = 0, pieceCount = 0, fanCount = 0;
    std::size_t repeated = 0;                 ///< triangles left out because another one has the same corners
    std::size_t inside = 0;                   ///< triangles left out because the solid is on both of their sides
    std::vector<std::uint32_t> insideCorners; ///< of those
    std::size_t reversed = 0;                 ///< triangles that were turned round
    std::size_t turnedOut = 0;                ///< closed pieces that were inside out
    std::size_t borders = 0;                  ///< edges with an odd number of faces
    std::size_t bordersGiven = 0;             ///< the same with repeated triangles counted as often as they come
    std::size_t nonManifold = 0;              ///< edges with more than two faces
    bool oneSided = false;                    ///< some piece cannot be turned alike: a Moebius strip
    std::vector<SharpEdge> sharpEdges;
    std::vector<BorderEdge> borderEdges;
    std::vector<float> turns; ///< dihedral angle of each edge of exactly two faces, radians
    double sharpShare = 0;    ///< of their length, of those that are sharp
    double area = 0;          ///< of all triangles

    /// A few repeated triangles do not open what is closed with them.
    bool closed() const {
        return !triangles.empty() && (borders == 0 || (bordersGiven == 0 && 50 * repeated < triangles.size()));
    }
};

/// `sharp`: in radians; infinity: no edge is sharp. REQUIRES: corners are below positions.size(). Time: that of a sort.
FaceTopology faceTopology(std::span<const base::Vec3f> positions, std::span<const Triangle> triangles, double sharp);

} // namespace mesh
