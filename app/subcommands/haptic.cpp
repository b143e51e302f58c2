// pointclay haptic: plays the way of a tool over a model, and writes where its proxy is and what it feels.
#include "app/csv_writer.h"
#include "app/force_picture.h"
#include "app/open_model.h"
#include "app/options/option_checks.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/subcommands/subcommand.h"
#include "core/haptics/servo.h"
#include "core/io/safe_file.h"
#include "core/process/curve_tube.h"
#include "core/render/image_io.h"
#include "core/session/trajectory_file.h"

#include <nlohmann/json.hpp>

namespace app {

using base::Vec3d;

namespace {

struct HapticArguments {
    std::string model, trajectory, out, plot;
    haptics::ToolShape tool;
    haptics::ForceLaw law;
    std::shared_ptr<SurfaceOptions> surface;
};

/// The law alone: nobody holds this device, so there is nothing to ramp, to limit or to keep passive.
haptics::ServoOptions servoOptions(const HapticArguments& options) {
    haptics::ServoOptions out;
    out.tool = options.tool;
    out.law = options.law;
    out.safety = haptics::SafetyLimits::off();
    out.passive = false;
    out.mostSteps = haptics::Proxy::patient;
    return out;
}

void write(CsvWriter& csv, const haptics::Tick& tick, const haptics::TimedPlace& given, const Vec3d& origin) {
    csv.number(given.time).place(given.place).place(tick.proxy + origin).vector(tick.force);
    csv.integer(tick.contact ? 1 : 0).number(std::round(tick.seconds * 1e7) / 10);
    csv.endRow();
}

void runHaptic(const HapticArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}, {"--plot", options.plot}});
    requireInputsKept({{"-o", options.out}, {"--plot", options.plot}}, {options.model, options.trajectory});
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    const haptics::Trajectory given = session::readTrajectory(io::FileBytes(options.trajectory), progress);
    openModel(context, options.model, options.surface->parameters(), console);
    const Vec3d origin = document.provenance().origin;
    haptics::DeviceSetup setup{given, {}};
    for (haptics::TimedPlace& each : setup.trajectory)
        each.place -= origin;

    const surface::Surface surface = process::shownAs(document.surface(), progress); // a curve's tube
    const auto patch = std::make_shared<const haptics::Patch>(haptics::Patch{surface, 0, surface.tree().bounds()});
    const auto device = haptics::device("played").open(setup);
    haptics::Servo servo(servoOptions(options));
    io::SafeFile file(options.out);
    CsvWriter csv(true, origin);
    file.write("t,x,y,z,px,py,pz,fx,fy,fz,contact,us\n");
    haptics::DeviceState state;
    std::vector<FeltForce> felt;
    for (std::size_t i = 0; device->read(state); ++i) {
        progress.step(static_cast<double>(i) / static_cast<double>(given.size()), "Feeling");
        const haptics::Tick tick = servo.step(patch, state, {state.time, 0, state.time, true});
        write(csv, tick, given[i], origin);
        if (!options.plot.empty())
            felt.push_back({given[i].time, tick.force, tick.contact});
        if (i % 4096 == 0)
            file.write(csv.take());
    }
    file.write(csv.take());
    file.commit();
    if (!options.plot.empty())
        render::savePng(forcePicture(felt), options.plot);
}

} // namespace

Action addHaptic(OptionSet command) {
    auto options = std::make_shared<HapticArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command
        .add("--trajectory", options->trajectory,
             "text file with the header t,x,y,z: where the tool is, in seconds (ascending) and model units; each "
             "row is one tick of the servo")
        .typeName("T.csv")
        .required();
    command
        .add("-o,--output", options->out,
             "CSV file to write: t,x,y,z,px,py,pz,fx,fy,fz,contact,us with the proxy's centre (off the surface "
             "by the tool's radius in contact), the force in units of stiffness times length, contact 0 or 1, "
             "and the microseconds that the step took")
        .typeName("F.csv")
        .required();
    command.add("--radius", options->tool.radius, "radius of the spherical tool in model units; 0: a point")
        .typeName("R")
        .check(atLeast(0))
        .showDefault();
    command.add("--stiffness", options->law.stiffness, "force per model unit between the tool and its proxy")
        .typeName("K")
        .check(above(0))
        .showDefault();
    command
        .add("--friction", options->tool.friction,
             "coefficient of friction: the tool sticks below and slides at this part of the normal force")
        .typeName("MU")
        .check(atLeast(0))
        .showDefault();
    command
        .add("--damping", options->law.damping,
             "force per speed (model units per second) along the normal, in contact; it never pulls")
        .typeName("B")
        .check(atLeast(0))
        .showDefault();
    command
        .add("--shading", options->law.shading,
             "radius, in units of the local support, of the spot over which the normal of the force is averaged: edges "
             "feel rounder; 0: none")
        .check(between(0, 2))
        .showDefault();
    command
        .add("--relief", options->law.texture.relief,
             "texture: part of the stiffness that comes and goes with how the surface stands out, ridges push harder "
             "than hollows")
        .check(between(0, 1))
        .showDefault();
    command
        .add("--colour", options->law.texture.colour,
             "texture: part of the stiffness that comes and goes with how light the surface is")
        .check(between(0, 1))
        .showDefault();
    command.add("--plot", options->plot, "PNG to draw of the force over time").typeName("F.png").check(pictureName());
    options->surface = addSurfaceOptions(command, false);
    return [options](Console& console) { runHaptic(*options, console); };
}

} // namespace app
