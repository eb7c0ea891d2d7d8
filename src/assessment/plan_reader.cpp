// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "assessment/plan_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "assessment/exercise_keys.h"
#include "assessment/messages.h"
#include "assessment/outline/flat_outline.h"
#include "geometry/util/number_text.h"
#include "instruments/bur_outline.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr double kLargestTooth = 50;  // mm: more than a molar is long, roots and all
constexpr std::size_t kMaxStrokes = 200;
constexpr double kMostLeft = 10;                         // mm of tooth beside a cavity: a whole crown
constexpr double kWidestOutline = 8;                     // mm
constexpr double kLeastFinish = 0.1, kWidestFinish = 3;  // mm: width of a finish line
constexpr double kHighestFinish = 8;                     // mm: a whole crown
constexpr double kRoundest = 0.5;                        // mm: half of the end of an incisor's stump
constexpr double kLeastTaper = 1;                        // degrees

}  // namespace

Vec3 sideIn(TomlReader& toml, const toml::table& table, double mesialX) {
    const toml::node* node = table.get("side");
    if (node != nullptr && node->is_array()) {
        Vec3 outward = Vec3::Zero();
        toml.numbers(table, "side", {outward.data(), 3});
        constexpr double kExact = 1e-12;  // numbers that this program has written come back bit for bit
        if (outward.norm() > 0) return std::abs(outward.norm() - 1) < kExact ? outward : outward.normalized();
        toml.fail(*node, msg::kSideWithoutDirection);
        return Vec3::UnitZ();
    }
    const std::string name = toml.text(table, "side", false);
    for (const auto& [key, outward] : sideKeys(mesialX)) {
        if (name == key) return outward;
    }
    if (!name.empty()) toml.fail(*node, msg::kSideUnknown);
    return Vec3::UnitZ();
}

Vec3 placeIn(TomlReader& toml, const toml::table& table, std::string_view key) {
    Vec3 place = Vec3::Zero();
    toml.numbers(table, key, {place.data(), 3});
    if (place.cwiseAbs().maxCoeff() > kFarthest) toml.fail(*table.get(key), msg::kPlaceTooFar);
    return place;
}

namespace {

/// Three numbers, near the tooth.
std::optional<Vec3> placeOf(const toml::node& node) {
    const toml::array* const numbers = node.as_array();
    if (numbers == nullptr || numbers->size() != 3) return std::nullopt;
    Vec3 place;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = numbers->get(i)->value<double>();
        if (!numbers->get(i)->is_number() || !number || !(std::abs(*number) <= kFarthest)) return std::nullopt;
        place[static_cast<Eigen::Index>(i)] = *number;
    }
    return place;
}

}  // namespace

std::vector<Vec3> placesIn(TomlReader& toml, const toml::table& table, std::string_view key, std::size_t least,
                           std::size_t most, const MessageText& mistake) {
    const toml::node* const node = table.get(key);
    const toml::array* const list = node != nullptr ? node->as_array() : nullptr;
    if (list == nullptr || list->size() < least || list->size() > most) {
        toml.fail(node != nullptr ? *node : static_cast<const toml::node&>(table), {mistake, most});
        return {};
    }
    std::vector<Vec3> places;
    for (const toml::node& each : *list) {
        const std::optional<Vec3> place = placeOf(each);
        if (!place) {
            toml.fail(each, {mistake, most});
            return {};
        }
        places.push_back(*place);
    }
    return places;
}

std::vector<Vec3> cornersIn(TomlReader& toml, const toml::table& table, const Vec3& outward) {
    std::vector<Vec3> corners = placesIn(toml, table, "corners", 3, kMostCorners, msg::kCornersNeeded);
    if (corners.empty()) return corners;
    const toml::node& node = *table.get("corners");
    Box3 box;
    for (const Vec3& corner : corners) box.extend(corner);
    // A cavity is searched place by place: that of a jaw would take hours.
    if (box.sizes().maxCoeff() > kLargestTooth) toml.fail(node, msg::kDrawnOutlineTooLarge);
    if (FlatOutline(corners, outward).crossesItself()) toml.fail(node, msg::kDrawnOutlineCrosses);
    return corners;
}

PlanReader::PlanReader(TomlReader& toml, const std::variant<ToothRequest, ToothSource>& tooth,
                       std::optional<BurSpec> bur)
    : toml_(toml), tooth_(tooth), bur_(std::move(bur)), mesialX_(toothMesialX(tooth)) {}

PreparationPlan PlanReader::read(const toml::table& cavity) {
    toml_.allow(cavity, msg::kACavity,
                {"side", "depth", "floor", "depth_stop", "strokes", "fissure", "outline", "boxes", "removes", "crown"});
    PreparationPlan plan;
    plan.outward = sideIn(toml_, cavity, mesialX_);
    if (cavity.get("depth") == nullptr) toml_.fail(cavity, {msg::kKeyMissing, "depth"});
    plan.depth = toml_.number(cavity, "depth", 1, kMinDepth, kMaxDepth);
    const std::string floor = toml_.text(cavity, "floor", false);
    plan.isFlat = floor != "surface";
    if (!floor.empty() && floor != "flat" && floor != "surface") {
        toml_.fail(*cavity.get("floor"), msg::kFloorUnknown);
    }
    plan.stopsDevice = toml_.flag(cavity, "depth_stop", false);
    const std::vector<const toml::table*> strokes = toml_.tables(cavity, "strokes");
    const bool isFromAbove = plan.isFlat && plan.outward == Vec3::UnitZ();
    const std::vector<const toml::table*> boxes = toml_.tables(cavity, "boxes");
    if (const toml::table* crown = toml_.table(cavity, "crown")) {
        const bool hasMore = cavity.get("fissure") != nullptr || cavity.get("outline") != nullptr ||
                             cavity.get("removes") != nullptr || cavity.get("boxes") != nullptr;
        if (!strokes.empty() || hasMore) toml_.fail(*crown, msg::kCrownUnfit);
        plan.crown = readCrown(*crown);
        return plan;
    }
    if (const toml::table* fissure = toml_.table(cavity, "fissure")) {
        if (!isFromAbove || !strokes.empty() || cavity.get("outline") != nullptr)
            toml_.fail(*fissure, msg::kFissureUnfit);
        readBoxes(boxes, plan);
        readFissure(*fissure, plan);
        return plan;
    }
    if (const toml::table* outline = toml_.table(cavity, "outline")) {
        if (!strokes.empty() || cavity.get("removes") != nullptr) toml_.fail(*outline, msg::kOutlineUnfit);
        if (!boxes.empty() && !isFromAbove) toml_.fail(*boxes.front(), msg::kBoxUnfit);
        readBoxes(boxes, plan);
        readOutline(*outline, plan);
        return plan;
    }
    if (const toml::table* body = toml_.table(cavity, "removes")) {
        if (!strokes.empty()) toml_.fail(*body, msg::kBodyUnfit);
        readBody(*body, plan);
        return plan;
    }
    if (cavity.get("boxes") != nullptr) toml_.fail(*cavity.get("boxes"), msg::kBoxWithoutFissure);
    if (strokes.empty()) toml_.fail(cavity, msg::kNoStrokes);
    if (strokes.size() > kMaxStrokes) toml_.fail(cavity, msg::kTooManyStrokes);
    for (const toml::table* each : strokes) plan.strokes.push_back(stroke(*each));
    return plan;
}

/// An outline along the fissure, with the boxes at its ends.
void PlanReader::readFissure(const toml::table& table, PreparationPlan& plan) {
    toml_.allow(table, msg::kAFissure, {"width", "mesial", "distal"});
    const auto* request = std::get_if<ToothRequest>(&tooth_);
    if (request != nullptr && isAnteriorTooth(request->fdi)) toml_.fail(table, msg::kNoFissure);
    if (!bur_) return toml_.fail(table, msg::kOutlineNeedsBur);
    FissureOutline outline{
        .width = toml_.number(table, "width", bur_->headDiameter, bur_->headDiameter, kWidestOutline),
        .burRadius = bur_->headDiameter / 2,
        .leftPlusX = {},
        .leftMinusX = {}};
    for (const std::string_view name : {"mesial", "distal"}) {
        const double towardX = name == "mesial" ? mesialX_ : -mesialX_;
        const bool hasBox = std::ranges::count(plan.boxes, towardX, &ProximalBox::towardX) > 0;
        if (hasBox == (table.get(name) != nullptr)) toml_.fail(table, {msg::kRidgeOrBox, name});
        if (!hasBox)
            (towardX > 0 ? outline.leftPlusX : outline.leftMinusX) = toml_.number(table, name, 0, 0, kMostLeft);
    }
    plan.fissure = outline;
}

/// An outline that somebody has drawn.
void PlanReader::readOutline(const toml::table& table, PreparationPlan& plan) {
    toml_.allow(table, msg::kAnOutline, {"corners", "taper"});
    if (!bur_) return toml_.fail(table, msg::kOutlineNeedsBur);
    plan.outline = {.corners = cornersIn(toml_, table, plan.outward),
                    .taperDegrees = toml_.number(table, "taper", 0, 0, kMostTaper),
                    .burRadius = bur_->headDiameter / 2,
                    .burLength = bur_->headLength};
}

/// A body inside the tooth that the cavity removes.
void PlanReader::readBody(const toml::table& table, PreparationPlan& plan) {
    toml_.allow(table, msg::kABody, {"tissue", "below", "open"});
    std::array<std::string_view, kBodyKeys.size()> tissues;
    std::ranges::transform(kBodyKeys, tissues.begin(), &std::pair<std::string_view, MaterialRole>::first);
    const MaterialRole role = kBodyKeys.at(choice(toml_, table, "tissue", tissues, msg::kTissueUnknown, 0)).second;
    const bool isPulp = role == MaterialRole::Pulp;
    if (!bur_) return toml_.fail(table, msg::kOutlineNeedsBur);
    plan.body = {.role = role, .burRadius = bur_->headDiameter / 2, .burLength = bur_->headLength, .below = {}};
    if (isPulp && table.get("below") == nullptr) toml_.fail(table, {msg::kKeyMissing, "below"});
    if (table.get("below") != nullptr) plan.body->below = toml_.number(table, "below", 1, kMinDepth, kMaxDepth);
    if (table.get("open") != nullptr) plan.body->openTo = openSide(table, plan);
}

/// The side to which a cavity is open.
std::optional<Vec3> PlanReader::openSide(const toml::table& table, const PreparationPlan& plan) {
    const auto sides = sideKeys(mesialX_);
    const std::string name = toml_.text(table, "open", false);
    const auto* const known = std::ranges::find(sides, name, &std::pair<std::string_view, Vec3>::first);
    if (known == sides.end()) {
        toml_.fail(*table.get("open"), msg::kOpenSideUnknown);
        return std::nullopt;
    }
    constexpr double kAcross = 0.5;  // sine of the least angle to the shaft
    const bool isAcross = known->second.cross(plan.outward).norm() >= kAcross;
    if (!isAcross || plan.body->role == MaterialRole::Pulp) toml_.fail(*table.get("open"), msg::kOpenSideUnfit);
    return known->second;
}

/// A crown preparation.
std::optional<CrownOutline> PlanReader::readCrown(const toml::table& table) {
    toml_.allow(
        table, msg::kACrown,
        {"finish", "width", "height", "proximal_height", "mesial_height", "distal_height", "taper", "buccal_taper",
         "axial", "buccal", "lingual", "occlusal", "incisal", "functional", "functional_side", "rounding", "cervical"});
    if (!bur_) {
        toml_.fail(table, msg::kOutlineNeedsBur);
        return std::nullopt;
    }
    for (const std::string_view key : {"finish", "width", "height", "taper"}) {
        if (table.get(key) == nullptr) toml_.fail(table, {msg::kKeyMissing, key});
    }
    CrownOutline crown{};
    crown.isIncisal = table.get("incisal") != nullptr;
    if (crown.isIncisal == (table.get("occlusal") != nullptr)) toml_.fail(table, msg::kOcclusalOrIncisal);
    crown.width = toml_.number(table, "width", kLeastFinish, kLeastFinish, kWidestFinish);
    crown.height = toml_.number(table, "height", 1, -1, kHighestFinish);
    const double proximal = toml_.number(table, "proximal_height", crown.height, -1, kHighestFinish);
    const double mesial = toml_.number(table, "mesial_height", proximal, -1, kHighestFinish);
    const double distal = toml_.number(table, "distal_height", proximal, -1, kHighestFinish);
    crown.plusXHeight = mesialX_ > 0 ? mesial : distal;
    crown.minusXHeight = mesialX_ > 0 ? distal : mesial;
    crown.taper = toml_.number(table, "taper", kLeastTaper, kLeastTaper, kMostTaper);
    crown.buccalTaper = toml_.number(table, "buccal_taper", crown.taper, kLeastTaper, kMostTaper);
    const double axial = toml_.number(table, "axial", crown.width, kMinDepth, kWidestFinish);
    crown.buccal = toml_.number(table, "buccal", axial, kMinDepth, kWidestFinish);
    crown.lingual = toml_.number(table, "lingual", axial, kMinDepth, kWidestFinish);
    crown.rounding = toml_.number(table, "rounding", 0, 0, kRoundest);
    crown.occlusal = toml_.number(table, crown.isIncisal ? "incisal" : "occlusal", 1, kMinDepth, kHighestFinish);
    for (const std::string_view key : {"functional", "functional_side"}) {
        if (crown.isIncisal && table.get(key) != nullptr) toml_.fail(*table.get(key), {msg::kNoFunctionalCusps, key});
    }
    crown.functional = toml_.number(table, "functional", crown.occlusal, kMinDepth, kHighestFinish);
    constexpr std::array<std::string_view, 2> kFunctionalSides = {"buccal", "lingual"};
    const auto* request = std::get_if<ToothRequest>(&tooth_);
    const bool isUpper = request != nullptr && request->fdi / 10 <= 2;
    const std::size_t side =
        choice(toml_, table, "functional_side", kFunctionalSides, msg::kFunctionalSide, isUpper ? 1 : 0);
    crown.functionalSide = side == 0 ? 1 : -1;
    crown.tipRadius = endRadius(*bur_);
    if (table.get("cervical") != nullptr) crown.cervical = toml_.number(table, "cervical", 0, -kFarthest, kFarthest);
    constexpr std::array<std::string_view, 2> kFinishes = {"chamfer", "shoulder"};
    const bool isChamfer = choice(toml_, table, "finish", kFinishes, msg::kFinishUnknown, 0) == 0;
    if (isChamfer && crown.tipRadius < crown.width)
        toml_.fail(table, {msg::kChamferNeedsRoundEnd, numberText(std::round(1000 * crown.tipRadius) / 1000)});
    return crown;
}

void PlanReader::readBoxes(const std::vector<const toml::table*>& boxes, PreparationPlan& plan) {
    if (!bur_) return;
    for (const toml::table* each : boxes) plan.boxes.push_back(box(*each));
    if (plan.boxes.size() > 2 || (plan.boxes.size() == 2 && plan.boxes[0].towardX == plan.boxes[1].towardX))
        toml_.fail(*boxes.back(), msg::kBoxTwice);
}

ProximalBox PlanReader::box(const toml::table& table) {
    const double diameter = bur_->headDiameter;
    toml_.allow(table, msg::kABox, {"side", "width", "axial_depth", "axial_height"});
    for (const std::string_view key : {"width", "axial_depth", "axial_height"}) {
        if (table.get(key) == nullptr) toml_.fail(table, {msg::kKeyMissing, key});
    }
    constexpr std::array<std::string_view, 2> kSidesOfBox = {"mesial", "distal"};
    const bool isDistal = choice(toml_, table, "side", kSidesOfBox, msg::kBoxSide, 0) == 1;
    return {.towardX = isDistal ? -mesialX_ : mesialX_,
            .width = toml_.number(table, "width", diameter, diameter, kMaxBox),
            .axialDepth = toml_.number(table, "axial_depth", diameter, diameter, kMaxBox),
            .axialHeight = toml_.number(table, "axial_height", 1, kMinDepth, kMaxBox)};
}

PreparationPlan::Stroke PlanReader::stroke(const toml::table& table) {
    toml_.allow(table, msg::kAStroke, {"from", "to", "depth"});
    if (table.get("from") == nullptr) toml_.fail(table, {msg::kKeyMissing, "from"});
    PreparationPlan::Stroke stroke{Vec3::Zero(), Vec3::Zero(), {}};
    toml_.numbers(table, "from", {stroke.from.data(), 3});
    stroke.to = stroke.from;  // a pit
    toml_.numbers(table, "to", {stroke.to.data(), 3});
    if (table.get("depth") != nullptr) stroke.depth = toml_.number(table, "depth", 1, kMinDepth, kMaxDepth);
    const bool isNear = std::max(stroke.from.cwiseAbs().maxCoeff(), stroke.to.cwiseAbs().maxCoeff()) <= kFarthest;
    if (!isNear || (stroke.to - stroke.from).norm() > kLargestTooth) {
        toml_.fail(table, msg::kStrokeTooLong);
    }
    return stroke;
}

}  // namespace tactooth
