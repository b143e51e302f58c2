// pointclay register: scans brought together, by features where nothing is known of their places, then each one's
// points onto the surfaces of the others; one model of all of them comes out.
#include "app/open_model.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/base/cancel_scope.h"
#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/registering/align.h"
#include "core/process/registering/find_place.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace app {

using base::Vec3d;
using process::Rigid;

namespace {

struct Options {
    std::vector<std::string> moving;
    std::string fixed, out, report;
    bool global = false;
    std::shared_ptr<SurfaceOptions> surface;
};

/// The fixed model first.
struct Scans {
    std::vector<std::string> names;
    std::vector<session::Document> documents;
    std::vector<process::Placed> placed; ///< in the fixed model's coordinates, relative to its origin

    Vec3d origin() const { return documents[0].provenance().origin; }
};

Scans opened(const Options& options, Console& console) {
    Scans out;
    out.names.push_back(options.fixed);
    out.names.insert(out.names.end(), options.moving.begin(), options.moving.end());
    for (const std::string& name : out.names) {
        session::Document document;
        session::Context context{document, {}, console.progress(), {}, 0, {}, nullptr};
        openModel(context, name, options.surface->parameters(), console);
        if (document.surface().definition().manifold == surface::Manifold::Curve)
            throw base::Error("a curve cannot be registered", name, "use --manifold surface");
        out.documents.push_back(document);
        process::Placed placed{document.surface(), {}};
        placed.pose.translation = document.provenance().origin - out.origin();
        out.placed.push_back(placed);
    }
    return out;
}

/// What `next` adds once it is where `pose` says.
void add(process::Features& all, const process::Features& next, const Rigid& pose) {
    for (std::size_t i = 0; i < next.position.size(); ++i) {
        all.position.push_back(pose(next.position[i]));
        all.normal.push_back(pose.turn(next.normal[i]));
    }
    all.feature.insert(all.feature.end(), next.feature.begin(), next.feature.end());
    all.oriented = all.oriented && next.oriented;
}

/// The scan that fits best to those that have a place goes to its own, one after the other.
void findPlaces(Scans& scans, const base::Progress& progress) {
    constexpr double leastShare = 0.1, perDiagonal = 1 / 70.0;
    double spacing = perDiagonal * static_cast<double>(scans.placed[0].surface.tree().bounds().diagonal());
    for (const process::Placed& p : scans.placed)
        spacing = std::max(spacing, 2 * static_cast<double>(process::typicalSpacing(p.surface.tree())));
    const auto wide = static_cast<float>(spacing);
    std::vector<process::Features> features;
    for (const process::Placed& p : scans.placed)
        features.push_back(process::featuresOf(p.surface, wide, progress));
    process::Features all = features[0];
    std::vector<std::size_t> waiting;
    for (std::size_t m = 1; m < features.size(); ++m)
        waiting.push_back(m);
    while (!waiting.empty()) {
        process::FoundPlace best;
        std::size_t which = 0;
        for (std::size_t k = 0; k < waiting.size(); ++k)
            if (const auto found = process::findPlace(features[waiting[k]], all, wide, progress);
                found.share > best.share)
                best = found, which = k;
        const std::size_t m = waiting[which];
        if (best.share < leastShare)
            throw base::Error("nothing in it looks like a part of the others", scans.names[m],
                              "move it near its place and leave --global out");
        scans.placed[m].pose = best.pose;
        add(all, features[m], best.pose);
        waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(which));
    }
}

/// From the file coordinates of one model to those of the fixed one.
Rigid betweenFiles(const Scans& scans, std::size_t m) {
    Rigid out = scans.placed[m].pose;
    out.translation = out(-scans.documents[m].provenance().origin) + scans.origin();
    return out;
}

std::vector<double> rowsOf(const Rigid& motion) {
    std::vector<double> out;
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c)
            out.push_back(motion.rotation[r][c]);
        out.push_back(motion.translation[static_cast<std::size_t>(r)]);
    }
    out.insert(out.end(), {0, 0, 0, 1});
    return out;
}

/// Attributes that all of them have alike, and `scan`, the number of the model; 0 is the fixed one.
surfel::AttributeLayoutPtr commonLayout(const Scans& scans) {
    auto out = std::make_shared<surfel::AttributeLayout>();
    out->normals = out->oriented = out->colours = out->masks = true;
    for (const process::Placed& p : scans.placed) {
        const surfel::AttributeLayout& layout = *p.surface.tree().layout();
        out->normals &= layout.normals, out->oriented &= layout.oriented;
        out->colours &= layout.colours, out->masks &= layout.masks;
    }
    for (const surfel::Attribute& a : scans.placed[0].surface.tree().layout()->attributes()) {
        const auto has = [&](const process::Placed& p) {
            const surfel::Attribute* own = p.surface.tree().layout()->find(a.name);
            return own && own->type == a.type;
        };
        // Shapes would have to turn along, and supports are left to whoever opens it.
        if (a.name != "scan" && !a.name.starts_with("support_shape_") &&
            std::all_of(scans.placed.begin(), scans.placed.end(), has))
            out->add(a.name, a.type);
    }
    out->add("scan", surfel::ScalarType::Int32);
    return out;
}

/// All of them in the fixed model's coordinates. Supports are left to whoever opens it: where scans overlap there are
/// more points than in each of them.
io::FileModel together(const Scans& scans) {
    io::FileModel out = scans.documents[0].fileModel();
    out.points = {};
    out.points.layout = commonLayout(scans);
    out.hasSupports = out.limitDecided = false;
    out.elements.clear();
    std::vector<std::uint32_t> words(out.points.layout->words());
    for (std::size_t m = 0; m < scans.placed.size(); ++m) {
        const surfel::SurfelList list = scans.placed[m].surface.tree().surfels();
        for (std::size_t i = 0; i < list.size(); ++i) {
            surfel::Surfel s = list.items[i];
            s.position = base::cast<float>(scans.placed[m].pose(base::cast<double>(s.position)));
            if (m > 0)
                s.normal = base::normalized(base::cast<float>(scans.placed[m].pose.turn(base::cast<double>(s.normal))),
                                            s.normal);
            s.support = 0;
            for (const surfel::Attribute& a : out.points.layout->attributes()) {
                const surfel::Attribute* own = list.layout->find(a.name);
                surfel::write(a, words,
                              a.name == "scan" ? static_cast<double>(m) : surfel::read(*own, list.extraOf(i)));
            }
            out.points.append(s, words);
        }
    }
    return out;
}

nlohmann::ordered_json reportOf(const Scans& scans) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (std::size_t m = 1; m < scans.placed.size(); ++m)
        out.push_back({{"model", scans.names[m]},
                       {"matrix", rowsOf(betweenFiles(scans, m))},
                       {"rms", scans.placed[m].rms},
                       {"overlap", scans.placed[m].overlap}});
    return out;
}

void run(const Options& options, Console& console) {
    const base::Progress progress = console.progress();
    const base::CancelScope scope(progress.cancel);
    Scans scans = opened(options, console);
    if (options.global)
        findPlaces(scans, process::part(progress, 0.2, 0.5));
    process::AlignOptions how;
    if (options.global) // features bring them within some of their spacings
        how.reach = 0.08 * static_cast<double>(scans.placed[0].surface.tree().bounds().diagonal());
    const process::Alignment found = process::align(scans.placed, how, process::part(progress, 0.5, 0.9));
    if (!found.settled)
        console.tell("The models were still moving a little after " + std::to_string(found.rounds) + " rounds.");
    for (std::size_t m = 1; m < scans.placed.size(); ++m) {
        std::ostringstream text;
        text.precision(4);
        text << scans.names[m] << ": rms " << scans.placed[m].rms << " to the others' surfaces, which "
             << 100 * scans.placed[m].overlap << " % of it overlaps.";
        console.tell(text.str());
    }
    std::ostringstream hint;
    hint.precision(3);
    hint << "Where models overlap there are points of each. One even layer of them: pointclay clean --thin "
         << process::typicalSpacing(scans.placed[0].surface.tree()) << ", or resample.";
    console.tell(hint.str());
    io::write(options.out, together(scans), process::part(progress, 0.9, 1));
    if (!options.report.empty())
        io::writeFile(options.report, reportOf(scans).dump(2) + "\n");
}

} // namespace

Action addRegister(OptionSet command) {
    auto options = std::make_shared<Options>();
    command.add("MOVING", options->moving, "models to move").required();
    command.add("--to", options->fixed, "model that stays where it is").typeName("FIXED").required();
    command
        .add("-o,--output", options->out,
             "model to write: all of them in FIXED's place, with an attribute `scan` that tells whose a point was "
             "(0: FIXED)")
        .typeName("OUT")
        .required();
    command.addFlag("--global", options->global,
                    "look for the places of the models everywhere, by what their surfaces look like; otherwise they "
                    "begin where they are");
    command
        .add("--report", options->report,
             "JSON file to write: for each moving model its matrix (16 numbers by row), rms and overlap")
        .typeName("OUT.json");
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { run(*options, console); };
}

} // namespace app
