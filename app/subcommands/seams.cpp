// pointclay seams: the edges that a model keeps sharp as polylines in a file.
#include "app/open_model.h"
#include "app/options/polyline_options.h"
#include "app/polyline_file.h"
#include "app/subcommands/subcommand.h"
#include "core/cells/seam_lines.h"

#include <iostream>
#include <nlohmann/json.hpp>

namespace app {

using cells::SeamLine, cells::SeamPoint;

namespace {

void tell(const std::vector<SeamLine>& lines) {
    if (lines.empty())
        std::cout << "no seams: the model has no edges that stay sharp; 'pointclay crease' makes some\n";
    double length = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        double turn = 0;
        for (const SeamPoint& p : lines[i].points)
            turn += p.turn / static_cast<double>(lines[i].points.size());
        std::cout << "seam " << i << ": cells " << lines[i].a << " and " << lines[i].b << ", length "
                  << lines[i].length() << ", turns by " << turn << " degrees, "
                  << (lines[i].closed ? "a closed curve" : "from end to end") << '\n';
        length += lines[i].length();
    }
    if (lines.size() > 1)
        std::cout << "all: length " << length << '\n';
}

void runSeams(const PolylineOptions& options, Console& console) {
    session::Document document;
    const base::Progress progress = console.progress();
    openForPolylines(options, document, progress, console, "a curve has no seams");
    std::vector<SeamLine> lines = cells::seamLines(document.surface(), progress);
    std::erase_if(lines, [&](const SeamLine& line) { return line.length() < options.least; });
    if (!options.out.empty()) {
        std::size_t at = 0, left = lines.empty() ? 0 : lines[0].points.size();
        writePolylines(options.out, lines, document.provenance().origin, {}, "seam,closed,x,y,z,nx,ny,nz,turn,a,b\n",
                       [&](CsvWriter& csv, const SeamPoint& p) {
                           for (; left == 0; left = lines[++at].points.size())
                               continue;
                           --left;
                           csv.number(p.turn).integer(lines[at].a).integer(lines[at].b);
                       });
    }
    tell(lines);
}

} // namespace

Action addSeams(OptionSet command) {
    auto options = std::make_shared<PolylineOptions>();
    options->complexes = true;
    options->turns = false;
    command.add("MODEL", options->model, modelHelp).required();
    addPolylineOptions(command, *options, "seam",
                       "seam,closed,x,y,z,nx,ny,nz,turn,a,b (seams counted from 0, longest first; unit normal midway "
                       "between both sides; how far these turn, in degrees, below 0 in grooves; the cells that meet)");
    return [options](Console& console) { runSeams(*options, console); };
}

} // namespace app
