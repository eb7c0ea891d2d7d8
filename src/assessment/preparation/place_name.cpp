// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/place_name.h"

#include <array>
#include <cmath>

#include "assessment/messages.h"

namespace tactooth {
namespace {

constexpr double kMiddle = 0.3;       // mm: nearer places have no side
constexpr double kDiagonal = 0.4142;  // tan 22.5 degrees: between two of eight directions

/// In the order: middle, then by the sign of the first direction (0, +, -) and of the second one.
using Names = std::array<std::array<const MessageText*, 3>, 3>;
constexpr Names kOcclusal = {{{&msg::kPlaceMiddle, &msg::kPlaceBuccal, &msg::kPlaceLingual},
                              {&msg::kPlaceMesial, &msg::kPlaceMesiobuccal, &msg::kPlaceMesiolingual},
                              {&msg::kPlaceDistal, &msg::kPlaceDistobuccal, &msg::kPlaceDistolingual}}};
constexpr Names kFromTheSide = {{{&msg::kPlaceMiddle, &msg::kPlaceOcclusal, &msg::kPlaceGingival},
                                 {&msg::kPlaceMesial, &msg::kPlaceMesioOcclusal, &msg::kPlaceMesiogingival},
                                 {&msg::kPlaceDistal, &msg::kPlaceDistoOcclusal, &msg::kPlaceDistogingival}}};
constexpr Names kApproximal = {{{&msg::kPlaceMiddle, &msg::kPlaceOcclusal, &msg::kPlaceGingival},
                                {&msg::kPlaceBuccal, &msg::kPlaceBuccoOcclusal, &msg::kPlaceBuccogingival},
                                {&msg::kPlaceLingual, &msg::kPlaceLinguoOcclusal, &msg::kPlaceLinguogingival}}};

std::size_t signIndex(double along, double other) {
    if (std::abs(along) < kDiagonal * std::abs(other)) return 0;
    return along > 0 ? 1 : 2;
}

}  // namespace

const MessageText& placeName(const Vec3& place, const Vec3& middle, const DentalDirections& to) {
    const Vec3 level = place - middle - to.axis.dot(place - middle) * to.axis;
    if (level.norm() < kMiddle) return msg::kPlaceMiddle;
    const Vec3 up = Vec3::UnitZ() - to.axis.z() * to.axis;
    const bool isOcclusal = to.hasMesial && to.hasBuccal;
    const double first = level.dot(to.hasMesial ? to.mesial : to.buccal);
    const double second = level.dot(isOcclusal ? to.buccal : up);
    const Names& names = isOcclusal ? kOcclusal : to.hasMesial ? kFromTheSide : kApproximal;
    return *names[signIndex(first, second)][signIndex(second, first)];
}

}  // namespace tactooth
