// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/aim_overlay.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

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

void AimOverlay::show(const SessionModel& model, const Viewport& picture) {
    if (model.runner() == nullptr || !model.bur()) return showNothing();
    const Source source = sourceOf(model, picture);
    if (source_ == source) return;
    source_ = source;
    set(markFor(model, picture));
}

void AimOverlay::showNothing() {
    source_.reset();
    set({});
}

/// Rounded to what somebody sees: a tool at rest still trembles by less than a micrometre.
AimOverlay::Source AimOverlay::sourceOf(const SessionModel& model, const Viewport& picture) const {
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
            .showsNumbers = showsNumbers_};
}

void AimOverlay::setShowsNumbers(bool shows) { showsNumbers_ = shows; }

bool AimOverlay::marksBeside() const { return std::ranges::any_of(mark_.ring, &Place::touchesBeside); }

QPolygonF AimOverlay::ring() const {
    QPolygonF ring;
    for (const Place& place : mark_.ring) ring << place.at;
    return ring;
}

bool AimOverlay::isRingAt(const QPointF& place) const {
    constexpr double kNear = 24;  // pixels: the bur follows the mouse within a tenth of a second
    return mark_.ring.size() > 2 && ring().boundingRect().adjusted(-kNear, -kNear, kNear, kNear).contains(place);
}

AimOverlay::Mark AimOverlay::markFor(const SessionModel& model, const Viewport& picture) const {
    Mark mark;
    const double ratio = devicePixelRatioF();
    const MouseManipulator::Surroundings& there = model.manipulator().surroundings();
    const auto placeOf = [&](const Vec3& point) -> std::optional<Place> {
        const auto pixel = project(picture.camera(), picture.size(), point);
        if (!pixel) return std::nullopt;
        const Ray ray = picture.rayThrough(*pixel);
        const auto hit = there.touchable ? firstSeen(*there.touchable, ray) : std::nullopt;
        const bool isHidden = hit && hit->distance + kOnSurface < (point - ray.origin).dot(ray.direction);
        return Place{{pixel->x() / ratio, pixel->y() / ratio}, isHidden, false};
    };
    const Tick& newest = model.log().newest();
    const auto tip = placeOf(newest.contact.proxy.position);
    if (!tip) return mark;
    mark.tip = tip->at;
    if (model.devices().first() == nullptr) {
        const AimMark aim = aimMark(model.manipulator(), HeadOutline(*model.bur()), newest.contact.proxy);
        for (const AimPlace& one : aim.ring) {
            auto place = placeOf(one.at);
            if (!place) continue;
            place->touchesBeside = one.touchesBeside && showsNumbers_;
            mark.ring.push_back(*place);
        }
        if (aim.landing && (*aim.landing - aim.tip).norm() > kShortestPlumb) {
            for (int i = 0; i <= kPlumbPlaces; ++i) {
                const double part = static_cast<double>(i) / kPlumbPlaces;
                if (const auto place = placeOf(aim.tip + part * (*aim.landing - aim.tip))) mark.plumb.push_back(*place);
            }
        }
    }
    if (!showsNumbers_) return mark;
    const TipMeasure measure = tipMeasure(model);
    mark.warning = warningOf(measure, model);
    const MouseManipulator& hand = model.manipulator();
    const bool hasGoal = model.devices().first() == nullptr && hand.pressMode() == PressMode::Depth;
    const std::optional<HandInstrument> held = model.bur()->instrument.hand;
    if (held == HandInstrument::Probe) {
        if (measure.probed) mark.lines << tr("Probe %1 mm").arg(*measure.probed, 0, 'f', 1);
    } else if (measure.depth && held != HandInstrument::Explorer) {
        const QString depth = millimetres(std::max(0.0, *measure.depth));
        mark.lines << (hasGoal ? tr("Depth %1 of %2 mm").arg(depth, millimetres(hand.depthControl().depth()))
                               : tr("Depth %1 mm").arg(depth));
    }
    if (held == HandInstrument::Explorer || held == HandInstrument::Probe) {
        if (measure.hold > kSeenHold) mark.lines << tr("Sticks: %1 N to draw it out").arg(measure.hold, 0, 'f', 2);
    } else if (measure.overPulp && *measure.overPulp > 0) {
        mark.lines << tr("Over the pulp %1 mm").arg(millimetres(*measure.overPulp));
    } else if (measure.overPulp) {
        mark.lines << tr("In the pulp");
    }
    mark.lines << tr("Force %1 N").arg(measure.force, 0, 'f', 1);
    if (std::ranges::any_of(mark.ring, &Place::touchesBeside)) mark.lines << tr("Will touch the neighbour or gum");
    return mark;
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
    for (const Place& place : mark_.plumb) all << place.at;
    return all.boundingRect().toAlignedRect().adjusted(-kMargin, -kMargin, kMargin, kMargin).united(textPlace());
}

void AimOverlay::set(Mark mark) {
    if (mark == mark_) return;
    const QRect before = bounds();
    mark_ = std::move(mark);
    update(before);
    update(bounds());
}

void AimOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = colourOf(mark_.warning);
    drawLine(painter, mark_.plumb, colour, false);
    if (mark_.ring.size() > 2) drawLine(painter, mark_.ring, colour, mark_.ring.size() == HeadOutline::kPlaces);
    if (mark_.lines.empty()) return;
    const QRect text = textPlace();
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(12, 18, 26, 170));
    painter.drawRoundedRect(text, kPad, kPad);
    painter.setPen(colour);
    painter.drawText(text.adjusted(kPad, kPad, -kPad, -kPad), Qt::AlignLeft | Qt::AlignTop, mark_.lines.join('\n'));
}

}  // namespace tactooth
