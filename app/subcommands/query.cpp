// pointclay query: f, its derivatives and projections at positions, as CSV rows in their order.
#include "app/cell_answers.h"
#include "app/complex_answers.h"
#include "app/curve_answers.h"
#include "app/number_table.h"
#include "app/open_model.h"
#include "app/options/output_names.h"
#include "app/options/surface_options.h"
#include "app/query_columns.h"
#include "app/subcommands/subcommand.h"
#include "core/base/parallel.h"
#include "core/io/safe_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace app {

using base::Vec3d;
using base::Vec3f;
using surface::Need;
using surface::Surface;

namespace {

/// Rows answered, written and let go together.
constexpr std::size_t batchSize = 32768;

surface::Evaluationd widened(const surface::Evaluationf& e) {
    surface::Evaluationd out;
    out.status = e.status;
    out.value = e.value;
    out.centroid = base::cast<double>(e.centroid);
    out.normal = base::cast<double>(e.normal);
    out.gradient = base::cast<double>(e.gradient);
    out.offCentre = e.offCentre;
    out.agreement = e.agreement;
    out.cause = e.cause;
    return out;
}

void answerInDouble(const Surface& surface, const Question& question, std::span<const Vec3d> x, std::span<Answer> out) {
    base::parallelFor(x.size(), 16, [&](std::size_t i) {
        if (question.evaluates)
            out[i].at = surface.evaluateReference(x[i], question.need);
        if (question.projector)
            out[i].projection = projectReference(surface, x[i], {*question.projector});
    });
}

void answerInFloat(const Surface& surface, const Question& question, std::span<const Vec3d> x, std::span<Answer> out) {
    std::vector<Vec3f> near(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        near[i] = base::cast<float>(x[i]);
    if (question.evaluates) {
        std::vector<surface::Evaluationf> at(x.size());
        surface.evaluate(near, std::min(question.need, Need::Gradient), at);
        for (std::size_t i = 0; i < x.size(); ++i)
            out[i].at = widened(at[i]);
    }
    if (question.projector) {
        std::vector<surface::Projection<float>> feet(x.size());
        project(surface, near, {*question.projector}, feet);
        for (std::size_t i = 0; i < x.size(); ++i) {
            out[i].projection.status = feet[i].status;
            out[i].projection.foot = base::cast<double>(feet[i].foot);
            out[i].projection.iterations = feet[i].iterations;
        }
    }
}

void addCurvature(const Surface& surface, std::span<const Vec3d> x, bool inDouble, std::span<Answer> out) {
    if (inDouble) {
        base::parallelFor(x.size(), 16, [&](std::size_t i) { out[i].curvature = curvatureReference(surface, x[i]); });
        return;
    }
    std::vector<Vec3f> near(x.size());
    std::transform(x.begin(), x.end(), near.begin(), [](const Vec3d& each) { return base::cast<float>(each); });
    std::vector<surface::Curvature> found(x.size());
    curvature(surface, near, found);
    for (std::size_t i = 0; i < x.size(); ++i)
        out[i].curvature = found[i];
}

/// Without cells a surface is one, and all of it is face.
void answerAsOneCell(const Surface& surface, const Question& question, std::span<const Vec3d> x, bool inDouble,
                     std::span<Answer> out) {
    for (Answer& each : out)
        if (valid(each.at.status))
            each.cell = 0;
    if (!question.feature)
        return;
    std::vector<Answer> feet;
    if (question.projector != surface::Projector::Orthogonal) { // else they are known
        Question foot;
        foot.projector = surface::Projector::Orthogonal;
        feet.resize(x.size());
        (inDouble ? answerInDouble : answerInFloat)(surface, foot, x, feet);
    }
    for (std::size_t i = 0; i < x.size(); ++i)
        if ((feet.empty() ? out : std::span(feet))[i].projection.status == surface::Status::Ok)
            out[i].feature = cells::Feature::Face;
}

/// Answers at positions relative to the origin. What is not finite is nowhere: Status::Outside.
std::vector<Answer> answer(const Surface& surface, const CellAnswers* byCells, const complexes::Complex* complex,
                           const Question& question, std::span<const Vec3d> x, bool inDouble) {
    std::vector<std::size_t> places;
    std::vector<Vec3d> finite;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (base::isFinite(base::cast<float>(x[i]))) {
            places.push_back(i);
            finite.push_back(x[i]);
        }
    std::vector<Answer> found(finite.size()), out(x.size());
    const bool curve = surface.definition().manifold == surface::Manifold::Curve;
    if (complex)
        answerOnComplex(*complex, question, finite, found);
    else
        (curve ? answerOnCurve : inDouble ? answerInDouble : answerInFloat)(surface, question, finite, found);
    if (question.curvature && !curve && !complex)
        addCurvature(surface, finite, inDouble, found);
    if (byCells)
        byCells->answer(question, finite, found);
    else if (!curve && !complex)
        answerAsOneCell(surface, question, finite, inDouble, found);
    for (std::size_t k = 0; k < places.size(); ++k)
        out[places[k]] = found[k];
    return out;
}

struct QueryArguments {
    std::string model, points, what, out;
    std::shared_ptr<SurfaceOptions> surface;
};

void query(const QueryArguments& options, Console& console) {
    requireOutputs({{"-o", options.out}});
    requireInputsKept({{"-o", options.out}}, {options.model, options.points});
    const Question question = parseQuestion(options.what);
    session::Document document;
    const base::Progress progress = console.progress();
    session::Context context{document, {}, progress, {}, 0, {}, nullptr};
    const std::vector<Vec3d> points = readPoints(options.points, progress);
    openModel(context, options.model, options.surface->parameters(), console);
    const auto byCells = CellAnswers::of(document.surface(), question);
    const auto complex = complexes::Complex::of(document.surface());
    question.check(document.surface().definition().manifold, complex.has_value());
    const Vec3d origin = document.provenance().origin;

    io::SafeFile file(options.out);
    CsvWriter csv(options.surface->inDouble(), origin);
    file.write(question.header());
    for (std::size_t begin = 0; begin < points.size(); begin += batchSize) {
        progress.step(static_cast<double>(begin) / static_cast<double>(points.size()), "Evaluating");
        const std::size_t end = std::min(points.size(), begin + batchSize);
        std::vector<Vec3d> x(points.begin() + static_cast<std::ptrdiff_t>(begin),
                             points.begin() + static_cast<std::ptrdiff_t>(end));
        for (Vec3d& p : x)
            p -= origin;
        const std::vector<Answer> answers =
            answer(document.surface(), byCells ? &*byCells : nullptr, complex ? &*complex : nullptr, question, x,
                   options.surface->inDouble());
        for (std::size_t i = 0; i < answers.size(); ++i) {
            csv.place(points[begin + i]).word(surface::statusName(question.status(answers[i])));
            for (const WhatRow* row : question.rows)
                row->write(csv, answers[i], origin);
            csv.endRow();
        }
        file.write(csv.take());
    }
    file.commit();
}

std::string whatHelp() {
    std::string out = "comma-separated list of what to compute; the CSV has x,y,z,status and then, in this order,";
    for (const WhatRow& row : whatTable())
        out += std::string("\n  ") + row.id + ": " + row.tip + " (" + row.columns + ")";
    return out + R"(
  status: of the position or, where that is ok or was not asked for, of the projection; columns without an answer
  hold nan
    ok
    outside: no surfel has the position in its support, so that nothing but a projection is defined there
    degenerate: the surfels around it have no plane
    not-converged: a projection that led to no foot
    beyond-boundary: past the rim of an open surface; numbers are those of the surface carried on
  Projections start anywhere: outside of all supports at the nearest surfel, and at others around where that leads to
  a foot that is not the nearest. The farther away a position is, the more often two feet are as near as each other
  and none is found.)";
}

} // namespace

Action addQuery(OptionSet command) {
    auto options = std::make_shared<QueryArguments>();
    command.add("MODEL", options->model, modelHelp).required();
    command.add("--at", options->points, "positions: text with x y z per line, or any readable model")
        .typeName("POINTS")
        .required();
    command.add("--what", options->what, whatHelp()).typeName("LIST").required();
    command.add("-o,--output", options->out, "CSV file to write").typeName("OUT.csv").required();
    options->surface = addSurfaceOptions(command, true);
    return [options](Console& console) { query(*options, console); };
}

} // namespace app
