#include "core/tree/select.h"

#include <algorithm>

namespace tree {

namespace {

struct Less {
    std::size_t axis;
    bool operator()(const CutItem& a, const CutItem& b) const {
        const float p = a.position[axis], q = b.position[axis];
        return bool(int(p < q) | (int(p == q) & int(a.source < b.source))); // no branch to mispredict
    }
};

const CutItem& medianOf(const CutItem& a, const CutItem& b, const CutItem& c, const Less& less) {
    if (less(a, b))
        return less(b, c) ? b : less(a, c) ? c : a;
    return less(a, c) ? a : less(b, c) ? c : b;
}

/// Moves what is less than the pivot to the front and returns its number (Lomuto's scheme, every step the same).
std::size_t splitBy(const CutItem& pivot, std::span<CutItem> items, const Less& less) {
    std::size_t front = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const CutItem item = items[i];
        items[i] = items[front];
        items[front] = item;
        front += less(item, pivot);
    }
    return front;
}

} // namespace

void selectSmallest(std::span<CutItem> items, std::size_t middle, std::size_t axis) {
    const Less less{axis};
    for (int rounds = 0; items.size() > 24 && rounds < 40; ++rounds) {
        if (middle == 0 || middle >= items.size())
            return;
        const std::size_t n = items.size();
        const CutItem pivot = medianOf(items[n / 4], items[n / 2], items[n - 1 - n / 4], less);
        const std::size_t front = splitBy(pivot, items, less); // 1 to n - 1: a median of three is no extreme
        if (middle <= front) {
            items = items.first(front);
        } else {
            items = items.subspan(front);
            middle -= front;
        }
    }
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(std::min(middle, items.size())),
                     items.end(), less);
}

} // namespace tree
