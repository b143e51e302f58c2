// Handles that move, turn and scale, over the picture; nothing hides them.
#pragma once

#include "ui/view/placement.h"

#include <span>

class QPainter;

namespace ui {

/// In device pixels of `camera`'s image. `bright`: the one that the pointer is over or holds.
void paintHandles(QPainter& painter, std::span<const HandleShape> shapes, const std::optional<Handle>& bright,
                  const render::Camera& camera, double pixelRatio);

} // namespace ui
