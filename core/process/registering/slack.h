// Whether models are held where registration left them: on spheres, cylinders, planes and other shapes that slide along
// themselves one place is as good as the next (process/README 13.3). Inside this folder.
#pragma once

#include "core/process/registering/motions.h"

namespace process {

/// Moves models by `size` as their pairs resist least, either way: those that then lie on the others as well as before
/// are not held. Their poses stay.
void lookForSlack(std::vector<Placed>& models, const std::vector<AskedPoints>& asked, const MotionEquations& equations,
                  double size, double reach);

} // namespace process
