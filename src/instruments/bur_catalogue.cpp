// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// Diameters and head lengths: the textbook table of US numbers (the makers' measure where the two differ, as for
// No. 330) and the ISO 6360 sizes of diamonds. Where the table gives no head length, it is in proportion to that of
// the nearest size which has one. ISO shape numbers as the makers print them.
#include "instruments/bur_catalogue.h"

#include <array>
#include <charconv>

#include "instruments/messages.h"

namespace tactooth {
namespace {

using enum BurKind;

constexpr double kMediumGrit = 107;  // um, ISO 6360 code 524
constexpr int kOperativeBlades = 6, kLargeRoundBlades = 8, kFinishingBlades = 12;

/// "Round diamond 801-014, 1.4 mm".
Message titleOf(const MessageText& row, const MessageText& shape, const char* number, double diameter) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.begin(), digits.end(), diameter, std::chars_format::fixed, 1).ptr;
    return {row, shape, number, std::string(digits.begin(), end) + " mm"};
}

BurSpec carbide(const char* number, const MessageText& shape, BurKind kind, int iso, double diameter, double length,
                double taper = 0, int flutes = kOperativeBlades) {
    BurSpec spec;
    spec.number = number;
    spec.title = titleOf(msg::kCarbideBur, shape, number, diameter);
    spec.name = spec.title.in(Language::English);
    spec.kind = kind;
    spec.isoShape = iso;
    spec.headDiameter = diameter;
    spec.headLength = length;
    spec.taperDegrees = taper;
    spec.flutes = flutes;
    return spec;
}

BurSpec crossCut(BurSpec spec) {
    spec.crossCut = true;
    return spec;
}

BurSpec diamond(const char* number, const MessageText& shape, BurKind kind, int iso, double diameter, double length,
                double taper = 0) {
    BurSpec spec = carbide(number, shape, kind, iso, diameter, length, taper, 0);
    spec.title = titleOf(msg::kDiamondBur, shape, number, diameter);
    spec.name = spec.title.in(Language::English);
    spec.material = BurMaterial::Diamond;
    spec.gritMicrometres = kMediumGrit;
    return spec;
}

void addRoundCarbides(std::vector<BurSpec>& list) {
    const MessageText& shape = msg::kBurRound;
    list.push_back(carbide("1/4", shape, Round, 1, 0.5, 0.40));
    list.push_back(carbide("1/2", shape, Round, 1, 0.6, 0.48));
    list.push_back(carbide("1", shape, Round, 1, 0.8, 0.63));
    list.push_back(carbide("2", shape, Round, 1, 1.0, 0.80));
    list.push_back(carbide("3", shape, Round, 1, 1.2, 0.95));
    list.push_back(carbide("4", shape, Round, 1, 1.4, 1.10));
    list.push_back(carbide("5", shape, Round, 1, 1.6, 1.26));
    list.push_back(carbide("6", shape, Round, 1, 1.8, 1.45, 0, kLargeRoundBlades));
    list.push_back(carbide("7", shape, Round, 1, 2.1, 1.66, 0, kLargeRoundBlades));
    list.push_back(carbide("8", shape, Round, 1, 2.3, 1.82, 0, kLargeRoundBlades));
}

void addConesAndPears(std::vector<BurSpec>& list) {
    const MessageText& cone = msg::kBurInvertedCone;
    list.push_back(carbide("33-1/2", cone, InvertedCone, 10, 0.6, 0.45, -12));
    list.push_back(carbide("34", cone, InvertedCone, 10, 0.8, 0.60, -12));
    list.push_back(carbide("35", cone, InvertedCone, 10, 1.0, 0.75, -12));
    list.push_back(carbide("36", cone, InvertedCone, 10, 1.2, 0.90, -12));
    list.push_back(carbide("37", cone, InvertedCone, 10, 1.4, 1.05, -12));
    list.push_back(carbide("39", cone, InvertedCone, 10, 1.8, 1.35, -12));
    list.push_back(carbide("329", msg::kBurPear, Pear, 232, 0.7, 1.4, -8));
    list.push_back(carbide("330", msg::kBurPear, Pear, 232, 0.8, 1.6, -8));
    list.push_back(carbide("331", msg::kBurPear, Pear, 232, 1.0, 2.0, -8));
    list.push_back(carbide("332", msg::kBurPear, Pear, 232, 1.2, 2.4, -8));
    list.push_back(carbide("245", msg::kBurLongPear, Pear, 234, 0.8, 2.7, -4));
}

void addStraightFissures(std::vector<BurSpec>& list) {
    const MessageText &plain = msg::kBurStraightFissure, &cross = msg::kBurCrossCutStraightFissure;
    list.push_back(carbide("55", plain, StraightFissure, 107, 0.8, 3.6));
    list.push_back(carbide("56", plain, StraightFissure, 107, 0.9, 3.8));
    list.push_back(carbide("57", plain, StraightFissure, 107, 1.0, 4.2));
    list.push_back(carbide("58", plain, StraightFissure, 107, 1.2, 4.2));
    list.push_back(carbide("59", plain, StraightFissure, 107, 1.4, 4.2));
    list.push_back(carbide("60", plain, StraightFissure, 107, 1.6, 4.2));
    list.push_back(crossCut(carbide("555", cross, StraightFissure, 107, 0.8, 3.6)));
    list.push_back(crossCut(carbide("556", cross, StraightFissure, 107, 0.9, 3.8)));
    list.push_back(crossCut(carbide("557", cross, StraightFissure, 107, 1.0, 4.2)));
    list.push_back(crossCut(carbide("558", cross, StraightFissure, 107, 1.2, 4.2)));
    list.push_back(crossCut(carbide("559", cross, StraightFissure, 107, 1.4, 4.2)));
    list.push_back(crossCut(carbide("560", cross, StraightFissure, 107, 1.6, 4.2)));
    list.push_back(carbide("1156", msg::kBurDomeEndFissure, DomeFissure, 137, 0.9, 3.8));
    list.push_back(carbide("1157", msg::kBurDomeEndFissure, DomeFissure, 137, 1.0, 4.2));
    list.push_back(carbide("1158", msg::kBurDomeEndFissure, DomeFissure, 137, 1.2, 4.2));
}

void addTaperedFissures(std::vector<BurSpec>& list) {
    const MessageText &plain = msg::kBurTaperedFissure, &cross = msg::kBurCrossCutTaperedFissure;
    list.push_back(carbide("169", plain, TaperedFissure, 168, 0.9, 4.3, 6));
    list.push_back(carbide("169L", msg::kBurLongTaperedFissure, TaperedFissure, 171, 0.9, 5.6, 4));
    list.push_back(carbide("170", plain, TaperedFissure, 168, 1.0, 4.3, 6));
    list.push_back(carbide("171", plain, TaperedFissure, 168, 1.2, 4.3, 6));
    list.push_back(crossCut(carbide("699", cross, TaperedFissure, 168, 0.9, 4.2, 6)));
    list.push_back(crossCut(carbide("700", cross, TaperedFissure, 168, 1.0, 4.2, 6)));
    list.push_back(crossCut(carbide("701", cross, TaperedFissure, 168, 1.2, 4.2, 6)));
    list.push_back(crossCut(carbide("702", cross, TaperedFissure, 168, 1.6, 4.5, 6)));
    list.push_back(crossCut(carbide("703", cross, TaperedFissure, 168, 2.1, 4.8, 6)));
    list.push_back(carbide("271", msg::kBurRoundEndTaperedFissure, RoundEndTaper, 194, 1.2, 4.0, 6));
    list.push_back(carbide("272", msg::kBurRoundEndTaperedFissure, RoundEndTaper, 194, 1.6, 5.0, 6));
    list.push_back(carbide("1169", msg::kBurDomeEndTaperedFissure, RoundEndTaper, 195, 0.9, 4.3, 6));
    list.push_back(carbide("1170", msg::kBurDomeEndTaperedFissure, RoundEndTaper, 195, 1.0, 4.3, 6));
    list.push_back(carbide("1171", msg::kBurDomeEndTaperedFissure, RoundEndTaper, 195, 1.2, 4.3, 6));
}

void addFinishingCarbides(std::vector<BurSpec>& list) {
    list.push_back(carbide("7006", msg::kBurBallFinishing, Round, 1, 1.8, 1.42, 0, kFinishingBlades));
    list.push_back(carbide("7404", msg::kBurEggFinishing, Football, 277, 1.4, 3.5, 0, kFinishingBlades));
    list.push_back(carbide("7901", msg::kBurNeedleFinishing, Needle, 164, 0.9, 3.5, 0, kFinishingBlades));
}

void addDiamonds(std::vector<BurSpec>& list) {
    list.push_back(diamond("801-010", msg::kBurRound, Round, 1, 1.0, 0.86));
    list.push_back(diamond("801-014", msg::kBurRound, Round, 1, 1.4, 1.20));
    list.push_back(diamond("801-018", msg::kBurRound, Round, 1, 1.8, 1.54));
    list.push_back(diamond("801-023", msg::kBurRound, Round, 1, 2.3, 1.97));
    list.push_back(diamond("805-014", msg::kBurInvertedCone, InvertedCone, 10, 1.4, 1.05, -12));
    list.push_back(diamond("830-012", msg::kBurPear, Pear, 237, 1.2, 2.7, -6));
    list.push_back(diamond("836-012", msg::kBurFlatEndCylinder, StraightFissure, 110, 1.2, 6.0));
    list.push_back(diamond("837-012", msg::kBurFlatEndCylinder, StraightFissure, 111, 1.2, 8.0));
    list.push_back(diamond("881-012", msg::kBurRoundEndCylinder, DomeFissure, 141, 1.2, 8.0));
    list.push_back(diamond("847-016", msg::kBurFlatEndTaper, TaperedFissure, 172, 1.6, 8.0, 5));
    list.push_back(diamond("856-016", msg::kBurRoundEndTaper, RoundEndTaper, 198, 1.6, 8.0, 5));
    list.push_back(diamond("856-018", msg::kBurRoundEndTaper, RoundEndTaper, 198, 1.8, 8.0, 6));
    list.push_back(diamond("858-014", msg::kBurNeedle, Needle, 165, 1.4, 8.0));
    list.push_back(diamond("862-012", msg::kBurFlame, Flame, 249, 1.2, 8.0));
    list.push_back(diamond("863-016", msg::kBurFlame, Flame, 250, 1.6, 8.0));
    list.push_back(diamond("379-018", msg::kBurFootball, Football, 277, 1.8, 3.5));
    list.push_back(diamond("379-023", msg::kBurFootball, Football, 277, 2.3, 4.2));
    list.push_back(diamond("877-010", msg::kBurTorpedo, Torpedo, 288, 1.0, 8.0));
    list.push_back(diamond("877-012", msg::kBurTorpedo, Torpedo, 288, 1.2, 8.0));
    list.push_back(diamond("878K-016", msg::kBurTorpedoTaper, Torpedo, 298, 1.6, 8.0, 4));
    list.push_back(diamond("909-040", msg::kBurWheel, Wheel, 68, 4.0, 1.5));
}

}  // namespace

const std::vector<BurSpec>& burCatalogue() {
    static const std::vector<BurSpec> catalogue = [] {
        std::vector<BurSpec> list;
        addRoundCarbides(list);
        addConesAndPears(list);
        addStraightFissures(list);
        addTaperedFissures(list);
        addFinishingCarbides(list);
        addDiamonds(list);
        return list;
    }();
    return catalogue;
}

}  // namespace tactooth
