// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Built-in teeth.
inline constexpr MessageText kLowerFirstMolar{"lower_first_molar", "Lower first molar (46)", "下顎第一大臼歯（46）"};
inline constexpr MessageText kUpperCentralIncisor{"upper_central_incisor", "Upper central incisor (11)",
                                                  "上顎中切歯（11）"};
inline constexpr MessageText kUpperCanine{"upper_canine", "Upper canine (13)", "上顎犬歯（13）"};

// The gum of a built-in mouth.
inline constexpr MessageText kGingivaCrossesItself{
    "gingiva_crosses_itself",
    "%1 crosses itself at each of the %2 resolutions that were tried; ask for another number of triangles or "
    "another seed.",
    "%1は、試した %2 通りの解像度のいずれでも自分自身と交差します。三角形の数かシードを変えてください。"};
inline constexpr MessageText kUpperGingiva{"upper_gingiva",
                                           "The upper gum of the mouth with seed %1 and %2 triangles a tooth",
                                           "上顎の歯肉（シード %1、1歯あたり三角形 %2 個）"};
inline constexpr MessageText kLowerGingiva{"lower_gingiva",
                                           "The lower gum of the mouth with seed %1 and %2 triangles a tooth",
                                           "下顎の歯肉（シード %1、1歯あたり三角形 %2 個）"};

// Burs.
inline constexpr MessageText kCarbideBur{"carbide_bur", "%1 carbide No. %2, %3", "%1カーバイド No. %2、%3"};
inline constexpr MessageText kDiamondBur{"diamond_bur", "%1 diamond %2, %3", "%1ダイヤモンド %2、%3"};
inline constexpr MessageText kBurRound{"bur_round", "Round", "ラウンド"};
inline constexpr MessageText kBurInvertedCone{"bur_inverted_cone", "Inverted cone", "インバーテッドコーン"};
inline constexpr MessageText kBurPear{"bur_pear", "Pear", "ペアーシェイプ"};
inline constexpr MessageText kBurLongPear{"bur_long_pear", "Long pear", "ロングペアーシェイプ"};
inline constexpr MessageText kBurStraightFissure{"bur_straight_fissure", "Straight fissure", "ストレートフィッシャー"};
inline constexpr MessageText kBurCrossCutStraightFissure{"bur_cross_cut_straight_fissure", "Cross-cut straight fissure",
                                                         "クロスカットストレートフィッシャー"};
inline constexpr MessageText kBurDomeEndFissure{"bur_dome_end_fissure", "Dome-end fissure", "ドームエンドフィッシャー"};
inline constexpr MessageText kBurTaperedFissure{"bur_tapered_fissure", "Tapered fissure", "テーパードフィッシャー"};
inline constexpr MessageText kBurCrossCutTaperedFissure{"bur_cross_cut_tapered_fissure", "Cross-cut tapered fissure",
                                                        "クロスカットテーパードフィッシャー"};
inline constexpr MessageText kBurLongTaperedFissure{"bur_long_tapered_fissure", "Long tapered fissure",
                                                    "ロングテーパードフィッシャー"};
inline constexpr MessageText kBurRoundEndTaperedFissure{"bur_round_end_tapered_fissure", "Round-end tapered fissure",
                                                        "ラウンドエンドテーパードフィッシャー"};
inline constexpr MessageText kBurDomeEndTaperedFissure{"bur_dome_end_tapered_fissure", "Dome-end tapered fissure",
                                                       "ドームエンドテーパードフィッシャー"};
inline constexpr MessageText kBurBallFinishing{"bur_ball_finishing", "Ball finishing", "ボール仕上げ用"};
inline constexpr MessageText kBurEggFinishing{"bur_egg_finishing", "Egg finishing", "エッグ仕上げ用"};
inline constexpr MessageText kBurNeedleFinishing{"bur_needle_finishing", "Needle finishing", "ニードル仕上げ用"};
inline constexpr MessageText kBurFootball{"bur_football", "Football", "フットボール"};
inline constexpr MessageText kBurFlatEndCylinder{"bur_flat_end_cylinder", "Flat-end cylinder",
                                                 "フラットエンドシリンダー"};
inline constexpr MessageText kBurFlatEndTaper{"bur_flat_end_taper", "Flat-end taper", "フラットエンドテーパー"};
inline constexpr MessageText kBurRoundEndTaper{"bur_round_end_taper", "Round-end taper", "ラウンドエンドテーパー"};
inline constexpr MessageText kBurNeedle{"bur_needle", "Needle", "ニードル"};
inline constexpr MessageText kBurFlame{"bur_flame", "Flame", "フレーム"};
inline constexpr MessageText kBurTorpedo{"bur_torpedo", "Torpedo", "トーピード"};
inline constexpr MessageText kBurTorpedoTaper{"bur_torpedo_taper", "Torpedo taper", "トーピードテーパー"};
inline constexpr MessageText kBurRoundEndCylinder{"bur_round_end_cylinder", "Round-end cylinder",
                                                  "ラウンドエンドシリンダー"};
inline constexpr MessageText kBurWheel{"bur_wheel", "Wheel", "ホイール"};

// Spindles.
inline constexpr MessageText kAirTurbine{"air_turbine", "Air turbine, 400,000 rev/min",
                                         "エアタービン、400,000 回転/分"};
inline constexpr MessageText kElectricSpindle{"electric_spindle", "Electric 1:5, 200,000 rev/min",
                                              "5倍速電動、200,000 回転/分"};
inline constexpr MessageText kLowSpeedSpindle{"low_speed_spindle", "Low-speed contra-angle, 25,000 rev/min",
                                              "低速コントラアングル、25,000 回転/分"};

// Hand instruments.
inline constexpr MessageText kExplorer{"explorer", "Explorer", "探針"};
inline constexpr MessageText kPeriodontalProbe{"periodontal_probe", "Periodontal probe", "歯周プローブ"};
inline constexpr MessageText kSpoonExcavator{"spoon_excavator", "Spoon excavator", "スプーンエキスカベーター"};

}  // namespace tactooth::msg
