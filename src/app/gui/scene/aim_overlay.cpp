// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/aim_overlay.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/gui/scene/mirror_outline.h"
#include "session/control/surface_ray.h"

namespace tactooth {
namespace {

constexpr int kMargin = 4;              // pixels around the lines
constexpr int kPad = 5;                 // pixels around the text
constexpr int kAside = 26, kUp = 12;    // pixels from the tip to the text
constexpr int kPlumbPlaces = 12;        // of the plumb line that are looked at
constexpr double kOnSurface = 0.08;     // mm: a place this near to what the eye sees is not hidden
constexpr double kSeenHold = 0.02;      // N: less nobody feels
constexpr double kShortestPlumb = 0.1;  // mm: the tip is where it lands
const QColor kHalo(0, 0, 0, 120);
const QColor kBeside(255, 72, 60);  // of the part of the ring that will touch a neighbour or a gum

QColor colourOf(TipWarning warning) {
    switch (warning) {
        case TipWarning::None:
            return {245, 250, 255};
        case TipWarning::Deep:
        case TipWarning::NearPulp:
            return {255, 176, 32};
        case TipWarning::AtPulp:
            return {255, 72, 60};
    }
    return {};
}

QString millimetres(double value) { return QString::number(value, 'f', value < 1 && value > -1 ? 2 : 1); }

/// Draws a line through places, twice: a dark halo first. Hidden parts are dashed and dim.
template <class Places>
void drawLine(QPainter& painter, const Places& places, const QColor& colour, bool closed) {
    const std::size_t count = closed ? places.size() : places.size() - std::min<std::size_t>(1, places.size());
    for (const bool halo : {true, false}) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto& from = places[i];
            const auto& to = places[(i + 1) % places.size()];
            const bool isHidden = from.isHidden || to.isHidden;
            if (halo && isHidden) continue;
            QColor shown = halo ? kHalo : from.touchesBeside || to.touchesBeside ? kBeside : colour;
            if (isHidden) shown.setAlpha(110);
            if (isHidden && i % 2 == 1) continue;
            painter.setPen(QPen(shown, halo ? 3.5 : 1.6, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(from.at, to.at);
        }
    }
}

}  // namespace

AimOverlay::AimOverlay(QWidget* parent) : QWidget(parent) {
    setObjectName("aimOverlay");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
}

void AimOverlay::show(const SessionModel& model, const Viewport& picture, const std::optional<Mirror>& mirror) {
    if (model.runner() == nullptr || !model.bur()) return showNothing();
    const Source source = sourceOf(model, picture, mirror);
    if (source_ == source) return;
    source_ = source;
    set(markFor(model, picture, mirror));
}

void AimOverlay::showNothing() {
    source_.reset();
    set({});
}

/// Rounded to what somebody sees: a tool at rest still trembles by less than a micrometre.
AimOverlay::Source AimOverlay::sourceOf(const SessionModel& model, const Viewport& picture,
                                        const std::optional<Mirror>& mirror) const {
    constexpr double kSeen = 0.002;  // mm, and rad
    const auto rounded = [&](const Vec3& place) { return Vec3((place / kSeen).array().round().matrix() * kSeen); };
    const Tick& newest = model.log().newest();
    const MouseManipulator& hand = model.manipulator();
    const Pose& eye = picture.camera().cameraInWorld;
    return {.surface = hand.surroundings().touchable.get(),
            .tip = rounded(newest.contact.proxy.position),
            .shaft = rounded(newest.contact.proxy.rotation * Vec3::UnitZ()),
            .inward = hand.pressDirection(),
            .eye = eye.position,
            .eyeTurn = eye.rotation.coeffs(),
            .depth = hand.depthControl().depth(),
            .force = std::round(10 * newest.force.wrench.force.norm()),
            .hold = std::round(100 * newest.force.tipHold),
            .mode = hand.pressMode(),
            .width = picture.size().width,
            .height = picture.size().height,
            .showsNumbers = showsNumbers_,
            .glass = mirror ? mirror->glass.centre : Vec3::Zero(),
            .glassNormal = mirror ? mirror->glass.normal : Vec3::Zero(),
            .glassRadius = mirror ? mirror->glass.radius : 0,
            .isAimedIntoMirror = mirror && mirror->isAimedInto};
}

void AimOverlay::setShowsNumbers(bool shows) { showsNumbers_ = shows; }

bool AimOverlay::marksBeside() const { return std::ranges::any_of(mark_.direct.ring, &Place::touchesBeside); }

QPolygonF AimOverlay::polygonOf(const std::vector<Place>& places) {
    QPolygonF polygon;
    for (const Place& place : places) polygon << place.at;
    return polygon;
}

bool AimOverlay::isRingAt(const QPointF& place) const {
    constexpr double kNear = 24;  // pixels: the bur follows the mouse within a tenth of a second
    return std::ranges::any_of(std::array{&mark_.direct, &mark_.inMirror}, [&](const Lines* lines) {
        const QRectF near = polygonOf(lines->ring).boundingRect().adjusted(-kNear, -kNear, kNear, kNear);
        return lines->ring.size() > 2 && near.contains(place);
    });
}

/// Where the eye sees a place; what stands behind the tooth or behind the mirror is hidden.
AimOverlay::Projection AimOverlay::directly(const SessionModel& model, const Viewport& picture,
                                            const std::optional<Mirror>& mirror) const {
    return [&model, &picture, &mirror, ratio = devicePixelRatioF()](const Vec3& point) -> std::optional<Place> {
        const auto pixel = project(picture.camera(), picture.size(), point);
        if (!pixel) return std::nullopt;
        const Ray ray = picture.rayThrough(*pixel);
        const double distance = (point - ray.origin).dot(ray.direction);
        const MouseManipulator::Surroundings& there = model.manipulator().surroundings();
        const auto hit = there.touchable ? firstSeen(*there.touchable, ray) : std::nullopt;
        const auto glass = mirror ? meetingWith(mirror->glass, ray) : std::nullopt;
        const bool isHidden = (hit && hit->distance + kOnSurface < distance) || (glass && *glass < distance);
        return Place{{pixel->x() / ratio, pixel->y() / ratio}, isHidden, false};
    };
}

/// Where the mirror shows a place; none behind the glass.
AimOverlay::Projection AimOverlay::throughMirror(const SessionModel& model, const Viewport& picture,
                                                 const MirrorDisc& glass) const {
    return [&model, &picture, &glass, ratio = devicePixelRatioF()](const Vec3& point) -> std::optional<Place> {
        if ((point - glass.centre).dot(glass.normal) <= 0) return std::nullopt;
        const auto pixel = project(picture.camera(), picture.size(), mirrorImage(glass, point));
        if (!pixel) return std::nullopt;
        const MouseManipulator::Surroundings& there = model.manipulator().surroundings();
        const bool isHidden =
            there.touchable != nullptr && !isSeenInMirror(picture, *pixel, glass, point, *there.touchable);
        return Place{{pixel->x() / ratio, pixel->y() / ratio}, isHidden, false};
    };
}

AimOverlay::Lines AimOverlay::linesFor(const AimMark& aim, const Projection& placeOf) const {
    Lines lines;
    for (const AimPlace& one : aim.ring) {
        auto place = placeOf(one.at);
        if (!place) continue;
        place->touchesBeside = one.touchesBeside && showsNumbers_;
        lines.ring.push_back(*place);
    }
    if (aim.landing && (*aim.landing - aim.tip).norm() > kShortestPlumb) {
        for (int i = 0; i <= kPlumbPlaces; ++i) {
            const double part = static_cast<double>(i) / kPlumbPlaces;
            if (const auto place = placeOf(aim.tip + part * (*aim.landing - aim.tip))) lines.plumb.push_back(*place);
        }
    }
    return lines;
}

AimOverlay::Mark AimOverlay::markFor(const SessionModel& model, const Viewport& picture,
                                     const std::optional<Mirror>& mirror) const {
    Mark mark;
    const Pose& tool = model.log().newest().contact.proxy;
    const Projection direct = directly(model, picture, mirror);
    const auto tip = direct(tool.position);
    if (!tip) return mark;
    mark.tip = tip->at;
    if (mirror) mark.glass = glassInPicture(mirror->glass, picture, devicePixelRatioF());
    AimMark aim;
    const bool byMouse = model.devices().first() == nullptr;
    if (byMouse) aim = aimMark(model.manipulator(), HeadOutline(*model.bur()), tool);
    mark.direct = linesFor(aim, direct);
    if (!mark.glass.isEmpty()) {
        const Projection reflected = throughMirror(model, picture, mirror->glass);
        mark.inMirror = linesFor(aim, reflected);
        const auto tipThere = mirror->isAimedInto ? reflected(tool.position) : std::nullopt;
        if (tipThere) mark.tip = tipThere->at;
    }
    if (!showsNumbers_) return mark;
    const TipMeasure measure = tipMeasure(model);
    mark.warning = warningOf(measure, model);
    mark.lines = textFor(model, measure);
    if (std::ranges::any_of(mark.direct.ring, &Place::touchesBeside))
        mark.lines << tr("Will touch the neighbour or gum");
    return mark;
}

QStringList AimOverlay::textFor(const SessionModel& model, const TipMeasure& measure) const {
    QStringList lines;
    const MouseManipulator& hand = model.manipulator();
    const bool hasGoal = model.devices().first() == nullptr && hand.pressMode() == PressMode::Depth;
    const std::optional<HandInstrument> held = model.bur()->instrument.hand;
    if (held == HandInstrument::Probe) {
        if (measure.probed) lines << tr("Probe %1 mm").arg(*measure.probed, 0, 'f', 1);
    } else if (measure.depth && held != HandInstrument::Explorer) {
        const QString depth = millimetres(std::max(0.0, *measure.depth));
        lines << (hasGoal ? tr("Depth %1 of %2 mm").arg(depth, millimetres(hand.depthControl().depth()))
                          : tr("Depth %1 mm").arg(depth));
    }
    if (held == HandInstrument::Explorer || held == HandInstrument::Probe) {
        if (measure.hold > kSeenHold) lines << tr("Sticks: %1 N to draw it out").arg(measure.hold, 0, 'f', 2);
    } else if (measure.overPulp && *measure.overPulp > 0) {
        lines << tr("Over the pulp %1 mm").arg(millimetres(*measure.overPulp));
    } else if (measure.overPulp) {
        lines << tr("In the pulp");
    }
    lines << tr("Force %1 N").arg(measure.force, 0, 'f', 1);
    return lines;
}

QRect AimOverlay::textPlace() const {
    if (mark_.lines.empty()) return {};
    const QFontMetrics metrics = fontMetrics();
    int width = 0;
    for (const QString& line : mark_.lines) width = std::max(width, metrics.horizontalAdvance(line));
    const QSize size(width + 2 * kPad, static_cast<int>(mark_.lines.size()) * metrics.lineSpacing() + 2 * kPad);
    QRect place(mark_.tip.toPoint() + QPoint(kAside, kUp), size);
    if (place.right() > QWidget::width() - kMargin) place.moveRight(mark_.tip.toPoint().x() - kAside);
    place.moveBottom(std::min(place.bottom(), height() - kMargin));
    place.moveTop(std::max(place.top(), kMargin));
    return place;
}

QRect AimOverlay::bounds() const {
    QPolygonF all = ring();
    all << polygonOf(mark_.direct.plumb);
    if (!mark_.inMirror.ring.empty() || !mark_.inMirror.plumb.empty()) all << mark_.glass;
    return all.boundingRect().toAlignedRect().adjusted(-kMargin, -kMargin, kMargin, kMargin).united(textPlace());
}

void AimOverlay::set(Mark mark) {
    if (mark == mark_) return;
    const QRect before = bounds();
    mark_ = std::move(mark);
    update(before);
    update(bounds());
}

void AimOverlay::paintLines(QPainter& painter, const Lines& lines) const {
    const QColor colour = colourOf(mark_.warning);
    drawLine(painter, lines.plumb, colour, false);
    if (lines.ring.size() > 2) drawLine(painter, lines.ring, colour, lines.ring.size() == HeadOutline::kPlaces);
}

void AimOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = colourOf(mark_.warning);
    paintLines(painter, mark_.direct);
    if (!mark_.glass.isEmpty()) {
        painter.save();
        painter.setClipPath(pathOf(mark_.glass));
        paintLines(painter, mark_.inMirror);
        painter.restore();
    }
    if (mark_.lines.empty()) return;
    const QRect text = textPlace();
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(12, 18, 26, 170));
    painter.drawRoundedRect(text, kPad, kPad);
    painter.setPen(colour);
    painter.drawText(text.adjusted(kPad, kPad, -kPad, -kPad), Qt::AlignLeft | Qt::AlignTop, mark_.lines.join('\n'));
}

}  // namespace tactooth
