#include "app/options/view_options.h"

#include "app/framing.h"
#include "app/options/number_list.h"
#include "app/options/option_checks.h"
#include "app/options/saved_views_file.h"
#include "app/subcommands/subcommand.h"
#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/render/framed_box.h"
#include "core/render/named_views.h"

#include <cstdio>
#include <filesystem>
#include <numbers>
#include <optional>

namespace app {

using base::Vec3d;

static bool parseSize(const std::string& text, int& width, int& height) {
    int size[2];
    if (!parseNumbers(text, 'x', size))
        return false;
    width = size[0], height = size[1];
    return width >= 1 && height >= 1 && width <= 32767 && height <= 32767;
}

static std::string sizeFault(const std::string& text) {
    int width = 0, height = 0;
    return parseSize(text, width, height)
               ? ""
               : "'" + text + "' is not a size; write WIDTHxHEIGHT with 1 to 32767 pixels each";
}

static bool parseVector(const std::string& text, Vec3d& out) {
    double numbers[3];
    if (!parseNumbers(text, ',', numbers))
        return false;
    out = {numbers[0], numbers[1], numbers[2]};
    return base::isFinite(out);
}

static std::string vectorFault(const std::string& text) {
    Vec3d v;
    return parseVector(text, v) ? "" : "'" + text + "' is not x,y,z";
}

/// An axis of coordinates by its name.
static const base::UpRow* axisOf(const std::string& text) {
    return base::findRow(base::upTable(), text);
}

static std::string upFault(const std::string& text) {
    Vec3d v;
    if (axisOf(text) || (parseVector(text, v) && length(v) > 0))
        return "";
    return "'" + text + "' is neither an axis (" + base::joinedIds(base::upTable()) + ") nor a direction x,y,z";
}

static bool parsePlane(const std::string& text, base::Plane& out) {
    double numbers[4];
    if (!parseNumbers(text, ',', numbers))
        return false;
    const Vec3d n{numbers[0], numbers[1], numbers[2]};
    const double size = length(n);
    out.normal = n * (1 / size);
    out.offset = numbers[3] / size;
    return size > 0 && base::isFinite(out.normal) && std::isfinite(out.offset);
}

std::string planeFault(const std::string& text) {
    base::Plane plane;
    return parsePlane(text, plane) ? "" : "'" + text + "' is not a plane nx,ny,nz,d with a normal longer than zero";
}

base::Plane planeOf(const std::string& text, const Vec3d& origin) {
    base::Plane out;
    parsePlane(text, out);
    return out.relativeTo(origin);
}

static bool parseHeight(const std::string& text, double& out) {
    return parseNumbers(text, ',', {&out, 1}) && out > 0 && std::isfinite(out);
}

static std::string heightFault(const std::string& text) {
    double height = 0;
    return parseHeight(text, height) || text == "fit" ? "" : "'" + text + "' is neither a height above zero nor 'fit'";
}

static Option addVector(OptionSet command, const char* name, std::string& value, const char* tip) {
    return command.add(name, value, tip).typeName("x,y,z").check({vectorFault});
}

static std::string viewNames() {
    return base::joinedIds(render::namedViews());
}

std::shared_ptr<ViewOptions> addViewOptions(OptionSet command) {
    auto options = std::make_shared<ViewOptions>();
    command.add("--size", options->size, "size of the picture in pixels")
        .typeName("WxH")
        .check({sizeFault})
        .showDefault();
    command
        .add("--view", options->view,
             "look from this side, with the whole model in the picture: " + viewNames() +
                 "; or the name of a view saved in the window")
        .typeName("NAME");
    addVector(command, "--eye", options->eye,
              "position of the eye, in model units; default: where the whole model is in view");
    addVector(command, "--target", options->target, "point that the eye looks at; default: the centre of the model");
    command
        .add("--up", options->up,
             "the axis that is upwards in the model, for all views, or a direction x,y,z that is up in the "
             "picture; default: the model's own (see info)")
        .typeName("AXIS|x,y,z")
        .check({upFault});
    Option fov = command.add("--fov", options->fovDeg, "vertical angle of view in degrees; default: 35")
                     .typeName("DEG")
                     .check(between(1, 170));
    command
        .add("--ortho", options->ortho,
             "parallel projection: height of the picture in model units, or fit for the whole model")
        .typeName("HEIGHT|fit")
        .check({heightFault})
        .excludes(fov);
    command
        .add("--clip", options->clips,
             "show only what lies where nx*x + ny*y + nz*z >= d, in model units; up to 6 times")
        .typeName("nx,ny,nz,d")
        .check({planeFault})
        .oneAtATime();
    command
        .add("--turntable", options->turntable,
             "this many pictures from all around the model, turning about the up direction: IMAGE-000.png, "
             "IMAGE-001.png and so on, likewise for --depth; the eye moves to the right")
        .typeName("N")
        .check(between(1, 100000));
    return options;
}

/// Of all points of the model, in every direction of a turntable alike: the camera looks at the middle of the model.
static render::Camera framedForTurns(render::Camera camera, const tree::SurfelTree& model, int turns) {
    const Vec3d up = camera.upright();
    const base::Box3f box = render::framedBox(model);
    camera.target = base::cast<double>(box.centre());
    camera.eye = camera.target - camera.forward();
    if (model.empty())
        return camera;
    constexpr double filled = 0.94;
    const double kx = filled * 0.5 * camera.width, ky = filled * 0.5 * camera.height;
    render::Camera unit = camera;
    unit.orthoHeight = 0;
    double depth = 0, height = 0;
    for (int k = 0; k < turns; ++k) {
        const render::Camera turned = turnedAbout(unit, up, 2 * std::numbers::pi * k / turns);
        const Vec3d r = turned.right(), u = turned.upright(), f = turned.forward();
        model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int corner = 0; corner < 8; ++corner) {
                const base::Box3f b = block.box().cut(box);
                if (b.empty())
                    continue;
                const Vec3d v =
                    base::cast<double>(base::Vec3f{corner & 1 ? b.hi.x : b.lo.x, corner & 2 ? b.hi.y : b.lo.y,
                                                   corner & 4 ? b.hi.z : b.lo.z}) -
                    camera.target;
                const double across = std::max(std::abs(dot(v, r)) / kx, std::abs(dot(v, u)) / ky);
                depth = std::max(depth, across * unit.focalPx() - dot(v, f));
                height = std::max(height, across * camera.height);
            }
        });
    }
    if (camera.parallel() && height > 0)
        camera.orthoHeight = height;
    else if (depth > 0)
        camera.eye = camera.target - camera.forward() * depth;
    return camera;
}

/// Of a height that was told, around all directions: the model turns about its middle.
static render::Camera centredForTurns(render::Camera camera, const tree::SurfelTree& model) {
    const Vec3d back = camera.eye - camera.target;
    if (!model.empty())
        camera.target = base::cast<double>(render::framedBox(model).centre());
    camera.eye = camera.target + back;
    return camera.before(model.bounds());
}

/// A view that was saved in the window, whole.
static std::optional<render::Camera> savedCamera(const std::string& name, const render::Camera& size,
                                                 const base::Box3f& box, const Vec3d& origin) {
    if (name.empty() || render::namedView(name))
        return {};
    const std::vector<ui::SavedView> saved = savedViews();
    if (const ui::SavedView* found = ui::findView(saved, name))
        return found->forOrigin(origin).camera(size.width, size.height).before(box);
    std::string known = viewNames();
    for (const ui::SavedView& each : saved)
        known += ", " + each.name;
    throw base::Error("there is no view '" + name + "'", "", "use one of: " + known);
}

static render::Camera sized(const ViewOptions& options) {
    render::Camera out;
    parseSize(options.size, out.width, out.height);
    return out;
}

/// Direction and projection as asked; where it stands is still open.
static render::Camera directed(const ViewOptions& options, const base::Box3f& box, base::UpAxis up) {
    const render::Camera size = sized(options);
    render::Camera out = render::Camera::looking(box, size.width, size.height, up);
    if (const render::NamedView* row = render::namedView(options.view)) {
        const render::NamedView view = row->of(up);
        out.eye = out.target + view.toEye * length(out.eye - out.target);
        out.up = view.up;
    }
    if (options.fovDeg > 0)
        out.fovDeg = options.fovDeg;
    if (!options.up.empty() && !axisOf(options.up))
        parseVector(options.up, out.up);
    return out;
}

Vec3d upwards(const ViewOptions& options, base::UpAxis up) {
    Vec3d out = base::upRow(up).up;
    if (const base::UpRow* row = axisOf(options.up))
        out = row->up;
    else if (!options.up.empty())
        parseVector(options.up, out);
    return out;
}

std::vector<render::Camera> camerasOf(const ViewOptions& options, const tree::SurfelTree& model, const Vec3d& origin,
                                      base::UpAxis up) {
    const base::Box3f box = render::framedBox(model);
    if (!options.view.empty() && !options.eye.empty())
        throw UsageError("--view and --eye both say where the eye is");
    const auto saved = savedCamera(options.view, sized(options), box, origin);
    if (saved && (!options.target.empty() || !options.up.empty() || !options.ortho.empty() || options.fovDeg > 0))
        throw UsageError("--view '" + options.view + "' was saved whole: leave out --target, --up, --fov and --ortho");
    const base::UpRow* asked = axisOf(options.up);
    render::Camera camera = saved ? *saved : directed(options, box, asked ? asked->axis : up);
    const bool told = !options.eye.empty() || !options.target.empty(), free = !saved && !told;
    if (told) {
        Vec3d eye, target;
        const Vec3d back = camera.eye - camera.target;
        camera.target = !options.target.empty() && parseVector(options.target, target)
                            ? target - origin
                            : base::cast<double>(box.centre());
        camera.eye = !options.eye.empty() && parseVector(options.eye, eye) ? eye - origin : camera.target + back;
        if (camera.eye == camera.target)
            throw UsageError("--eye and --target are the same place");
    }
    const bool fits = options.ortho.empty() || options.ortho == "fit";
    if (!options.ortho.empty()) {
        render::Camera parallel = camera;
        parallel.orthoHeight = 1;
        if (fits)
            camera.orthoHeight = closeUp(parallel, model).orthoHeight;
        else
            parseHeight(options.ortho, camera.orthoHeight);
    }
    if (options.clips.size() > render::ClipPlanes::most)
        throw UsageError("--clip can be given at most " + std::to_string(render::ClipPlanes::most) + " times");
    for (const std::string& clip : options.clips)
        camera.clips.add(planeOf(clip, origin));
    if (options.turntable == 0) {
        if (free)
            camera = fits ? closeUp(camera, model) : centred(camera, model);
        return {camera};
    }
    if (free)
        camera = fits ? framedForTurns(camera, model, options.turntable) : centredForTurns(camera, model);
    std::vector<render::Camera> out;
    for (int k = 0; k < options.turntable; ++k) {
        out.push_back(turnedAbout(camera, camera.upright(), 2 * std::numbers::pi * k / options.turntable));
        if (options.eye.empty()) // an eye that was told stays where it is
            out.back() = out.back().before(box);
    }
    return out;
}

std::string numberedPath(const std::string& path, int k, int n) {
    if (n <= 1)
        return path;
    const std::filesystem::path whole(path);
    const int digits = std::max<int>(3, static_cast<int>(std::to_string(n - 1).size()));
    char number[32];
    std::snprintf(number, sizeof number, "-%0*d", digits, k);
    return (whole.parent_path() / (whole.stem().string() + number + whole.extension().string())).string();
}

} // namespace app
