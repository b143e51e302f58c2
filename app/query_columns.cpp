#include "app/query_columns.h"

#include "app/subcommands/subcommand.h"
#include "core/base/near_word.h"
#include "core/base/row_of_id.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace app {

using base::Vec3d;
using surface::Need;
using surface::Projector;
using surface::Status;

bool valid(Status status) {
    return status == Status::Ok || status == Status::BeyondBoundary;
}

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Vec3d nanVector{nan, nan, nan};

Vec3d vectorOf(const Answer& a, const Vec3d& v) {
    return valid(a.at.status) ? v : nanVector;
}

double numberOf(const Answer& a, double value) {
    return valid(a.at.status) ? value : nan;
}

void writeCurvature(CsvWriter& out, const Answer& a, const Vec3d&) {
    out.number(numberOf(a, a.curvature.k1)).number(numberOf(a, a.curvature.k2));
    out.vector(vectorOf(a, a.curvature.direction1)).vector(vectorOf(a, a.curvature.direction2));
}

void writeFoot(CsvWriter& out, const Answer& a, const Vec3d& origin) {
    out.place(valid(a.projection.status) ? a.projection.foot + origin : nanVector);
    out.integer(a.projection.iterations);
}

} // namespace

std::span<const WhatRow> whatTable() {
    constexpr const char* foot = "px,py,pz,iterations";
    static constexpr WhatRow rows[] = {
        {"value",
         "f",
         "signed distance to the local plane",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.number(numberOf(a, a.at.value)); }},
        {"centroid",
         "cx,cy,cz",
         "weighted mean of the points",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d& origin) { out.place(vectorOf(a, a.at.centroid + origin)); }},
        {"normal",
         "nx,ny,nz",
         "normal of the local plane",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.vector(vectorOf(a, a.at.normal)); }},
        {"gradient",
         "gx,gy,gz",
         "gradient of f",
         {},
         Need::Gradient,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.vector(vectorOf(a, a.at.gradient)); }},
        {"off-centre",
         "o",
         "distance to the centroid",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.number(numberOf(a, a.at.offCentre)); }},
        {"curvature",
         "k1,k2,d1x,d1y,d1z,d2x,d2y,d2z",
         "principal curvatures of the level set, and directions",
         {},
         Need::Hessian,
         writeCurvature},
        {"tangent",
         "tx,ty,tz",
         "unit tangent of a curve",
         {},
         Need::Gradient,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.vector(vectorOf(a, a.tangent)); },
         Asks::Curve},
        {"curvature-vector",
         "kx,ky,kz",
         "curvature vector of a curve, towards its centre of curvature",
         {},
         Need::Hessian,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.vector(vectorOf(a, a.curvatureVector)); },
         Asks::Curve},
        {"project-basic", foot, "a nearby point of the surface", Projector::Basic, Need::Value, writeFoot},
        {"project-almost", foot, "a point of the surface along its plane's normal", Projector::Almost, Need::Value,
         writeFoot},
        {"project-orthogonal", foot, "a closest point of the surface", Projector::Orthogonal, Need::Value, writeFoot},
        {"agreement",
         "agreement",
         "length of the mean normal: 1 on one flat sheet, 0 where normals cancel",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.number(numberOf(a, a.at.agreement)); },
         Asks::Surface},
        {"cause",
         "cause",
         "why there is no answer",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.word(surface::causeName(a.at.cause)); }},
        {"cell",
         "cell",
         "number of the cell that the position belongs to, 0 of a model without cells; -1 where there is none",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) {
             out.integer(a.cell == cells::noCell ? -1 : static_cast<long long>(a.cell));
         },
         Asks::Cells},
        {"feature",
         "feature",
         "what the closest point of the surface lies on: face, seam, corner, or none",
         {},
         Need::Value,
         [](CsvWriter& out, const Answer& a, const Vec3d&) { out.word(cells::featureName(a.feature)); },
         Asks::Cells},
    };
    return rows;
}

std::string Question::header() const {
    std::string out = "x,y,z,status";
    for (const WhatRow* row : rows)
        out += std::string(",") + row->columns;
    return out + "\n";
}

void Question::check(surface::Manifold manifold, bool complex) const {
    const Asks wrong = manifold == surface::Manifold::Curve ? Asks::Surface : Asks::Curve;
    for (const WhatRow* row : rows)
        if (row->of == wrong || (row->of == Asks::Cells && wrong == Asks::Surface && !complex))
            throw UsageError("--what: " + std::string(row->id) +
                             (wrong == Asks::Curve ? " is for curves (--manifold curve)" : " is for surfaces"));
}

Status Question::status(const Answer& answer) const {
    if (evaluates && answer.at.status != Status::Ok)
        return answer.at.status;
    return projector ? answer.projection.status : answer.at.status;
}

static std::vector<std::string> wordsOf(const std::string& list) {
    std::vector<std::string> out;
    std::istringstream in(list);
    for (std::string word; std::getline(in, word, ',');)
        out.push_back(word);
    return out;
}

static void checkKnown(const std::vector<std::string>& asked) {
    for (const std::string& word : asked)
        if (!base::findRow(whatTable(), word))
            throw UsageError(
                "--what: unknown '" + word + "'; " +
                base::didYouMeanOr(word, base::joinedIds(whatTable()), "known are " + base::joinedIds(whatTable())));
}

Question parseQuestion(const std::string& list) {
    const std::vector<std::string> asked = wordsOf(list);
    checkKnown(asked);
    Question out;
    for (const WhatRow& row : whatTable()) {
        if (std::find(asked.begin(), asked.end(), row.id) == asked.end())
            continue;
        if (row.projector && out.projector)
            throw UsageError("--what: ask for one projection at a time");
        out.rows.push_back(&row);
        out.evaluates |= !row.projector;
        out.need = std::max(out.need, row.need);
        out.curvature |= row.need == Need::Hessian;
        if (row.projector)
            out.projector = row.projector;
        out.feature |= std::string_view(row.id) == "feature";
    }
    if (out.rows.empty())
        throw UsageError("--what: name at least one quantity");
    return out;
}

} // namespace app
