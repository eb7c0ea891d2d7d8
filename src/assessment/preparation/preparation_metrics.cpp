// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/preparation/preparation_metrics.h"

#include <algorithm>
#include <array>

#include "assessment/messages.h"
#include "assessment/preparation/enamel_support.h"
#include "assessment/preparation/forbidden_volume.h"
#include "assessment/preparation/inner_angle.h"

namespace tactooth {
namespace {

constexpr double kSpacing = 0.05;  // mm between two lines of the volumes: 0.2 % of a cavity of 4 x 3 mm
using All = const PreparationMeasures&;

Measured noHand(All m) { return Measured::none(m.hasSession ? msg::kNeverTouched : msg::kNoSession); }
Measured ofHand(All m, double HandWork::*value) { return m.hand ? Measured::of((*m.hand).*value) : noHand(m); }
Measured ofHand(All m, Measured HandWork::*value) { return m.hand ? (*m.hand).*value : noHand(m); }

Measured efficiency(All m) {
    if (!m.hand) return noHand(m);
    if (!(m.hand->drilling > 0)) return Measured::none(msg::kNeverDrilled);
    return Measured::of(m.volumes.common / m.hand->drilling);
}

/// That of the session, which lies in its frame; else that of the preparation.
const LayeredTooth* toothOf(const Preparation& preparation, const RecordedSessions& sessions) {
    const bool isInSession = sessions.student != nullptr && !sessions.student->tooth()->layers().empty();
    return isInSession ? sessions.student->tooth().get() : preparation.tooth.get();
}

Measured pathRatio(All m) {
    if (!m.hand) return noHand(m);
    if (!m.hasExpertSession) return Measured::none(msg::kNoExpertSession);
    if (!m.expertHand) return Measured::none(msg::kExpertNeverTouched);
    if (!(m.hand->path > 0)) return Measured::none(msg::kNoPath);
    return Measured::of(m.expertHand->path / m.hand->path);
}

Measured largerRidge(All m) {
    const Measured &mesial = m.extent.mesialRidge, &distal = m.extent.distalRidge;
    if (!mesial.value) return distal;
    return distal.value.value_or(0) > *mesial.value ? distal : mesial;
}

Measured decayRate(All m) {
    if (!m.hand) return noHand(m);
    if (!m.tissues.removedDecay.value) return m.tissues.removedDecay;
    if (!(m.hand->drilling > 0)) return Measured::none(msg::kNeverDrilled);
    return Measured::of(*m.tissues.removedDecay.value / m.hand->drilling);
}

constexpr std::array kMetrics = {
    PreparationMetric{"cleared_share", "Ideal preparation cut", "1", Better::Higher,
                      [](All m) { return Measured::of(m.volumes.clearedShare()); },
                      "Removed share of the volume that was to be removed.", "理想形成の削除率",
                      "削除すべき体積のうち、削除した割合。", ValueForm::Share},
    PreparationMetric{"over_max", "Deepest over-preparation", "mm", Better::Lower,
                      [](All m) { return m.deviation.overMax; },
                      "Greatest distance of the cut surface beyond the ideal surface.", "削りすぎの最大深さ",
                      "削った面が理想面を越えた距離の最大値。"},
    PreparationMetric{"over_volume", "Over-prepared volume", "mm^3", Better::Lower,
                      [](All m) { return Measured::of(m.volumes.over); }, "Removed volume that was not to be removed.",
                      "削りすぎの体積", "削除すべきでないのに削除した体積。"},
    PreparationMetric{"over_volume_beyond", "Over-prepared beyond the tolerance", "mm^3", Better::Lower,
                      [](All m) { return Measured::of(m.volumes.beyond); },
                      "Removed volume that lies farther from the ideal surface than the tolerance of the exercise, "
                      "or than 0.3 mm.",
                      "許容差を超えた削りすぎの体積",
                      "理想面から、課題の許容差（ない場合は 0.3 mm）より遠くまで削除した体積。"},
    PreparationMetric{"under_volume", "Under-prepared volume", "mm^3", Better::Lower,
                      [](All m) { return Measured::of(m.volumes.under); },
                      "Volume that was to be removed and is still there.", "削り残しの体積",
                      "削除すべきなのに残っている体積。"},
    PreparationMetric{
        "dice", "Overlap (Dice)", "1", Better::Higher, [](All m) { return Measured::of(m.volumes.dice()); },
        "Twice the common volume of the removed and the ideal part over the sum of both (Dice 1945).",
        "一致度（Dice 係数）", "削除した部分と理想の部分の共通体積の 2 倍を、両者の和で割った値（Dice 1945）。",
        ValueForm::Share},
    PreparationMetric{
        "deviation_rms", "Deviation from the ideal (RMS)", "mm", Better::Lower, [](All m) { return m.deviation.rms; },
        "Root mean square, by area, of the distance to the ideal surface, where one of the two is cut.",
        "理想からのずれ（RMS）", "どちらかが削られている部分での、理想面までの距離の、面積についての二乗平均平方根。"},
    PreparationMetric{
        "deviation_mean", "Deviation from the ideal (mean, signed)", "mm", Better::Neither,
        [](All m) { return m.deviation.mean; }, "Mean, by area, of that distance; positive: too little was removed.",
        "理想からのずれ（符号付き平均）", "その距離の、面積についての平均。正の値は、削り足りないことを示す。"},
    PreparationMetric{"deviation_p50", "Deviation from the ideal (median)", "mm", Better::Lower,
                      [](All m) { return m.deviation.median; }, "Absolute distance that half of that area keeps to.",
                      "理想からのずれ（中央値）", "その面積の半分が超えない、距離の絶対値。"},
    PreparationMetric{"deviation_p95", "Deviation from the ideal (95 %)", "mm", Better::Lower,
                      [](All m) { return m.deviation.p95; }, "Absolute distance that 95 % of that area keeps to.",
                      "理想からのずれ（95 %）", "その面積の 95 % が超えない、距離の絶対値。"},
    PreparationMetric{"within_0_1", "Surface within 0.1 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[0]; },
                      "Share of that area within 0.1 mm of the ideal surface.", "理想から 0.1 mm 以内の面",
                      "その面積のうち、理想面から 0.1 mm 以内にある割合。", ValueForm::Share},
    PreparationMetric{"within_0_2", "Surface within 0.2 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[1]; },
                      "Share of that area within 0.2 mm of the ideal surface.", "理想から 0.2 mm 以内の面",
                      "その面積のうち、理想面から 0.2 mm 以内にある割合。", ValueForm::Share},
    PreparationMetric{"within_0_3", "Surface within 0.3 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[2]; },
                      "Share of that area within 0.3 mm of the ideal surface.", "理想から 0.3 mm 以内の面",
                      "その面積のうち、理想面から 0.3 mm 以内にある割合。", ValueForm::Share},
    PreparationMetric{"within_0_4", "Surface within 0.4 mm", "1", Better::Higher,
                      [](All m) { return m.deviation.within[3]; },
                      "Share of that area within 0.4 mm of the ideal surface.", "理想から 0.4 mm 以内の面",
                      "その面積のうち、理想面から 0.4 mm 以内にある割合。", ValueForm::Share},
    PreparationMetric{"floor_depth_median", "Depth of the floor (median)", "mm", Better::Neither,
                      [](All m) { return m.form.floorDepth; },
                      "Median, by area as seen along the axis, of the distance along it from the floor to the uncut "
                      "surface. Low ridges between the passes of a bur belong to the floor.",
                      "窩底の深さ（中央値）",
                      "窩底から削る前の面まで、軸に沿った距離の、軸方向から見た面積についての中央値。"
                      "バーの通った跡の間の低い隆起も窩底に含む。"},
    PreparationMetric{"floor_depth_min", "Depth of the floor (least)", "mm", Better::Neither,
                      [](All m) { return m.form.floorDepthMin; }, "Least of that distance.", "窩底の深さ（最小）",
                      "その距離の最小値。"},
    PreparationMetric{"floor_depth_p5", "Depth of the floor (5 %)", "mm", Better::Neither,
                      [](All m) { return m.form.floorDepthP5; }, "Its 5th percentile by that area.",
                      "窩底の深さ（5 %）", "その距離の、同じ面積についての 5 パーセンタイル。"},
    PreparationMetric{"floor_depth_p95", "Depth of the floor (95 %)", "mm", Better::Neither,
                      [](All m) { return m.form.floorDepthP95; }, "Its 95th percentile by that area.",
                      "窩底の深さ（95 %）", "その距離の、同じ面積についての 95 パーセンタイル。"},
    PreparationMetric{"floor_depth_max", "Depth of the floor (greatest)", "mm", Better::Neither,
                      [](All m) { return m.form.floorDepthMax; }, "Greatest of that distance.", "窩底の深さ（最大）",
                      "その距離の最大値。"},
    PreparationMetric{"floor_flatness", "Flatness of the floor (RMS)", "mm", Better::Lower,
                      [](All m) { return m.form.floorFlatness; },
                      "Root mean square distance of the floor from its plane (total least squares).",
                      "窩底の平坦さ（RMS）", "窩底とその平面（全最小二乗法）との距離の二乗平均平方根。"},
    PreparationMetric{"floor_tilt", "Tilt of the floor", "deg", Better::Lower, [](All m) { return m.form.floorTilt; },
                      "Angle between the normal of that plane and the axis.", "窩底の傾き",
                      "その平面の法線と軸との角度。"},
    PreparationMetric{"wall_angle_b", "Buccal wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[0]; },
                      "Mean angle of the buccal wall to the axis; positive: narrower at the outer end.", "頬側壁の角度",
                      "頬側壁の、軸に対する平均角度。正の値は、外側の端が狭いことを示す。"},
    PreparationMetric{"wall_angle_l", "Lingual wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[1]; },
                      "The same of the lingual wall.", "舌側壁の角度", "舌側壁についての同じ角度。"},
    PreparationMetric{"wall_angle_m", "Mesial wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[2]; },
                      "The same of the mesial wall.", "近心壁の角度", "近心壁についての同じ角度。"},
    PreparationMetric{"wall_angle_d", "Distal wall", "deg", Better::Neither, [](All m) { return m.form.wallAngle[3]; },
                      "The same of the distal wall.", "遠心壁の角度", "遠心壁についての同じ角度。"},
    PreparationMetric{"extent_md", "Length, mesiodistal", "mm", Better::Neither,
                      [](All m) { return m.extent.mesiodistal; },
                      "Length of the cut surface in the mesiodistal direction of the tooth.", "長さ（近遠心方向）",
                      "削った面の、歯の近遠心方向の長さ。"},
    PreparationMetric{"extent_bl", "Width, buccolingual", "mm", Better::Neither,
                      [](All m) { return m.extent.buccolingual; }, "The same in the buccolingual direction.",
                      "幅（頬舌方向）", "頬舌方向についての同じ長さ。"},
    PreparationMetric{"extent_og", "Height, occlusogingival", "mm", Better::Neither,
                      [](All m) { return m.extent.vertical; }, "The same along the tooth's long axis.",
                      "高さ（咬合面・歯肉方向）", "歯の長軸方向についての同じ長さ。"},
    PreparationMetric{"isthmus_min", "Isthmus, narrowest", "mm", Better::Neither,
                      [](All m) { return m.extent.isthmus; },
                      "Smallest width of the cavity across its longest direction, without both ends.", "峡部の最小幅",
                      "最も長い方向を横切る窩洞の幅の、両端を除いた最小値。"},
    PreparationMetric{"ridge_min_m", "Mesial ridge left", "mm", Better::Neither,
                      [](All m) { return m.extent.mesialRidge; },
                      "Smallest distance from the cut surface to the mesial outside of the uncut tooth.",
                      "近心辺縁隆線の残り", "削った面から、削る前の歯の近心の外面までの最短距離。"},
    PreparationMetric{"ridge_min_d", "Distal ridge left", "mm", Better::Neither,
                      [](All m) { return m.extent.distalRidge; }, "The same to the distal outside.",
                      "遠心辺縁隆線の残り", "遠心の外面についての同じ距離。"},
    PreparationMetric{"ridge_kept", "Ridge left, the larger", "mm", Better::Neither,
                      [](All m) { return largerRidge(m); },
                      "Larger of the two ridges left: of a Class II cavity that without a box.",
                      "残った辺縁隆線（大きい方）",
                      "近心と遠心の残りのうち大きい方。2 級窩洞では、隣接面窩洞のない側。"},
    PreparationMetric{"undercut_area", "Undercut area", "mm^2", Better::Neither, [](All m) { return m.undercut.area; },
                      "Cut area that faces away from the axis by more than 1 degree, or that something hangs over.",
                      "アンダーカットの面積",
                      "軸と逆の方向に 1 度を超えて向くか、上に張り出しのある、削った面の面積。"},
    PreparationMetric{"undercut_area_best", "Undercut area, best insertion", "mm^2", Better::Neither,
                      [](All m) { return m.undercut.bestArea; },
                      "Least undercut area of all directions of insertion within 10 degrees of the axis, a degree "
                      "apart.",
                      "最良の挿入方向でのアンダーカットの面積",
                      "軸から 10 度以内の、1 度刻みのすべての挿入方向のうち、最小のアンダーカットの面積。"},
    PreparationMetric{"undercut_area_scan", "Undercut area, of a scan", "mm^2", Better::Neither,
                      [](All m) { return m.undercut.scanArea; },
                      "As the undercut area, with 2 degrees: the noise of a scanner makes false undercuts of 1 degree.",
                      "アンダーカットの面積（スキャン用）",
                      "アンダーカットの面積と同じで、角度は 2 度。スキャナーの雑音は 1 "
                      "度の偽のアンダーカットを作る。"},
    PreparationMetric{"undercut_depth", "Undercut depth", "mm", Better::Neither, [](All m) { return m.undercut.depth; },
                      "Greatest level distance from a cut wall to the end of what hangs over it.",
                      "アンダーカットの深さ", "削った壁から、その上の張り出しの先端までの水平距離の最大値。"},
    PreparationMetric{"toc_md", "Convergence, mesiodistal", "deg", Better::Neither,
                      [](All m) { return m.form.tocMesiodistal; },
                      "Total occlusal convergence of a crown preparation: angle of the mesial plus the distal wall.",
                      "収束角（近遠心）", "支台歯形成の総収束角：近心壁と遠心壁の角度の和。"},
    PreparationMetric{"toc_bl", "Convergence, buccolingual", "deg", Better::Neither,
                      [](All m) { return m.form.tocBuccolingual; }, "The same of the buccal and the lingual wall.",
                      "収束角（頬舌）", "頬側壁と舌側壁についての同じ角度。"},
    PreparationMetric{
        "toc_sections", "Convergence, eight sections", "deg", Better::Neither,
        [](All m) { return m.form.toc.sections; },
        "Mean of eight vertical sections round the axis: angle between the straight lines (least squares) "
        "through both walls, from 20 to 80 % of their height.",
        "収束角（8 断面）",
        "軸のまわりの 8 つの縦断面の平均：両側の壁の、高さ 20 から 80 % "
        "の部分を通る直線（最小二乗法）がなす角度。"},
    PreparationMetric{"toc_cone", "Convergence, fitted cone", "deg", Better::Neither,
                      [](All m) { return m.form.toc.cone; },
                      "Opening angle of the cone whose axis makes the normals of the axial wall lean alike.",
                      "収束角（円錐の当てはめ）", "軸面壁の法線の傾きが最も揃う軸をもつ円錐の、開き角。"},
    PreparationMetric{"toc_difference", "Difference of these two", "deg", Better::Lower,
                      [](All m) { return m.form.toc.difference; },
                      "Within 1 degree on a cone; more where the wall is no cone or leans as a whole.", "この二つの差",
                      "円錐では 1 度以内。壁が円錐でないか、全体が傾いていると大きい。"},
    PreparationMetric{"occlusal_reduction_min", "Occlusal reduction, least", "mm", Better::Neither,
                      [](All m) { return m.occlusal.least; },
                      "Of a crown preparation: distance along the axis from its occlusal or incisal end to the uncut "
                      "surface; its 5th percentile by area.",
                      "咬合面の削除量（最小）",
                      "支台歯形成の咬合面または切縁側の面から、削る前の面まで、軸に沿った距離。"
                      "面積についての 5 パーセンタイル。"},
    PreparationMetric{"occlusal_reduction_median", "Occlusal reduction (median)", "mm", Better::Neither,
                      [](All m) { return m.occlusal.median; }, "Median of that distance, by area.",
                      "咬合面の削除量（中央値）", "その距離の、面積についての中央値。"},
    PreparationMetric{"inner_angle_radius", "Radius of the inner angles", "mm", Better::Neither,
                      [](All m) { return m.innerAngle; },
                      "Radius of the angles between floor and walls, in which a ball of 0.3 mm rolls: its 5th "
                      "percentile, the sharpest angles. 0.3 where all angles are as round or rounder.",
                      "内側の隅角の半径",
                      "窩底と側壁の間の隅角に 0.3 mm の球を転がして測る半径の 5 パーセンタイル（最も鋭い隅角）。"
                      "どこもそれ以上に丸ければ 0.3。"},
    PreparationMetric{"remaining_dentin_min", "Dentin left over the pulp", "mm", Better::Higher,
                      [](All m) { return m.damage.remainingDentin; },
                      "Smallest distance from the cut surface to the pulp; 0 where it is open.", "歯髄までの残存象牙質",
                      "削った面から歯髄までの最短距離。露髄していれば 0。"},
    PreparationMetric{"pulp_open", "Pulp opened", "1", Better::Lower, [](All m) { return m.damage.pulpOpen; },
                      "1 if the cut surface reaches the pulp, else 0.", "露髄",
                      "削った面が歯髄に達していれば 1、そうでなければ 0。", ValueForm::Count},
    PreparationMetric{"neighbour_depth_max", "Deepest cut in a neighbour", "mm", Better::Lower,
                      [](All m) { return m.damage.neighbourDepth; },
                      "Greatest depth of a cut below the surface of a tooth beside.", "隣在歯の傷の最大深さ",
                      "隣在歯の表面からの、切削の深さの最大値。"},
    PreparationMetric{"neighbour_scratches", "Scratches in a neighbour", "1", Better::Lower,
                      [](All m) { return m.damage.neighbourScratches; },
                      "Number of connected cuts in the teeth beside that are deeper than 0.05 mm.", "隣在歯の傷の数",
                      "隣在歯の、深さが 0.05 mm を超える、つながった切削の数。", ValueForm::Count},
    PreparationMetric{"neighbour_nicks", "Nicks in a neighbour", "1", Better::Lower,
                      [](All m) { return m.damage.neighbourNicks; },
                      "Number of these that are deeper than 0.2 mm and would need a filling.", "隣在歯の欠けの数",
                      "そのうち、深さが 0.2 mm を超え、修復が必要なものの数。", ValueForm::Count},
    PreparationMetric{"contact_gap_gingival", "Contact opened, gingival", "mm", Better::Neither,
                      [](All m) { return m.contact.gingival; },
                      "Smallest distance from the gingival margin of a proximal box to the tooth beside; 0 where the "
                      "box does not reach the outside. About 0.5 mm are asked for (notes after Sturdevant).",
                      "接触点の離開（歯肉側）",
                      "隣接面窩洞の歯肉側の窩縁から隣在歯までの最短距離。窩洞が外面に達していなければ 0。"
                      "約 0.5 mm が求められる（Sturdevant による講義資料）。"},
    PreparationMetric{"contact_gap_buccal", "Contact opened, buccal", "mm", Better::Neither,
                      [](All m) { return m.contact.buccal; },
                      "The same from its buccal margin. 0.2 to 0.5 mm are asked for.", "接触点の離開（頬側）",
                      "頬側の窩縁についての同じ距離。0.2 ～ 0.5 mm が求められる。"},
    PreparationMetric{"contact_gap_lingual", "Contact opened, lingual", "mm", Better::Neither,
                      [](All m) { return m.contact.lingual; }, "The same from its lingual margin.",
                      "接触点の離開（舌側）", "舌側の窩縁についての同じ距離。"},
    PreparationMetric{"forbidden_volume", "Cut in forbidden zones", "mm^3", Better::Lower,
                      [](All m) { return m.forbiddenVolume; },
                      "Volume that was removed below the outlines of the exercise's forbidden zones.",
                      "切削禁止域の削除量", "課題の切削禁止域の外形の下で削除した体積。"},
    PreparationMetric{"unsupported_enamel", "Unsupported enamel", "mm^2", Better::Lower,
                      [](All m) { return m.unsupportedEnamel; },
                      "Area of cut enamel below which, square to the uncut surface, there is no dentin.",
                      "遊離エナメル質", "削る前の面に垂直な方向で、下に象牙質のない、削ったエナメル質の面積。"},
    PreparationMetric{"finish_line_roughness", "Roughness of the margin (RMS)", "mm", Better::Lower,
                      [](All m) { return m.margin.roughness; },
                      "RMS distance of the margin, or finish line, from itself when smoothed over 0.5 mm.",
                      "辺縁の粗さ（RMS）",
                      "窩縁またはフィニッシュラインと、それを 0.5 mm で平滑化した線との距離の RMS。"},
    PreparationMetric{"finish_line_width", "Width of the finish line (median)", "mm", Better::Neither,
                      [](All m) { return m.margin.width; },
                      "From the finish line of a crown preparation to the axial wall, square to the axis.",
                      "フィニッシュラインの幅（中央値）",
                      "支台歯形成のフィニッシュラインから軸面壁までの、軸に垂直な距離。"},
    PreparationMetric{"finish_line_width_sd", "Unevenness of that width", "mm", Better::Lower,
                      [](All m) { return m.margin.widthSpread; }, "Standard deviation of that width.",
                      "フィニッシュラインの幅のばらつき", "その幅の標準偏差。"},
    PreparationMetric{"finish_line_height", "Finish line above the gum (median)", "mm", Better::Neither,
                      [](All m) { return m.margin.heightAboveGum; },
                      "Height along the axis of the finish line of a crown preparation above the margin of the gum.",
                      "歯肉縁からのフィニッシュラインの高さ（中央値）",
                      "支台歯形成のフィニッシュラインの、歯肉縁からの、軸に沿った高さ。"},
    PreparationMetric{"removed_enamel", "Enamel removed", "mm^3", Better::Neither,
                      [](All m) { return m.tissues.removedEnamel; }, "Volume of enamel that was removed.",
                      "エナメル質の削除量", "削除したエナメル質の体積。"},
    PreparationMetric{"removed_dentin", "Dentin removed", "mm^3", Better::Neither,
                      [](All m) { return m.tissues.removedDentin; }, "Volume of dentin that was removed.",
                      "象牙質の削除量", "削除した象牙質の体積。"},
    PreparationMetric{"removed_pulp", "Pulp removed", "mm^3", Better::Neither,
                      [](All m) { return m.tissues.removedPulp; }, "Volume of pulp that was removed.", "歯髄の削除量",
                      "削除した歯髄の体積。"},
    PreparationMetric{"removed_decay", "Decay removed", "mm^3", Better::Higher,
                      [](All m) { return m.tissues.removedDecay; }, "Volume of decay that was removed.", "う蝕の削除量",
                      "削除したう蝕の体積。"},
    PreparationMetric{"decay_left", "Decay left", "mm^3", Better::Lower, [](All m) { return m.tissues.decayLeft; },
                      "Volume of decay that is still in the tooth.", "う蝕の残り", "歯に残っているう蝕の体積。"},
    PreparationMetric{"decay_share", "Decay removed, share", "1", Better::Higher,
                      [](All m) { return m.tissues.decayShare; }, "Removed share of all decay.", "う蝕の削除率",
                      "すべてのう蝕のうち、削除した割合。", ValueForm::Share},
    PreparationMetric{"over_enamel", "Sound enamel over-prepared", "mm^3", Better::Lower,
                      [](All m) { return m.tissues.overEnamel; }, "Removed enamel that was not to be removed.",
                      "健全エナメル質の削りすぎ", "削除すべきでないのに削除したエナメル質の体積。"},
    PreparationMetric{"over_dentin", "Sound dentin over-prepared", "mm^3", Better::Lower,
                      [](All m) { return m.tissues.overDentin; }, "Removed dentin that was not to be removed.",
                      "健全象牙質の削りすぎ", "削除すべきでないのに削除した象牙質の体積。"},
    PreparationMetric{"under_enamel", "Enamel under-prepared", "mm^3", Better::Lower,
                      [](All m) { return m.tissues.underEnamel; }, "Enamel that was to be removed and is still there.",
                      "エナメル質の削り残し", "削除すべきなのに残っているエナメル質の体積。"},
    PreparationMetric{"under_dentin", "Dentin under-prepared", "mm^3", Better::Lower,
                      [](All m) { return m.tissues.underDentin; }, "Dentin that was to be removed and is still there.",
                      "象牙質の削り残し", "削除すべきなのに残っている象牙質の体積。"},
    PreparationMetric{"session_time", "Length of the session", "s", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::seconds); },
                      "From the first to the last moment of the recording.", "セッションの長さ",
                      "記録の最初から最後までの時間。"},
    PreparationMetric{
        "drilling_time", "Drilling", "s", Better::Neither, [](All m) { return ofHand(m, &HandWork::drilling); },
        "Time in which the turning bur touches something.", "切削時間", "回転中のバーが何かに触れている時間。"},
    PreparationMetric{
        "idle_time", "Idle spinning", "s", Better::Lower, [](All m) { return ofHand(m, &HandWork::idle); },
        "Time in which the bur turns and touches nothing.", "空転時間", "バーが回転し、何にも触れていない時間。"},
    PreparationMetric{"dead_time", "Pauses", "s", Better::Neither, [](All m) { return ofHand(m, &HandWork::dead); },
                      "Time without turning and touching, in pauses of more than 1 s.", "休止時間",
                      "回転も接触もない時間。1 秒を超える休止だけを数える。"},
    PreparationMetric{"mirror_time", "Bur seen in the mirror", "s", Better::Neither, [](All m) { return m.mirrorTime; },
                      "Time in which the mirror shows the bur's tip to the eye that looks at the picture.",
                      "ミラーにバーが映る時間", "画面を見る目に、ミラーがバーの先端を映している時間。"},
    PreparationMetric{"clutch_uses", "Bur held while the hand moved", "1", Better::Neither,
                      [](All m) { return m.hand ? Measured::none(msg::kNoClutchKnown) : noHand(m); },
                      "Number of times that the bur was held while the hand moved on. Recordings do not hold it, so it "
                      "is not measurable.",
                      "バーの保持の回数", "バーを保持したまま手を動かした回数。記録に含まれないため、計測できない。",
                      ValueForm::Count},
    PreparationMetric{"finger_lifts", "Lifts of the finger rest", "1", Better::Lower,
                      [](All m) { return m.hand ? Measured::none(msg::kNoFingerRestKnown) : noHand(m); },
                      "Number of times that the resting finger left the teeth. No device measures it, so it is not "
                      "measurable.",
                      "フィンガーレストを離した回数",
                      "歯に置いた指が離れた回数。計測する装置がないため、計測できない。", ValueForm::Count},
    PreparationMetric{
        "target_time", "Drilling in the ideal cavity", "1", Better::Higher, [](All m) { return m.coverage.target; },
        "Share of the drilling time in which no part of the bur's head lies more than 0.05 mm beyond what "
        "is to be removed.",
        "理想窩洞内の切削",
        "切削時間のうち、バーの頭部のどこも、削除すべき部分から 0.05 mm を超えて出ていない時間の割合。",
        ValueForm::Share},
    PreparationMetric{
        "band_time", "Drilling within the tolerance", "1", Better::Neither, [](All m) { return m.coverage.band; },
        "Share in which it lies farther beyond, but within the tolerance of the exercise, or 0.3 mm.", "許容差内の切削",
        "それより外に出ているが、課題の許容差（ない場合は 0.3 mm）以内の時間の割合。", ValueForm::Share},
    PreparationMetric{"outside_time", "Drilling beyond the tolerance", "1", Better::Lower,
                      [](All m) { return m.coverage.outside; },
                      "Share in which it lies beyond the tolerance, or works elsewhere.", "許容差を超えた切削",
                      "許容差を超えて出ている、または別の場所を削っている時間の割合。", ValueForm::Share},
    PreparationMetric{"dentin_time", "Dentin reached", "s", Better::Neither, [](All m) { return m.order.dentinTime; },
                      "When the bur first cut dentin, since the session began.", "象牙質への到達",
                      "セッションの開始から、バーが初めて象牙質を削るまでの時間。"},
    PreparationMetric{"periphery_first", "Decay along the enamel first", "1", Better::Higher,
                      [](All m) { return m.order.decay.peripheryFirst; },
                      "Share of the pairs of a removed piece along the enamel (in it, or within 0.5 mm below it) and a "
                      "removed piece of the deep third, over the pulp, in which that along the enamel went first. "
                      "100 %: all of it before the deep decay; 50 %: no order.",
                      "エナメル質沿いのう蝕を先に除去",
                      "エナメル質に沿った（その中か、下 0.5 mm 以内の）除去片と、歯髄に近い 3 分の 1 "
                      "の除去片のすべての組のうち、前者を先に除去した割合。100 % はすべて先、50 % は順序なし。",
                      ValueForm::Share},
    PreparationMetric{"deep_decay_early", "Deep decay removed too early", "1", Better::Lower,
                      [](All m) { return m.order.decay.deepEarly; },
                      "Share of the removed deep decay that went before 90 % of the removed decay along the enamel "
                      "had gone.",
                      "深部のう蝕の早すぎる除去",
                      "除去した深部のう蝕のうち、エナメル質に沿ったう蝕の除去の 90 % が済む前に除去した割合。",
                      ValueForm::Share},
    PreparationMetric{"path_length", "Path of the bur", "mm", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::path); },
                      "Length of the path of the bur's tip, without what is faster than 20 Hz.", "バーの移動距離",
                      "バー先端の経路の長さ。20 Hz より速い動きは除く。"},
    PreparationMetric{"path_ratio", "Path of the expert by that path", "1", Better::Higher,
                      [](All m) { return pathRatio(m); },
                      "Path of the bur in the expert's recorded session, by the same path of the student. Below 1: the "
                      "student moved the bur farther.",
                      "専門家の移動距離との比",
                      "記録された専門家のセッションでのバーの移動距離を、学生の移動距離で割った値。"
                      "1 より小さければ、学生の方がバーを長く動かしている。"},
    PreparationMetric{"economy", "Economy of the strokes", "1", Better::Higher,
                      [](All m) { return ofHand(m, &HandWork::economy); },
                      "Straight distance from the beginning to the end of each stroke, by the path between them; sums "
                      "over all strokes. 1: all strokes are straight.",
                      "ストロークの直線性",
                      "各ストロークの始点から終点までの直線距離の合計を、その間の経路の長さの合計で割った値。"
                      "すべてのストロークが直線であれば 1。"},
    PreparationMetric{"strokes", "Strokes", "1", Better::Neither, [](All m) { return ofHand(m, &HandWork::strokes); },
                      "Contacts of the turning bur of more than 50 ms; gaps of less than 50 ms do not count.",
                      "ストローク数", "回転中のバーの、50 ms を超える接触の数。50 ms 未満の途切れは数えない。",
                      ValueForm::Count},
    PreparationMetric{"stroke_time", "Length of a stroke (median)", "s", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::strokeTime); }, "Median of their durations.",
                      "ストロークの長さ（中央値）", "その持続時間の中央値。"},
    PreparationMetric{"sparc", "Smoothness (SPARC, median)", "1", Better::Higher,
                      [](All m) { return ofHand(m, &HandWork::arcLength); },
                      "Spectral arc length of the speed in strokes of more than 0.3 s (Balasubramanian 2012).",
                      "滑らかさ（SPARC、中央値）",
                      "0.3 秒を超えるストロークでの、速度のスペクトル弧長（Balasubramanian 2012）。"},
    PreparationMetric{
        "ldlj", "Smoothness (LDLJ, median)", "1", Better::Higher, [](All m) { return ofHand(m, &HandWork::jerk); },
        "Log dimensionless jerk of the speed in the same strokes (Balasubramanian 2015).", "滑らかさ（LDLJ、中央値）",
        "同じストロークでの、速度の対数無次元ジャーク（Balasubramanian 2015）。"},
    PreparationMetric{"speed_f95", "95 % frequency of the speed", "Hz", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::frequency95); },
                      "Frequency below which 95 % of the power of the speed lies, in the same strokes.",
                      "速度の 95 % 周波数", "同じストロークで、速度のパワーの 95 % がこれより低い周波数。"},
    PreparationMetric{"force_mean", "Force, mean", "N", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::forceMean); }, "Mean force over the time of contact.",
                      "力（平均）", "接触中の力の時間平均。"},
    PreparationMetric{"force_rms", "Force (RMS)", "N", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::forceRms); },
                      "Root mean square of the force over the time of contact.", "力（RMS）",
                      "接触中の力の、時間についての二乗平均平方根。"},
    PreparationMetric{"force_p95", "Force, 95 % below", "N", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forceP95); },
                      "Force that is not exceeded in 95 % of the time of contact.", "力（95 % がこれ以下）",
                      "接触時間の 95 % で超えない力。"},
    PreparationMetric{"force_peak", "Force, greatest", "N", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forcePeak); }, "Greatest force.", "力（最大）",
                      "力の最大値。"},
    PreparationMetric{"force_over_2n", "Time with more than 2 N", "1", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forceOver2); },
                      "Share of the time of contact with more than 2 N.", "2 N を超える時間",
                      "接触時間のうち、2 N を超える割合。", ValueForm::Share},
    PreparationMetric{"force_sd", "Force, unsteadiness in strokes", "N", Better::Lower,
                      [](All m) { return ofHand(m, &HandWork::forceSpread); },
                      "Standard deviation of the force within a stroke: root mean square over the strokes, by time.",
                      "ストローク内の力のばらつき",
                      "ストローク内の力の標準偏差。全ストロークにわたる、時間についての二乗平均平方根。"},
    PreparationMetric{"impulse", "Impulse", "N*s", Better::Neither, [](All m) { return ofHand(m, &HandWork::impulse); },
                      "Force times time, summed over all contacts.", "力積", "力と時間の積の、すべての接触での合計。"},
    PreparationMetric{"efficiency", "Efficiency", "mm^3/s", Better::Higher, [](All m) { return efficiency(m); },
                      "Removed volume that was to be removed, for each second of drilling.", "切削効率",
                      "切削 1 秒あたりに、削除すべき部分から削除した体積。"},
    PreparationMetric{"decay_rate", "Decay removed, each second", "mm^3/s", Better::Higher,
                      [](All m) { return decayRate(m); },
                      "Volume of decay that was removed, for each second of drilling.", "う蝕の除去速度",
                      "切削 1 秒あたりに削除したう蝕の体積。"},
    PreparationMetric{"bur_tilt", "Bur against the axis (mean)", "deg", Better::Neither,
                      [](All m) { return ofHand(m, &HandWork::burTilt); },
                      "Angle between the shaft of the bur and the axis of the preparation, mean over the time of "
                      "drilling.",
                      "軸に対するバーの傾き（平均）", "バーの軸部と形成の軸との角度の、切削中の時間平均。"},
};

}  // namespace

PreparationMeasures::PreparationMeasures(const Preparation& preparation, const RecordedSessions& sessions)
    : surfaces(preparation),
      form(cavityForm(preparation, surfaces)),
      extent(cavityExtent(preparation, surfaces)),
      undercut(tactooth::undercut(preparation, surfaces)),
      damage(tissueDamage(preparation, surfaces)),
      contact(contactGap(preparation, surfaces)),
      unsupportedEnamel(tactooth::unsupportedEnamel(preparation, surfaces)),
      margin(marginLine(preparation, surfaces)),
      occlusal(occlusalReduction(preparation, surfaces)),
      innerAngle(innerAngleRadius(preparation, surfaces)) {
    const ColumnGrid columns(preparation.axis, surfaces.cut.mesh, surfaces.idealCut.mesh, kSpacing);
    volumes = preparedVolumes(preparation, columns, /*hasBeyond=*/true);
    deviation = surfaceDeviation(preparation, columns);
    tissues = tissueVolumes(preparation, volumes, kSpacing);
    forbiddenVolume = tactooth::forbiddenVolume(preparation, surfaces, kSpacing);
    hasSession = sessions.student != nullptr;
    if (hasSession) hand = handWork(*sessions.student, preparation.axis);
    mirrorTime = tactooth::mirrorTime(sessions.student.get());
    coverage = burCoverage(preparation, surfaces, sessions.student.get(), sessions.studentInTooth);
    order = tissueOrder(toothOf(preparation, sessions), sessions.student);
    hasExpertSession = sessions.expert != nullptr;
    if (hasExpertSession) expertHand = handWork(*sessions.expert, preparation.axis);
}

std::span<const PreparationMetric> preparationMetrics() { return kMetrics; }

const PreparationMetric* findPreparationMetric(std::string_view id) {
    const auto* const found = std::ranges::find(kMetrics, id, &PreparationMetric::id);
    return found == kMetrics.end() ? nullptr : found;
}

std::vector<MetricResult> measureAll(const PreparationMeasures& measures) {
    std::vector<MetricResult> results;
    for (const PreparationMetric& metric : preparationMetrics()) results.push_back({&metric, metric.measure(measures)});
    return results;
}

}  // namespace tactooth
