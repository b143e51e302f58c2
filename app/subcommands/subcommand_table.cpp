#include "app/subcommands/subcommand.h"

namespace app {

std::span<const SubcommandRow> subcommandTable() {
    static constexpr SubcommandRow rows[] = {
        {"info", "Show what a model contains", "pointclay info bunny.ply --json", addInfo},
        {"convert", "Write a model in another format", "pointclay convert scan.xyz scan.ply", addConvert},
        {"clean", "Take outliers, noise and duplicates out of a scan, and make its normals anew",
         "pointclay clean scan.ply clean.ply --outliers surface --denoise auto --report clean.json", addClean},
        {"resample", "Space the points of a model anew on the surface that they define",
         "pointclay resample scan.ply -o even.ply --count 20000", addResample},
        {"register", "Bring scans of one thing together",
         "pointclay register side.ply back.ply --to front.ply -o all.ply --global", addRegister},
        {"measure", "Measure area, volume, distances, ways along the surface, thickness, and shapes that fit",
         "pointclay measure scan.ply area volume --to part.ply --fit cylinder", addMeasure},
        {"shapes", "Find planes, spheres, cylinders and the like among a model's points, and number them",
         "pointclay shapes room.e57 -o room.ply --kinds plane,cylinder --colours on", addShapes},
        {"query", "Evaluate, differentiate and project at positions, into a CSV file",
         "pointclay query bunny.ply --at points.xyz --what value,normal,project-orthogonal -o out.csv", addQuery},
        {"intersect", "Intersect rays with the surface, into a CSV file",
         "pointclay intersect bunny.ply --rays rays.csv -o hits.csv", addIntersect},
        {"boundary", "Trace the boundary of an open surface, into a CSV, OBJ or DXF file",
         "pointclay boundary sample:moebius -o rims.obj", addBoundary},
        {"seams", "Trace the edges that a model keeps sharp, into a CSV, OBJ or DXF file",
         "pointclay seams part.stl -o edges.obj", addSeams},
        {"section", "Trace the curves where a plane cuts the surface, into a CSV, OBJ, DXF or SVG file",
         "pointclay section bunny.ply --plane 0,1,0,0.1 -o section.obj", addSection},
        {"mesh", "Triangulate the surface, into a mesh file",
         "pointclay mesh bunny.ply -o bunny.stl --method delaunay --check", addMesh},
        {"haptic", "Play the way of a tool over the surface, and write what it feels, into a CSV file",
         "pointclay haptic bunny.ply --trajectory tool.csv -o felt.csv --radius 0.002 --friction 0.3", addHaptic},
        {"solid", "Put two models together as solids: union, difference or intersection",
         "pointclay solid bunny.ply sample:sphere -o bitten.ply --op difference --scale 0.03", addSolid},
        {"cut", "Cut a model by a plane; --cap closes it",
         "pointclay cut bunny.ply --plane 0,1,0,0.1 --cap -o bust.ply", addCut},
        {"trim", "Cut a model along an outline drawn in a picture of it, straight through, and close it",
         "pointclay trim bunny.ply -o ear.ply --eye 0,0.1,0.6 --target 0,0.1,0 --rectangle 400,80,640,300 --keep "
         "inside",
         addTrim},
        {"tube", "Join a tube along a curve to a model, or take it away: a handle, a channel",
         "pointclay tube cup.ply -o mug.ply --along '1,0.5,0 1.6,0,0 1,-0.5,0' --radius 0.1 --fillet 0.05", addTube},
        {"merge", "Make one solid of parts that were pushed into each other", "pointclay merge parts.ply -o whole.ply",
         addMerge},
        {"crease", "Make edges that stay sharp: where points have them, or along a line",
         "pointclay crease part.xyz -o part.ply --detect --report creases.json", addCrease},
        {"fill", "Close the holes of an open surface", "pointclay fill bunny.ply -o whole.ply --up-to 0.05", addFill},
        {"reduce", "Make the same surface with fewer points, and tell how near it is",
         "pointclay reduce bunny.ply -o light.ply --ratio 0.1 --report light.json", addReduce},
        {"refine", "Sample the surface of a reduced model densely and evenly, and tell how near that is",
         "pointclay refine light.ply -o dense.ply --spacing 0.002 --to bunny.ply", addRefine},
        {"render", "Draw a model into an image file, without a window",
         "pointclay render bunny.ply -o bunny.png --size 800x600 --mode raycast", addRender},
        {"run", "Execute a session file", "pointclay run session.jsonl --model bunny.ply -o out.ply", addRun},
        {"recover", "Restore the model from the journal that a crash left behind",
         "pointclay recover ~/.local/state/pointclay/journal-4711.jsonl -o rescued.ply", addRecover},
        {"bench", "Measure how fast this machine is, each workload beside a naive baseline",
         "pointclay bench evaluate rays-camera --threads 1 --json out.json", addBench},
    };
    return rows;
}

} // namespace app
