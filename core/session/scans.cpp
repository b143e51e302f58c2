#include "core/session/scans.h"

#include "core/base/error.h"
#include "core/base/listed.h"
#include "core/base/short_number.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/registering/place_all.h"
#include "core/surface/definition_text.h"

#include <algorithm>
#include <sstream>

namespace session {

using base::Vec3d;
using process::Rigid;

void add(Scans& scans, const std::string& name, const Document& document) {
    if (document.surface().tree().empty())
        throw base::Error("there is no model to register", name, "open one first");
    if (document.surface().definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(document.surface().definition().manifold) + " cannot be registered", name,
                          "use --manifold surface");
    scans.names.push_back(name);
    scans.documents.push_back(document);
    process::Placed placed{document.surface(), {}};
    placed.pose.translation = document.provenance().origin - scans.origin();
    scans.placed.push_back(placed);
}

void bring(Scans& scans, bool anywhere, std::vector<std::string>& messages, const base::Progress& progress) {
    process::AlignOptions how;
    if (anywhere) {
        process::placeAll(scans.placed, scans.names, process::part(progress, 0, 0.4));
        // Features bring them within some of their spacings.
        how.reach = 0.08 * static_cast<double>(scans.placed[0].surface.tree().bounds().diagonal());
    }
    const process::Alignment found = process::align(scans.placed, how, process::part(progress, 0.4, 1));
    if (!found.settled)
        messages.push_back("The models were still moving a little after " + std::to_string(found.rounds) + " rounds.");
    for (std::size_t m = 1; m < scans.placed.size(); ++m) {
        std::ostringstream text;
        text.precision(4);
        text << scans.names[m] << ": rms " << scans.placed[m].rms << " to the others' surfaces, which "
             << 100 * scans.placed[m].overlap << " % of it overlaps.";
        messages.push_back(text.str());
        if (!scans.placed[m].held)
            messages.push_back(scans.names[m] + " is not held there: it slides along the others, and fits as well " +
                               base::shortNumber(found.slide, 3) +
                               " beside; move it to its place by hand, or add what " +
                               "overlaps where the shape tells more.");
        else if (!scans.placed[m].unique)
            messages.push_back(scans.names[m] + " fits nearly as well in another place; look whether this is the " +
                               "right one, or move it near its place and do not look for it everywhere.");
    }
}

Rigid betweenFiles(const Scans& scans, std::size_t m) {
    Rigid out = scans.placed[m].pose;
    out.translation = out(-scans.documents[m].provenance().origin) + scans.origin();
    return out;
}

static const surfel::AttributeLayout& layoutOf(const process::Placed& placed) {
    return *placed.surface.tree().layout();
}

/// Shapes and what layers hold would have to turn along, and labels and layers have numbers that each model gives anew.
static bool isOfOneModel(const std::string& name) {
    constexpr const char* labels[] = {"cell", "partner", "sign", "sharpness", "face"};
    return name.starts_with("support_shape_") || name.starts_with("layer_") ||
           std::find(std::begin(labels), std::end(labels), name) != std::end(labels);
}

static surfel::AttributeLayoutPtr commonLayout(const Scans& scans) {
    auto out = std::make_shared<surfel::AttributeLayout>();
    out->normals = out->oriented = out->colours = out->masks = true;
    for (const process::Placed& p : scans.placed) {
        const surfel::AttributeLayout& layout = layoutOf(p);
        out->normals &= layout.normals, out->oriented &= layout.oriented;
        out->colours &= layout.colours, out->masks &= layout.masks;
    }
    for (const surfel::Attribute& a : layoutOf(scans.placed[0]).attributes()) {
        const auto has = [&](const process::Placed& p) {
            const surfel::Attribute* own = layoutOf(p).find(a.name);
            return own && own->type == a.type;
        };
        if (a.name != "scan" && !isOfOneModel(a.name) && std::all_of(scans.placed.begin(), scans.placed.end(), has))
            out->add(a.name, a.type);
    }
    out->add("scan", surfel::ScalarType::Int32);
    return out;
}

/// What people call it.
static std::string wordOf(const std::string& attribute) {
    return !isOfOneModel(attribute)                  ? "\"" + attribute + "\""
           : attribute.starts_with("layer_")         ? "the layers"
           : attribute.starts_with("support_shape_") ? "the shapes of supports"
                                                     : "the creases";
}

std::string lossOf(const Scans& scans) {
    const surfel::AttributeLayoutPtr common = commonLayout(scans);
    std::vector<std::string> lost;
    const auto ask = [&](bool has, bool kept, const std::string& name) {
        if (has && !kept && std::find(lost.begin(), lost.end(), name) == lost.end())
            lost.push_back(name);
    };
    for (const process::Placed& p : scans.placed) {
        const surfel::AttributeLayout& layout = layoutOf(p);
        ask(layout.normals, common->normals, "the normals");
        ask(layout.colours, common->colours, "the colours");
        ask(layout.masks, common->masks, "the masks");
        for (const surfel::Attribute& a : layout.attributes())
            ask(true, common->find(a.name) != nullptr, wordOf(a.name));
    }
    return lost.empty() ? std::string() : "Left out, as not all models share them: " + base::listed(lost) + ".";
}

surfel::SurfelList together(const Scans& scans, const Vec3d& shift) {
    surfel::SurfelList out;
    out.layout = commonLayout(scans);
    std::vector<std::uint32_t> words(out.layout->words());
    double last = 0; // number of a scan
    for (std::size_t m = 0; m < scans.placed.size(); ++m) {
        const surfel::SurfelList list = scans.placed[m].surface.tree().surfels();
        const surfel::Attribute* numbers = m == 0 ? list.layout->find("scan") : nullptr;
        const double next = m == 0 ? 0 : last + 1;
        for (std::size_t i = 0; i < list.size(); ++i) {
            surfel::Surfel s = list.items[i];
            if (m > 0 || shift != Vec3d{})
                s.position = base::cast<float>(scans.placed[m].pose(base::cast<double>(s.position)) + shift);
            if (m > 0)
                s.normal = base::normalized(base::cast<float>(scans.placed[m].pose.turn(base::cast<double>(s.normal))),
                                            s.normal);
            s.support = 0;
            const double number = numbers ? std::max(0.0, surfel::read(*numbers, list.extraOf(i))) : next;
            for (const surfel::Attribute& a : out.layout->attributes())
                surfel::write(a, words,
                              a.name == "scan" ? number : surfel::read(*list.layout->find(a.name), list.extraOf(i)));
            last = std::max(last, number);
            out.append(s, words);
        }
    }
    return out;
}

} // namespace session
