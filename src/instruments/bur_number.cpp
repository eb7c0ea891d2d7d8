// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// ISO 6360: groups of three digits for material, shank and length, shape, toothing or grit, and the largest diameter in
// tenths of a millimetre.
#include <algorithm>
#include <array>
#include <cmath>

#include "instruments/bur_catalogue.h"

namespace tactooth {
namespace {

constexpr int kCarbide = 500, kElectroplatedDiamond = 806;  // material groups
constexpr int kFrictionGrip = 314;                          // 1.6 mm shank, 19 mm long in all

// Toothing groups of carbides.
constexpr int kRoundToothing = 1, kPlainToothing = 6, kCrossCutToothing = 7, kFinishingToothing = 71;
constexpr int kFinishingBlades = 12;

/// A grit group and the mean grain that it stands for.
struct Grit {
    int code;
    double micrometres;
};
constexpr std::array<Grit, 6> kGrits = {{{494, 15}, {504, 30}, {514, 50}, {524, 107}, {534, 137}, {544, 180}}};

int gritCode(double micrometres) {
    const auto away = [&](const Grit& grit) { return std::abs(grit.micrometres - micrometres); };
    return std::ranges::min_element(kGrits, {}, away)->code;
}

int toothingCode(const BurSpec& spec) {
    if (spec.material == BurMaterial::Diamond) return gritCode(spec.gritMicrometres);
    if (spec.crossCut) return kCrossCutToothing;
    if (spec.flutes >= kFinishingBlades) return kFinishingToothing;
    return spec.kind == BurKind::Round || spec.kind == BurKind::InvertedCone ? kRoundToothing : kPlainToothing;
}

std::string threeDigits(long number) {
    const std::string digits = std::to_string(number);
    std::string padded(digits.size() < 3 ? 3 - digits.size() : 0, '0');
    return padded.append(digits);
}

std::string digitsOf(std::string_view text) {
    std::string digits;
    for (const char letter : text) {
        if (letter == ' ') continue;
        if (letter < '0' || letter > '9') return {};
        digits += letter;
    }
    return digits;
}

/// The ISO number's digits but for those of the grit, in which a diamond may differ from the catalogue.
std::string withoutGrit(const BurSpec& spec, std::string digits) {
    constexpr std::size_t kGritAt = 9, kGroup = 3;
    if (spec.material == BurMaterial::Diamond) digits.erase(kGritAt, kGroup);
    return digits;
}

std::optional<BurSpec> findByIso(const std::string& digits) {
    const std::string grit = digits.substr(9, 3);
    for (BurSpec spec : burCatalogue()) {
        if (withoutGrit(spec, digitsOf(isoNumber(spec))) != withoutGrit(spec, digits)) continue;
        if (spec.material == BurMaterial::Carbide) return spec;
        const auto known = std::ranges::find(kGrits, grit, [](const Grit& g) { return threeDigits(g.code); });
        if (known == kGrits.end()) return std::nullopt;
        spec.gritMicrometres = known->micrometres;
        return spec;
    }
    return std::nullopt;
}

}  // namespace

std::string isoNumber(const BurSpec& spec) {
    const int material = spec.material == BurMaterial::Carbide ? kCarbide : kElectroplatedDiamond;
    std::string number = threeDigits(material);
    for (const long group :
         {long{kFrictionGrip}, long{spec.isoShape}, long{toothingCode(spec)}, std::lround(10 * spec.headDiameter)}) {
        number.append(" ").append(threeDigits(group));
    }
    return number;
}

std::optional<BurSpec> findBur(std::string_view number) {
    const std::vector<BurSpec>& catalogue = burCatalogue();
    const auto found = std::ranges::find(catalogue, number, &BurSpec::number);
    if (found != catalogue.end()) return *found;
    constexpr std::size_t kIsoDigits = 15;
    const std::string digits = digitsOf(number);
    if (digits.size() != kIsoDigits) return std::nullopt;
    return findByIso(digits);
}

}  // namespace tactooth
