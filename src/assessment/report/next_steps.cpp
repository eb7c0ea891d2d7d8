// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/report/next_steps.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "assessment/report/messages.h"

namespace tactooth {
namespace {

/// A sentence in both languages; {} is what was measured, and where.
struct Words {
    std::string_view english, japanese;

    [[nodiscard]] std::string_view in(Language language) const {
        return language == Language::Japanese ? japanese : english;
    }
};

/// Advice on a metric whose value is below or above what is ideal.
struct Advice {
    std::string_view metric;
    Words low, high;
};

constexpr std::array kAdvice = {
    Advice{"cleared_share",
           {"Clear the whole marked part before you refine: {} of it is cut.",
            "仕上げの前に、指定の部分をすべて削りましょう。削れたのはその {} です。"},
           {}},
    Advice{"dice",
           {"Keep to the marked part: the overlap with it is {}.", "指定の部分だけを削りましょう。一致度は {} です。"},
           {}},
    Advice{"over_max",
           {},
           {"Stop earlier, and look at the depth while you cut: you went {} beyond the ideal wall.",
            "深さを見ながら削り、もっと早く止めましょう。理想の壁を {} 越えました。"}},
    Advice{"over_volume",
           {},
           {"Take less sound tissue: {} too much was removed.",
            "健全な歯質をもっと残しましょう。{} を余分に削りました。"}},
    Advice{"under_volume",
           {},
           {"Go on until all of the marked part is cut: {} of it is left.",
            "指定の部分をすべて削りましょう。{} が残っています。"}},
    Advice{"deviation_rms",
           {},
           {"Follow the ideal walls more closely: you are {} off on average.",
            "理想の壁にもっと沿わせましょう。ずれは平均 {} です。"}},
    Advice{"within_0_1",
           {"Follow the ideal walls more closely: {} of the surface lies within 0.1 mm.",
            "理想の壁にもっと沿わせましょう。0.1 mm 以内にあるのは面の {} です。"},
           {}},
    Advice{"within_0_2",
           {"Follow the ideal walls more closely: {} of the surface lies within 0.2 mm.",
            "理想の壁にもっと沿わせましょう。0.2 mm 以内にあるのは面の {} です。"},
           {}},
    Advice{"within_0_3",
           {"Follow the ideal walls more closely: {} of the surface lies within 0.3 mm.",
            "理想の壁にもっと沿わせましょう。0.3 mm 以内にあるのは面の {} です。"},
           {}},
    Advice{"within_0_4",
           {"Follow the ideal walls more closely: {} of the surface lies within 0.4 mm.",
            "理想の壁にもっと沿わせましょう。0.4 mm 以内にあるのは面の {} です。"},
           {}},
    Advice{"floor_depth_median",
           {"Cut the floor deeper: it lies at {}.", "窩底をもっと深くしましょう。深さは {} です。"},
           {"Keep the floor shallower: it lies at {}.", "窩底をもっと浅くしましょう。深さは {} です。"}},
    Advice{"floor_depth_p95",
           {"Cut the floor deeper: its deepest part lies at {}.", "窩底をもっと深くしましょう。最深部は {} です。"},
           {"Keep the floor as deep everywhere: its deepest part lies at {}.",
            "窩底の深さをどこも同じにしましょう。最深部は {} です。"}},
    Advice{"floor_flatness",
           {},
           {"Move the bur level to make the floor flat: it varies by {}.",
            "バーを水平に動かして窩底を平らにしましょう。凹凸は {} です。"}},
    Advice{"floor_tilt",
           {},
           {"Hold the bur along the axis: the floor is tilted by {}.",
            "バーを軸に沿って持ちましょう。窩底が {} 傾いています。"}},
    Advice{"wall_angle_b",
           {"Tilt the bur so that the buccal wall converges more toward its opening: it is at {}.",
            "頬側壁が開口に向かってもっと収束するように、バーを傾けましょう。角度は {} です。"},
           {"Tilt the bur so that the buccal wall converges less toward its opening: it is at {}.",
            "頬側壁の開口への収束がもっと小さくなるように、バーを傾けましょう。角度は {} です。"}},
    Advice{"wall_angle_l",
           {"Tilt the bur so that the lingual wall converges more toward its opening: it is at {}.",
            "舌側壁が開口に向かってもっと収束するように、バーを傾けましょう。角度は {} です。"},
           {"Tilt the bur so that the lingual wall converges less toward its opening: it is at {}.",
            "舌側壁の開口への収束がもっと小さくなるように、バーを傾けましょう。角度は {} です。"}},
    Advice{"wall_angle_m",
           {"Tilt the bur so that the mesial wall converges more toward its opening: it is at {}.",
            "近心壁が開口に向かってもっと収束するように、バーを傾けましょう。角度は {} です。"},
           {"Tilt the bur so that the mesial wall converges less toward its opening: it is at {}.",
            "近心壁の開口への収束がもっと小さくなるように、バーを傾けましょう。角度は {} です。"}},
    Advice{"wall_angle_d",
           {"Tilt the bur so that the distal wall converges more toward its opening: it is at {}.",
            "遠心壁が開口に向かってもっと収束するように、バーを傾けましょう。角度は {} です。"},
           {"Tilt the bur so that the distal wall converges less toward its opening: it is at {}.",
            "遠心壁の開口への収束がもっと小さくなるように、バーを傾けましょう。角度は {} です。"}},
    Advice{"extent_md",
           {"Extend the preparation to mesial and distal: it is {} long.",
            "形成を近遠心方向に広げましょう。長さは {} です。"},
           {"Keep the preparation shorter from mesial to distal: it is {} long.",
            "形成を近遠心方向にもっと短くしましょう。長さは {} です。"}},
    Advice{
        "extent_bl",
        {"Widen the preparation to buccal and lingual: it is {} wide.", "形成を頬舌方向に広げましょう。幅は {} です。"},
        {"Keep the preparation narrower from buccal to lingual: it is {} wide.",
         "形成を頬舌方向にもっと狭くしましょう。幅は {} です。"}},
    Advice{"extent_og",
           {"Extend the preparation along the tooth: it is {} high.", "形成を歯軸方向に広げましょう。高さは {} です。"},
           {"Keep the preparation lower along the tooth: it is {} high.",
            "形成を歯軸方向にもっと低くしましょう。高さは {} です。"}},
    Advice{"toc_md",
           {"Taper the mesial and distal walls more: they converge by {}.",
            "近心壁と遠心壁のテーパーを大きくしましょう。収束角は {} です。"},
           {"Hold the bur along the axis: the mesial and distal walls converge by {}.",
            "バーを軸に沿って持ちましょう。近心壁と遠心壁の収束角は {} です。"}},
    Advice{"toc_bl",
           {"Taper the buccal and lingual walls more: they converge by {}.",
            "頬側壁と舌側壁のテーパーを大きくしましょう。収束角は {} です。"},
           {"Hold the bur along the axis: the buccal and lingual walls converge by {}.",
            "バーを軸に沿って持ちましょう。頬側壁と舌側壁の収束角は {} です。"}},
    Advice{"finish_line_width",
           {"Cut the finish line wider: it is {}.", "フィニッシュラインの幅を広くしましょう。幅は {} です。"},
           {"Keep the finish line narrower: it is {}.", "フィニッシュラインの幅を狭くしましょう。幅は {} です。"}},
    Advice{"isthmus_min",
           {"Widen the isthmus: it is {}.", "峡部を広げましょう。幅は {} です。"},
           {"Keep the isthmus narrower: it is {}.", "峡部をもっと狭くしましょう。幅は {} です。"}},
    Advice{"ridge_min_m",
           {"Stay farther from the mesial ridge: {} is left.", "近心辺縁隆線からもっと離れましょう。残りは {} です。"},
           {"Go nearer to the mesial ridge: {} is left.", "近心辺縁隆線にもっと近づけましょう。残りは {} です。"}},
    Advice{"ridge_min_d",
           {"Stay farther from the distal ridge: {} is left.", "遠心辺縁隆線からもっと離れましょう。残りは {} です。"},
           {"Go nearer to the distal ridge: {} is left.", "遠心辺縁隆線にもっと近づけましょう。残りは {} です。"}},
    Advice{"ridge_kept",
           {"Stay farther from the marginal ridge: {} is left.", "辺縁隆線からもっと離れましょう。残りは {} です。"},
           {"Go nearer to the marginal ridge: {} is left.", "辺縁隆線にもっと近づけましょう。残りは {} です。"}},
    Advice{"undercut_depth",
           {"Undercut the wall a little: {} is there.", "壁に少しアンダーカットを付けましょう。現在は {} です。"},
           {"Hold the bur upright, so that nothing hangs over: there is an undercut of {}.",
            "張り出しができないように、バーをまっすぐ持ちましょう。アンダーカットは {} です。"}},
    Advice{"undercut_area",
           {},
           {"Hold the bur upright, so that nothing hangs over: {} are undercut.",
            "張り出しができないように、バーをまっすぐ持ちましょう。アンダーカットの面積は {} です。"}},
    Advice{"remaining_dentin_min",
           {"Leave more dentin over the pulp: {} is left.", "歯髄の上の象牙質をもっと残しましょう。残りは {} です。"},
           {}},
    Advice{"pulp_open",
           {"Open the pulp chamber: it is still closed.", "髄室を開けましょう。まだ閉じています。"},
           {"Stop before the pulp: it was opened. Look at the dentin that is left beside the tip.",
            "歯髄の手前で止めましょう。露髄しました。バー先端の横に示される残存象牙質を見てください。"}},
    Advice{"forbidden_volume",
           {},
           {"Keep away from the forbidden zones: {} was removed there.",
            "切削禁止域には触れないようにしましょう。{} を削りました。"}},
    Advice{"neighbour_depth_max",
           {},
           {"Keep the bur away from the tooth beside: it was cut {} deep.",
            "バーを隣在歯から離しましょう。深さ {} まで削りました。"}},
    Advice{
        "contact_gap_gingival",
        {"Clear the contact at the gingival margin: {} is open.", "歯肉側の接触を離開させましょう。隙間は {} です。"},
        {"Stay nearer to the tooth beside at the gingival margin: {} is open.",
         "歯肉側では隣在歯との隙間を小さくしましょう。隙間は {} です。"}},
    Advice{"contact_gap_buccal",
           {"Clear the contact at the buccal margin: {} is open.", "頬側の接触を離開させましょう。隙間は {} です。"},
           {"Keep the box narrower to buccal: {} is open to the tooth beside.",
            "隣接面窩洞を頬側で狭くしましょう。隣在歯との隙間は {} です。"}},
    Advice{"contact_gap_lingual",
           {"Clear the contact at the lingual margin: {} is open.", "舌側の接触を離開させましょう。隙間は {} です。"},
           {"Keep the box narrower to lingual: {} is open to the tooth beside.",
            "隣接面窩洞を舌側で狭くしましょう。隣在歯との隙間は {} です。"}},
    Advice{"unsupported_enamel",
           {},
           {"Remove enamel without dentin below: there are {}.",
            "下に象牙質のないエナメル質を除去しましょう。{} あります。"}},
    Advice{"finish_line_roughness",
           {},
           {"Finish the margin in one even stroke: it is {} rough.",
            "辺縁は一続きの滑らかな動きで仕上げましょう。粗さは {} です。"}},
    Advice{
        "decay_left", {}, {"Remove all decay: {} of it is left.", "う蝕をすべて除去しましょう。{} が残っています。"}},
    Advice{"decay_share",
           {"Remove all decay: {} of it is gone.", "う蝕をすべて除去しましょう。除去できたのは {} です。"},
           {}},
    Advice{"removed_dentin",
           {},
           {"Stop at the dentin: {} of it was removed.", "象牙質の手前で止めましょう。{} を削りました。"}},
    Advice{"over_enamel",
           {},
           {"Spare sound enamel: {} was removed without need.",
            "健全なエナメル質を残しましょう。{} を不必要に削りました。"}},
    Advice{
        "over_dentin",
        {},
        {"Spare sound dentin: {} was removed without need.", "健全な象牙質を残しましょう。{} を不必要に削りました。"}},
    Advice{
        "force_mean",
        {},
        {"Press less, and let the bur cut: {} on average.", "押す力を弱め、バーに切らせましょう。力は平均 {} です。"}},
    Advice{"force_p95",
           {},
           {"Press less, and let the bur cut: often {}.",
            "押す力を弱め、バーに切らせましょう。力はしばしば {} に達します。"}},
    Advice{"force_over_2n",
           {},
           {"Press less, and let the bur cut: more than 2 N for {} of the time.",
            "押す力を弱め、バーに切らせましょう。2 N を超えたのは時間の {} です。"}},
    Advice{"force_peak", {}, {"Avoid hard contacts: {} at most.", "強い接触を避けましょう。力は最大 {} です。"}},
    Advice{"idle_time",
           {},
           {"Let the bur turn only when it is to cut: it turned in the air for {}.",
            "バーは削るときだけ回しましょう。空転は {} でした。"}},
};

std::string adviceOn(const AssessmentReport& report, const CriterionScore& each, Language language) {
    const Criterion& criterion = *each.criterion;
    const double value = *each.measured.value;
    const bool isLow = value < criterion.levels.ranges()[0].low;
    std::string measured = valueText(*criterion.metric, value, language);
    const std::string where = placeAndMomentText(report, each.measured, language);
    if (!where.empty()) measured = Message(msg::kMeasuredThere, measured, where).in(language);
    const auto* const advice = std::ranges::find(kAdvice, criterion.metric->id, &Advice::metric);
    const Words words = advice == kAdvice.end() ? Words() : isLow ? advice->low : advice->high;
    if (words.english.empty()) {
        return Message(isLow ? msg::kMoreIsIdeal : msg::kLessIsIdeal, criterion.titleIn(language), measured)
            .in(language);
    }
    return fmt::format(fmt::runtime(words.in(language)), measured);
}

}  // namespace

std::vector<std::string> nextSteps(const AssessmentReport& report, Language language) {
    constexpr std::size_t kMost = 2;
    constexpr double kLeastLoss = 1;  // points of the mark
    std::vector<const CriterionScore*> costly;
    const auto limits = [&](const CriterionScore& each) {
        return std::ranges::find(report.mark.limitedBy, each.criterion) != report.mark.limitedBy.end();
    };
    for (const CriterionScore& each : report.mark.criteria) {
        if (each.score && (each.lost >= kLeastLoss || limits(each))) costly.push_back(&each);
    }
    std::ranges::stable_sort(costly, [&](const CriterionScore* a, const CriterionScore* b) {
        if (limits(*a) != limits(*b)) return limits(*a);
        return a->lost > b->lost;
    });
    std::vector<std::string> steps;
    for (const CriterionScore* each : costly) {
        if (steps.size() < kMost) steps.push_back(adviceOn(report, *each, language));
    }
    if (steps.empty()) steps.emplace_back(msg::kNothingCosts.in(language));
    return steps;
}

}  // namespace tactooth
