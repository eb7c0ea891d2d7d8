// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// An edge that is almost horizontal (or vertical) is a row of steps in the picture. The straight line that it stands
// for passes through the middles of the steps. The share of the neighbour is the part of the pixel beyond that line: A.
// Reshetov, Morphological antialiasing, HPG 2009. The ends of a step are found by the mean brightness of the two rows
// along it: T. Lottes, FXAA, NVIDIA 2009.
#include "view/passes/edge_smoothing.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "geometry/util/assert.h"

namespace tactooth {
namespace {

using Brightness = std::uint8_t;

constexpr Brightness kLeast = 20;  // difference that is an edge: the grain of tissues stays below it
constexpr int kReach = 12;         // pixels along a step to each side

/// Of the display values, 0..255. The compiler turns loops over arrays of bytes, without any other memory, into vector
/// instructions; so here and in `mark`.
void measureBrightness(std::span<const Rgba> colours, Brightness* brightness) {
    for (const Rgba& colour : colours) {
        *brightness++ = static_cast<Brightness>((2 * colour[0] + 5 * colour[1] + colour[2]) / 8);
    }
}

struct Change {
    std::size_t place;
    Rgba colour;
};

/// Where a step ends to one side.
struct End {
    int pixels;  ///< from the pixel in question to the end, this pixel included
    int change;  ///< by which both rows together are brighter behind the end; 0 if it is too far away
};

/// What is known of the pixel `here` of the brightness.
struct Step {
    const Brightness* here;
    std::ptrdiff_t along;   ///< from a pixel to the next one along the edge
    std::ptrdiff_t across;  ///< from the pixel to its neighbour beyond the edge
};

End endOf(const Step& step, std::ptrdiff_t along, int reach) {
    const int both = step.here[0] + step.here[step.across];
    const int contrast = std::abs(step.here[0] - step.here[step.across]);
    const Brightness* place = step.here;
    for (int i = 1; i <= reach; ++i) {
        place += along;
        const int change = place[0] + place[step.across] - both;
        if (2 * std::abs(change) >= contrast) return {i, change};
    }
    return {reach + 1, 0};
}

/// The direction of the edge is that along which the brightness is straighter.
Step stepAt(const Brightness* here, std::ptrdiff_t row) {
    const auto bend = [&](std::ptrdiff_t place, std::ptrdiff_t to) {
        return std::abs(here[place - to] + here[place + to] - 2 * here[place]);
    };
    const int acrossRows = bend(-1, row) + 2 * bend(0, row) + bend(1, row);
    const int acrossColumns = bend(-row, 1) + 2 * bend(0, 1) + bend(row, 1);
    const bool isHorizontal = acrossRows >= acrossColumns;
    const std::ptrdiff_t across = isHorizontal ? row : 1;
    const bool isBefore = std::abs(here[-across] - *here) > std::abs(here[across] - *here);
    return {here, isHorizontal ? 1 : row, isBefore ? -across : across};
}

/// Whether the brightness changes as much before the pixel as behind it, as at the bend of a shiny surface.
bool isGradient(const Step& step) {
    const int toBeyond = step.here[step.across] - step.here[0];
    const int toOther = step.here[-step.across] - step.here[0];
    return 2 * std::abs(toBeyond + toOther) < std::abs(toBeyond);
}

/// The part of the pixel beyond the line. From half a pixel at each end of the step, the depth of the line falls to
/// zero in the middle. It runs through this row only from ends behind which the colour from beyond goes on in it.
float shareBeyond(const Step& step, const End& before, const End& after) {
    const int toBeyond = step.here[step.across] - step.here[0];
    const float whole = static_cast<float>(before.pixels + after.pixels - 1);
    float area = 0;
    for (const End& end : {before, after}) {
        if (end.change == 0 || (end.change > 0) != (toBeyond > 0)) continue;
        const float fromMiddle = std::max(0.5F * whole - static_cast<float>(end.pixels), 0.0F);
        const float toEnd = std::max(0.5F * whole - static_cast<float>(end.pixels) + 1, 0.0F);
        area += toEnd * toEnd - fromMiddle * fromMiddle;
    }
    return area / (2 * whole);
}

Rgba mixed(const Rgba& colour, const Rgba& other, float share) {
    Rgba result;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const float from = colour[i], to = other[i];
        result[i] = static_cast<std::uint8_t>(from + share * (to - from) + 0.5F);
    }
    return result;
}

/// Where the pixels of `row` differ from a neighbour, other than the first and the last of its `width`: 1, or 0.
void mark(const Brightness* row, std::ptrdiff_t width, std::uint8_t* marks) {
    const Brightness *below = row - width, *above = row + width;
    for (std::ptrdiff_t x = 1; x < width - 1; ++x) {
        const Brightness here = row[x];
        const Brightness most = std::max(std::max(row[x - 1], row[x + 1]), std::max(below[x], above[x]));
        const Brightness least = std::min(std::min(row[x - 1], row[x + 1]), std::min(below[x], above[x]));
        const auto brighter = static_cast<Brightness>(std::max(most, here) - here);
        const auto darker = static_cast<Brightness>(here - std::min(least, here));
        marks[x] = std::max(brighter, darker) >= kLeast ? 1 : 0;
    }
}

class Smoothing {
public:
    Smoothing(std::span<Rgba> picture, ImageSize size)
        : picture_(picture),
          width_(static_cast<std::size_t>(size.width)),
          height_(static_cast<std::size_t>(size.height)),
          brightness_(std::make_unique_for_overwrite<Brightness[]>(picture.size())) {}

    ChangedRows run() {
        measureBrightness(picture_, brightness_.get());
        findChanges();
        for (const Change& change : changes_) picture_[change.place] = change.colour;
        if (changes_.empty()) return {};
        const auto rowOf = [&](const Change& change) { return static_cast<int>(change.place / width_); };
        return {rowOf(changes_.front()), rowOf(changes_.back()) + 1};
    }

private:
    /// Row by row.
    void findChanges() {
        std::vector<std::uint8_t> marks(width_);
        const std::uint8_t* const past = marks.data() + marks.size();
        const auto next = [&](const std::uint8_t* from) {
            return static_cast<const std::uint8_t*>(std::memchr(from, 1, static_cast<std::size_t>(past - from)));
        };
        for (std::size_t y = 1; y < height_ - 1; ++y) {
            mark(&brightness_[y * width_], static_cast<std::ptrdiff_t>(width_), marks.data());
            for (const std::uint8_t* at = next(marks.data()); at != nullptr; at = next(at + 1)) {
                smooth(static_cast<std::size_t>(at - marks.data()), y);
            }
        }
    }

    void smooth(std::size_t x, std::size_t y) {
        const std::size_t place = y * width_ + x;
        const Step step = stepAt(&brightness_[place], static_cast<std::ptrdiff_t>(width_));
        if (isGradient(step)) return;
        const bool isHorizontal = step.along == 1;
        const std::size_t before = isHorizontal ? x : y;
        const std::size_t after = (isHorizontal ? width_ : height_) - 1 - before;
        const auto reach = [](std::size_t pixels) { return static_cast<int>(std::min<std::size_t>(kReach, pixels)); };
        const float share =
            shareBeyond(step, endOf(step, -step.along, reach(before)), endOf(step, step.along, reach(after)));
        if (share == 0) return;
        const auto beyond = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place) + step.across);
        changes_.push_back({place, mixed(picture_[place], picture_[beyond], share)});
    }

    std::span<Rgba> picture_;
    std::size_t width_, height_;
    std::unique_ptr<Brightness[]> brightness_;
    std::vector<Change> changes_;  // all are found before the first one is made
};

}  // namespace

ChangedRows smoothEdges(std::span<Rgba> picture, ImageSize size) {
    TACTOOTH_ASSERT(picture.size() == static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    if (size.width < 3 || size.height < 3) return {};  // nothing but outermost pixels
    return Smoothing(picture, size).run();
}

}  // namespace tactooth
