// What is known of the pixels of one view: the rays cast so far, and which pixels need none. The lattice extends beyond
// the right and the lower edge of the image to whole start cells. One thread writes, any number read.
#pragma once

#include "core/base/parallel.h"
#include "core/raycast/cast_pixels.h"

namespace raycast {

class Lattice {
  public:
    /// Forgets everything.
    void reset(int columns, int rows) {
        m_columns = columns, m_rows = rows;
        m_code.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), unknown);
        m_rays.clear();
    }
    int columns() const { return m_columns; }
    int rows() const { return m_rows; }

    /// Neither a ray nor anything else is known.
    bool open(Pixel p) const { return code(p) == unknown; }
    /// The pixel's own ray; null where none was cast.
    const Sample* ray(Pixel p) const {
        const std::uint32_t c = code(p);
        return c < firstRay ? nullptr : &m_rays[c - firstRay];
    }
    /// Was its sample redrawn from earlier views? The picture has it.
    bool redrawn(Pixel p) const { return code(p) >= firstRedrawn && code(p) < asked; }
    /// 0 for rays, 1 for what was redrawn from rays, and so on.
    int generation(Pixel p) const { return redrawn(p) ? static_cast<int>(code(p) - firstRedrawn) + 1 : 0; }
    bool background(Pixel p) const { return code(p) == empty; }

    /// From any thread, other pixels than other threads. REQUIRES: 1 <= generation <= mostGenerations.
    void setRedrawn(Pixel p, int generation) { code(p) = firstRedrawn + static_cast<std::uint32_t>(generation) - 1; }
    void setBackground(Pixel p) { code(p) = empty; }
    static constexpr int mostGenerations = 3;
    /// Marks an open pixel as asked for: not open any more. Either set() or reopen() follows.
    void ask(Pixel p) { code(p) = asked; }
    void reopen(Pixel p) { code(p) = unknown; }
    void set(Pixel p, const Sample& sample) {
        code(p) = firstRay + static_cast<std::uint32_t>(m_rays.size());
        m_rays.push_back(sample);
    }

    /// Opens the pixels that fn(pixel) is true of. In parallel; their rays stay in memory until `reset`.
    template <class Fn>
    void forget(const Fn& fn) {
        base::parallelFor(static_cast<std::size_t>(m_rows), 16, [&](std::size_t row) {
            for (Pixel p{0, static_cast<int>(row)}; p.column < m_columns; ++p.column)
                if (fn(p))
                    code(p) = unknown;
        });
    }

  private:
    static constexpr std::uint32_t unknown = 0, empty = 1, firstRedrawn = 2, asked = firstRedrawn + mostGenerations,
                                   firstRay = asked + 1;

    std::uint32_t code(Pixel p) const { return m_code[index(p)]; }
    std::uint32_t& code(Pixel p) { return m_code[index(p)]; }
    std::size_t index(Pixel p) const {
        return static_cast<std::size_t>(p.row) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(p.column);
    }

    int m_columns = 0, m_rows = 0;
    std::vector<std::uint32_t> m_code;
    std::vector<Sample> m_rays;
};

} // namespace raycast
