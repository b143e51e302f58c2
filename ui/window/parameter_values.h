// What stands in the fields of a command's dialog as text: what it means, which fields take places of the picture, and
// what fits the model where something must be given.
#pragma once

#include "core/base/plane.h"
#include "core/session/command.h"
#include "ui/work/snapshot.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <QString>

namespace ui {

/// It may be left out.
bool isOptional(const session::CommandParameter& p);
/// Its default; "" where it has none.
QString fallbackOf(const session::CommandParameter& p);
/// A place of the model, or several ("1,0,0; 2,0,0").
bool isPlace(const session::CommandParameter& p);
bool isPlaces(const session::CommandParameter& p);
/// A direction: across the surface where somebody clicks.
bool isDirection(const session::CommandParameter& p);
bool isFile(const session::CommandParameter& p);

/// "1, 2.5, -3": to a hundred-thousandth of `size`, such as the model's.
QString textOf(const base::Vec3d& place, double size = 1);
/// Throws base::Error for what is no number where there must be one.
nlohmann::json valueOf(const session::CommandParameter& p, const QString& text);
/// For what must be given, alone or instead of others: a round number that suits the model's size, a plane (in the
/// file's coordinates; without one, through the model's middle). "": nothing is proposed.
QString proposalFor(const session::CommandRow& row, const session::CommandParameter& p, const Snapshot& model,
                    const std::optional<base::Plane>& plane);

} // namespace ui
