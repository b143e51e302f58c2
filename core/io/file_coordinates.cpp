#include "core/io/file_coordinates.h"

#include "core/base/parallel.h"

#include <atomic>
#include <bit>

namespace io {

bool coordinatesAreExact(const FileModel& model) {
    if (!hasOrigin(model))
        return true;
    std::atomic<bool> exact = true;
    base::parallelChunks(model.points.size(), 1 << 14, [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end && exact.load(std::memory_order_relaxed); ++i) {
            const base::Vec3d stated = fileCoordinates(model, i);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto read = static_cast<float>(stated[k] - model.origin[k]);
                const float own = model.points.items[i].position[k];
                if (std::bit_cast<std::uint32_t>(read) != std::bit_cast<std::uint32_t>(own))
                    exact = false;
            }
        }
    });
    return exact;
}

} // namespace io
