// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
//
// The margin is 1 mm above the cervical line (the depth of a healthy sulcus) and rises between two teeth to a papilla.
// The papilla is a pyramid with its tip below the contact of the teeth, where they leave room, and its faces fall from
// there to the cheek and to the tongue. It is about 3 mm high (Golestan: 3.1 mm with a standard deviation of 0.65 mm).
// The thickness is 1 mm at the margin, and larger below. All else follows textbook drawings.
#include "instruments/mouth/gingiva.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "instruments/modelling/blend.h"

namespace tactooth {
namespace {

constexpr double kBehind = 8.5;  // mm that the jaw continues behind the last tooth

/// The margin at one tooth: its lowest points on the facial and the lingual side.
struct ToothMargin {
    double s = 0;        ///< along the line
    double facial = 0;   ///< height toward the crowns
    double lingual = 0;  ///< likewise
    double middle = 0;   ///< outward from the line: the tooth's axis at the neck
    double half = 0;     ///< half the width of the neck, facial to lingual
    bool missing = false;
};

/// The place between two teeth.
struct Papilla {
    double s = 0;
    double tip = 0;      ///< height toward the crowns
    double outward = 0;  ///< of the tip, from the line
};

/// A tooth with a socket in the gingiva.
struct SocketTooth {
    ScalarField outer;
    Box3 bounds;  ///< of its shape
    Pose mouthInShape;
    bool mirrored;  ///< it is on the other side of the mouth
    double s;
};

class Gingiva {
public:
    Gingiva(const ToothArrangement& places, bool upper, const std::vector<int>& missing);

    /// The body with its sockets.
    [[nodiscard]] double operator()(const Vec3& p) const;
    /// The body as it is drawn.
    [[nodiscard]] double shown(const Vec3& p) const;
    [[nodiscard]] double zone(const Vec3& p) const;
    [[nodiscard]] Box3 bounds() const;
    [[nodiscard]] double smoothBelow() const { return std::min(facial_, lingual_) - 3; }

private:
    /// The gingiva at a point along the line; heights toward the crowns, mm.
    struct Line {
        double facial = 0, lingual = 0;  ///< the margin at the outer and the inner face of the ridge
        double tip = 0, outward = 0;     ///< of the nearest papilla
        double rise = 0;                 ///< from the margin of a tooth, 0, to the papilla, 1
        double middle = 0, half = 0;     ///< of the ridge: outward from the line; half its width at the margin
    };
    /// A point and what the body is made of there.
    struct Place {
        double crownward = 0;  ///< height toward the crowns
        ArchCurve::Coordinates at;
        Line line;
        double depth = 0;            ///< below the margin
        double tooth = 0, next = 0;  ///< distances to the nearest tooth and to the next nearest
    };
    [[nodiscard]] Place placeOf(const Vec3& p) const;
    [[nodiscard]] double tissue(const Vec3& p, const Place& place) const;
    [[nodiscard]] double bounded(double body, const Vec3& p, const Place& place) const;
    void addSide(const JawQuadrant& side, bool right, const std::vector<int>& missing);
    void addPapillae(const JawQuadrant& side);
    void heal();
    void fillTable();
    [[nodiscard]] Line marginAt(double s) const;
    [[nodiscard]] double marginOver(double outward, const Line& line) const;
    [[nodiscard]] Line ridgeAt(double s) const;
    [[nodiscard]] Line lookUp(double s) const;
    [[nodiscard]] double toTeeth(const Vec3& p, double s, double& second) const;
    [[nodiscard]] double ridge(double along, double out, double crownward, const Line& line) const;
    [[nodiscard]] double palate(const Vec3& p) const;

    ArchCurve line_;
    bool upper_;
    double end_ = 0;                    // of the teeth, along the line
    double back_ = 0;                   // y of the jaw's flat hind end
    double base_ = 0;                   // height of its flat far end, below all roots
    double facial_ = 0, lingual_ = 0;   // mean heights of the margins
    std::vector<ToothMargin> margins_;  // from the patient's left to the right
    std::vector<Papilla> papillae_;     // one more than margins: before the first, between, after the last
    std::vector<SocketTooth> teeth_;
    std::vector<Line> table_;
};

constexpr double kTableStep = 0.2, kTableEnd = 90;  // mm along the line, to both sides

Gingiva::Gingiva(const ToothArrangement& places, bool upper, const std::vector<int>& missing)
    : line_(places.line), upper_(upper) {
    const JawQuadrant& side = upper ? places.upper : places.lower;
    addSide(side, false, missing);
    std::ranges::reverse(margins_);
    addSide(side, true, missing);
    for (const ToothMargin& margin : margins_) {
        facial_ += margin.facial / static_cast<double>(margins_.size());
        lingual_ += margin.lingual / static_cast<double>(margins_.size());
    }
    end_ = margins_.back().s + 5;
    back_ = line_.at(end_ + kBehind - 3).point.y();
    addPapillae(side);
    heal();
    fillTable();
}

void Gingiva::addPapillae(const JawQuadrant& side) {
    const double sign = upper_ ? -1 : 1;
    std::vector<Papilla> right;
    for (std::size_t i = 0; i < kTeethPerQuadrant; ++i) {
        const Vec3& contact = side.contacts[i].point;
        constexpr double kBelowContact = 1.0;  // mm
        constexpr double kHighest = 4.4;       // mm over the margins beside it: Golestan's mean and two deviations
        const double here = margins_[kTeethPerQuadrant + i].facial;
        const double before = i > 0 ? margins_[kTeethPerQuadrant + i - 1].facial : here;
        const double tip = std::min(sign * contact.z() - kBelowContact, (here + before) / 2 + kHighest);
        const auto at = line_.of(contact.x(), contact.y());
        right.push_back({i == 0 ? 0 : std::abs(at.s), tip, at.outward});
    }
    constexpr double kLast = 1.2;  // mm: behind the last tooth it rises little
    right.push_back({end_ + 1, margins_.back().facial + kLast, margins_.back().middle});
    for (std::size_t i = kTeethPerQuadrant; i > 0; --i)
        papillae_.push_back({-right[i].s, right[i].tip, right[i].outward});
    papillae_.insert(papillae_.end(), right.begin(), right.end());
}

/// Where a tooth is missing, the tissue is a saddle between its papillae.
void Gingiva::heal() {
    constexpr double kHealed = 1.4;  // mm that it is below them
    for (std::size_t i = 0; i < margins_.size(); ++i) {
        if (!margins_[i].missing) continue;
        margins_[i].facial = margins_[i].lingual = (papillae_[i].tip + papillae_[i + 1].tip) / 2 - kHealed;
    }
}

void Gingiva::fillTable() {
    for (double s = -kTableEnd; s <= kTableEnd + kTableStep; s += kTableStep) {
        Line line = marginAt(s);
        const Line ridge = ridgeAt(s);
        line.middle = ridge.middle;
        line.half = ridge.half;
        table_.push_back(line);
    }
}

Gingiva::Line Gingiva::lookUp(double s) const {
    const double at = (std::clamp(s, -kTableEnd, kTableEnd) + kTableEnd) / kTableStep;
    const auto i = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(i);
    const Line &a = table_[i], &b = table_[i + 1];
    return {std::lerp(a.facial, b.facial, part), std::lerp(a.lingual, b.lingual, part),
            std::lerp(a.tip, b.tip, part),       std::lerp(a.outward, b.outward, part),
            std::lerp(a.rise, b.rise, part),     std::lerp(a.middle, b.middle, part),
            std::lerp(a.half, b.half, part)};
}

void Gingiva::addSide(const JawQuadrant& side, bool right, const std::vector<int>& missing) {
    const double sign = upper_ ? -1 : 1;
    const bool mirrored = right != upper_;  // the upper teeth of the right side, the lower ones of the left are given
    for (const PlacedShape& place : side.teeth) {
        const int quadrant = upper_ ? (right ? 1 : 2) : (right ? 4 : 3);
        const int fdi = 10 * quadrant + place.shape.fdi % 10;
        const bool isMissing = std::ranges::find(missing, fdi) != missing.end();
        const ToothShape& shape = place.shape;
        // The neck from its labial to its lingual side, in the middle of the tooth.
        constexpr double kStep = 0.05;
        const auto wallAt = [&](double direction, double z) {
            double y = 0;
            while (shape.outer(Vec3(0, y, z)) < 0) y += direction * kStep;
            return Vec3(0, y, z);
        };
        constexpr double kSulcus = 1.0;  // mm
        const auto marginAt = [&](double direction) {
            const double neck = -shape.cervical(wallAt(direction, 0));
            return Vec3(place.shapeInMouth * wallAt(direction, neck + kSulcus));
        };
        const Vec3 facial = marginAt(1), lingual = marginAt(-1);
        const auto at = line_.of(facial.x(), facial.y()), in = line_.of(lingual.x(), lingual.y());
        ToothMargin margin;
        margin.s = (right ? 1 : -1) * (std::abs(at.s) + std::abs(in.s)) / 2;
        margin.facial = sign * facial.z();
        margin.lingual = sign * lingual.z();
        margin.middle = (at.outward + in.outward) / 2;
        margin.half = (at.outward - in.outward) / 2;
        margin.missing = isMissing;
        margins_.push_back(margin);
        base_ = std::min(base_, sign * (place.shapeInMouth * Vec3(0, 0, shape.bounds.min().z())).z() - 1);
        if (isMissing) continue;
        teeth_.push_back({shape.outer, shape.bounds, place.shapeInMouth.inverse(), mirrored, margin.s});
    }
}

/// The margin: an arch around each tooth, between its papillae.
Gingiva::Line Gingiva::marginAt(double s) const {
    const auto after =
        static_cast<std::size_t>(std::ranges::upper_bound(margins_, s, {}, &ToothMargin::s) - margins_.begin());
    const Papilla& between = papillae_[after];
    const bool nearsBefore = after == margins_.size() || (after > 0 && s < between.s);
    const ToothMargin& tooth = margins_[nearsBefore ? after - 1 : after];
    const ToothMargin& other = margins_[nearsBefore ? std::min(after, margins_.size() - 1) : std::max(after, 1UL) - 1];
    const double part = std::clamp((s - tooth.s) / (between.s - tooth.s), 0.0, 1.0);
    constexpr double kScallop = 2.5;  // 1: a zigzag line, 2: arches
    Line line;
    line.facial = std::lerp(tooth.facial, (tooth.facial + other.facial) / 2, part * part);
    line.lingual = std::lerp(tooth.lingual, (tooth.lingual + other.lingual) / 2, part * part);
    line.tip = between.tip;
    line.outward = between.outward;
    // Rounding of a papilla's crest, as a share of the distance to the middle of the tooth.
    constexpr double kCrest = 0.1;
    const double beside = std::hypot(1 - part, kCrest) - kCrest;
    line.rise = std::pow(std::max(0.0, 1 - beside), kScallop);
    return line;
}

/// Height of the margin at a place across the ridge: between two teeth it falls from the papilla's tip to both faces.
double Gingiva::marginOver(double outward, const Line& line) const {
    const double across = smoothStep(-0.7 * line.half, 0.7 * line.half, outward - line.middle);
    const double margin = std::lerp(line.lingual, line.facial, across);
    constexpr double kTipHalf = 0.4,
                     kAtFace = 0.55;  // share of the distance to the face; share of the papilla's height left there
    constexpr double kMinReach = 2;   // mm
    const double aside = outward - line.outward;
    const double reach = std::max(line.half + (aside > 0 ? 1 : -1) * (line.middle - line.outward), kMinReach);
    const double left = 1 - (1 - kAtFace) * smoothStep(kTipHalf, 1, std::abs(aside) / reach);
    return margin + line.rise * left * (line.tip - margin);
}

/// The alveolar process follows the teeth's necks smoothly.
Gingiva::Line Gingiva::ridgeAt(double s) const {
    constexpr double kSmooth = 6;  // mm
    Line line;
    double weights = 0;
    const double along = std::clamp(s, margins_.front().s, margins_.back().s);
    for (const ToothMargin& tooth : margins_) {
        const double weight = bump(along - tooth.s, kSmooth);
        line.middle += weight * tooth.middle;
        line.half += weight * tooth.half;
        weights += weight;
    }
    line.middle /= weights;
    line.half /= weights;
    return line;
}

/// Distance to the nearest tooth, and to the next nearest; 4 mm and more are as far as any.
double Gingiva::toTeeth(const Vec3& p, double s, double& second) const {
    constexpr double kFar = 4, kAside = 9;  // mm; along the line
    double first = kFar;
    second = kFar;
    for (const SocketTooth& tooth : teeth_) {
        if (std::abs(tooth.s - s) > kAside) continue;
        const Vec3 local = tooth.mouthInShape * (tooth.mirrored ? Vec3(-p.x(), p.y(), p.z()) : p);
        if (tooth.bounds.squaredExteriorDistance(local) > kFar * kFar) continue;
        const double distance = tooth.outer(local);
        if (distance < first) {
            second = first;
            first = distance;
        } else {
            second = std::min(second, distance);
        }
    }
    return first;
}

/// The alveolar process: as wide as the teeth's necks at the margin, wider toward its base.
double Gingiva::ridge(double along, double out, double crownward, const Line& line) const {
    const double widening = smoothStep(0, 14, facial_ - crownward);
    constexpr double kCover = 0.55;  // mm
    // The lower molars' roots lean to the cheek: the oblique line of the mandible covers them.
    const double oblique =
        upper_ ? 0 : 2.6 * smoothStep(28, 50, std::abs(along)) * smoothStep(0, 9, facial_ - crownward);
    // Between two teeth the gingiva is concave, most on the side of the cheek. The concavity is small at the anterior
    // teeth, where the gingiva is too thin for it.
    constexpr double kGroove = 0.9, kAtFront = 0.3, kGrooveDeep = 8;  // mm; a part of it; below the margin
    const double groove = kGroove * std::lerp(kAtFront, 1.0, smoothStep(10, 22, std::abs(along))) *
                          std::sqrt(line.rise) * smoothStep(kGrooveDeep, 0, facial_ - crownward);
    const double facial = line.half + kCover - groove + oblique + (upper_ ? 0.8 : 1.2) * widening,
                 lingual = line.half + kCover - groove / 2 + (upper_ ? 2.5 : 1.2) * widening;
    const double half = (facial + lingual) / 2, middle = line.middle + (facial - lingual) / 2;
    return std::abs(out - middle) - half;
}

/// The vault, with incisive papilla, raphe and rugae.
double Gingiva::palate(const Vec3& p) const {
    constexpr double kHigh = 13, kWall = 4.5;                     // mm; from the line to the vault's foot
    constexpr double kFront = 7, kBack = 30, kBelowMargin = 1.5;  // mm behind the line's front; below the margins
    const double depth = -p.y(), aside = std::abs(p.x());
    const double half = std::max(line_.halfWidth(depth) - kWall, 2.0);
    const double across = std::max(0.0, 1 - std::pow(aside / half, 2.4));
    const double vault = lingual_ - kBelowMargin - kHigh * across * smoothStep(kFront, kBack, depth);
    const double raphe = 0.3 * bump(p.x(), 0.8) * smoothStep(12, 17, depth);
    const double incisive = bump(std::hypot(p.x() / 1.5, (depth - 11) / 2.8), 1.0);
    const double reach = smoothStep(0.9, 2.4, aside) * smoothStep(11.5, 8.5, aside) * smoothStep(10.5, 13, depth) *
                         smoothStep(27, 22, depth);
    constexpr double kRugae = 3.8;  // mm from one to the next
    const double wave = std::cos(2 * std::numbers::pi * (depth - 0.3 * aside - 0.5 * std::sin(0.8 * aside)) / kRugae);
    const double rugae = 0.4 * reach * std::max(0.0, wave);
    constexpr double kSlope = 1.5;
    return (-p.z() - vault - raphe - incisive - rugae) / kSlope;
}

Gingiva::Place Gingiva::placeOf(const Vec3& p) const {
    Place place;
    place.crownward = upper_ ? -p.z() : p.z();
    place.at = line_.of(p.x(), p.y());
    place.line = lookUp(place.at.s);
    // Behind the last tooth the tissue falls to the ridge.
    const double beyond = std::max(0.0, std::abs(place.at.s) - end_);
    place.depth = marginOver(place.at.outward, place.line) - 0.12 * beyond * beyond - place.crownward;
    place.tooth = toTeeth(p, place.at.s, place.next);
    return place;
}

/// The ridge, the cover of the roots and the palate, without an upper end and without sockets.
double Gingiva::tissue(const Vec3& p, const Place& place) const {
    constexpr double kThin = 0.6, kThick = 1.1, kDeep = 5;  // mm: thickness at the margin, and that deep below it
    constexpr double kJuga = 2, kNoJuga = 14, kFlat = 4;    // mm: depths between which the roots' ridges fade
    const double cover = place.tooth - std::lerp(kThin, kThick, smoothStep(0, kDeep, place.depth)) +
                         kFlat * smoothStep(kJuga, kNoJuga, place.depth);
    constexpr double kFillet = 2.2;
    double body = smoothUnion(ridge(place.at.s, place.at.outward, place.crownward, place.line), cover, kFillet);
    constexpr double kMinWall = 0.85, kWallRound = 0.5;  // mm: thinnest cover of a root
    body = smoothUnion(body, place.tooth - kMinWall, kWallRound);
    if (upper_) {
        constexpr double kFoot = 5;
        const double inside = (place.at.outward - place.line.middle) / 1.2;  // the vault ends within the ridge
        if (inside < body + kFoot) body = smoothUnion(body, std::max(palate(p), inside), kFoot);
    }
    return body;
}

/// The body as far as the jaw reaches: behind, and away from the crowns.
double Gingiva::bounded(double body, const Vec3& p, const Place& place) const {
    constexpr double kEndRound = 6, kBaseRound = 1.5;
    body = smoothIntersection(body, std::abs(place.at.s) - end_ - kBehind, kEndRound);
    body = smoothIntersection(body, back_ - p.y(), kBaseRound);
    return smoothIntersection(body, base_ - place.crownward, kBaseRound);
}

double Gingiva::operator()(const Vec3& p) const {
    const Place place = placeOf(p);
    constexpr double kMarginRound = 0.55, kSlope = 1.3, kSocketRound = 0.45, kTipRound = 0.5;
    double body = bounded(smoothIntersection(tissue(p, place), -place.depth / kSlope, kMarginRound), p, place);
    // mm: the periodontal ligament's; around the ends of roots wider, which are narrower than the facets of the socket.
    constexpr double kGap = 0.15, kDeepGap = 0.4, kRoots = 6, kEnds = 11;
    const double gap = std::lerp(kGap, kDeepGap, smoothStep(kRoots, kEnds, place.depth));
    constexpr double kThinnest = 0.7;  // mm between two teeth; no tissue is in a narrower gap
    body = smoothIntersection(body, kThinnest - (place.tooth + place.next), kTipRound);
    return smoothIntersection(body, gap - place.tooth, kSocketRound);
}

/// The margin falls away from the tooth like a knife's edge that lies on it, and a papilla fills the embrasure.
double Gingiva::shown(const Vec3& p) const {
    const Place place = placeOf(p);
    // Between two teeth the face of the ridge goes over into that of the papilla without an edge.
    constexpr double kMarginRound = 0.5, kPapillaRound = 2.5, kSlope = 1.8;
    const double round = std::lerp(kMarginRound, kPapillaRound, place.line.rise);
    constexpr double kFall = 0.55, kFallen = 1.6;  // mm by which it falls, within so many mm from the tooth
    const double away = std::clamp(place.tooth / kFallen, 0.0, 1.0);
    const double depth = place.depth - kFall * away * (2 - away);
    const double body = bounded(smoothIntersection(tissue(p, place), -depth / kSlope, round), p, place);
    // Far enough into the teeth that no pixel between them and the margin stays dark, and not so far that it would be
    // seen where the inside of a tooth was cut.
    constexpr double kInto = 0.35;
    return std::max(body, -kInto - place.tooth);
}

double Gingiva::zone(const Vec3& p) const {
    const Place place = placeOf(p);
    constexpr double kFree = 0.5, kAttached = 1.7;  // mm below the margin: the free gingiva ends in this range
    const double attached = smoothStep(kFree, kAttached, place.depth);
    const bool isFacial = place.at.outward > place.line.middle;
    if (upper_ && !isFacial) return attached;  // the palate is keratinised all over
    // Widest at the incisors, narrowest at the first premolars (10 mm along the line are a canine), wavy everywhere.
    const double along = std::abs(place.at.s);
    constexpr double kWidest = 5.6, kNarrowest = 3.6, kLingual = 4.2;
    const double facial = std::lerp(kWidest, kNarrowest, smoothStep(8, 26, along)) + 1.1 * smoothStep(32, 44, along);
    const double wave = 0.5 * std::sin(0.55 * place.at.s + 0.4) + 0.25 * std::sin(1.3 * place.at.s + 1.9);
    // The line follows the margins only loosely: under a papilla it does not rise as far.
    const double straight = (isFacial ? facial_ : lingual_) - place.crownward;
    const double below = std::lerp(place.depth, straight, 0.65);
    const double line = (isFacial ? facial : kLingual) + wave;
    constexpr double kPassage = 1.1;  // mm to both sides of the mucogingival line
    return attached + smoothStep(line - kPassage, line + kPassage, below);
}

Box3 Gingiva::bounds() const {
    const double back = line_.at(end_ + kBehind).point.y(), aside = line_.at(end_ + kBehind).point.x() + 10;
    constexpr double kFront = 12, kAbove = 4;
    const double low = upper_ ? -kAbove : base_ - 1, high = upper_ ? 1 - base_ : kAbove;
    return {Vec3(-aside, back - 3, low), Vec3(aside, kFront, high)};
}

}  // namespace

GingivaBody gingivaBody(const ToothArrangement& places, bool upper, const std::vector<int>& missing) {
    const auto gingiva = std::make_shared<const Gingiva>(places, upper, missing);
    return {[gingiva](const Vec3& p) { return (*gingiva)(p); }, [gingiva](const Vec3& p) { return gingiva->shown(p); },
            [gingiva](const Vec3& p) { return gingiva->zone(p); }, gingiva->bounds(), gingiva->smoothBelow()};
}

}  // namespace tactooth
