#include "core/session/trajectory_file.h"

#include "core/io/named_rows.h"

namespace session {

using io::NamedColumns;
using io::NumberRow;

constexpr const char* placeForm = "each line holds the numbers that the header t,x,y,z names";
constexpr NamedColumns<4>::Names placeNames{"t", "x", "y", "z"};

static haptics::TimedPlace placeOf(const NumberRow& row, const NamedColumns<4>& columns,
                                   const haptics::Trajectory& before) {
    const auto v = columns.numbers(row, placeForm);
    const haptics::TimedPlace out{v[0], {v[1], v[2], v[3]}};
    if (!std::isfinite(out.time) || !base::isFinite(out.place))
        row.fail("the time and place are not finite", placeForm);
    if (!before.empty() && !(out.time > before.back().time))
        row.fail("the time is not later than that of the row before", "times must ascend");
    return out;
}

haptics::Trajectory readTrajectory(const io::FileBytes& file, const base::Progress& progress) {
    haptics::Trajectory out;
    io::forNamedRows<4>(
        file, progress, placeNames, "begin with t,x,y,z",
        [&](const NumberRow& row, const NamedColumns<4>& columns) { out.push_back(placeOf(row, columns, out)); });
    if (out.empty())
        file.fail("holds no places", "begin with t,x,y,z and give one place per line");
    return out;
}

} // namespace session
