// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/event_codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "geometry/util/assert.h"
#include "journal/codec/integer_columns.h"

// One table for the order of the events, and one for each kind. The columns of a tick take most of the space: a hand
// moves evenly within a millisecond, so its second differences are small.

namespace tactooth {
namespace {

using Row = std::vector<std::int64_t>;

constexpr std::int64_t kPedalDown = static_cast<std::int64_t>(1 / TickInput::kPedalStep);
constexpr double kMaxForceNumber = 1e3;  // far beyond any material, and no force overflows

std::int64_t bitsOf(double value) { return std::bit_cast<std::int64_t>(value); }
double numberOf(std::int64_t bits) { return std::bit_cast<double>(bits); }

/// The numbers of a kind of event: how each column is stored, and how it is encoded and decoded.
template <class Event>
struct Layout;

template <>
struct Layout<TickEvent> {
    static constexpr std::array kColumns = {Differences::Second, Differences::Second, Differences::Second,
                                            Differences::Second, Differences::Second, Differences::Second,
                                            Differences::Second, Differences::First,  Differences::First,
                                            Differences::First,  Differences::None};
    static Row row(const TickEvent& event) {
        const TickInput& in = event.input;
        return {
            in.position[0], in.position[1], in.position[2], in.rotation[0], in.rotation[1],
            in.rotation[2], in.rotation[3], in.elapsed,     in.pedal,       (in.cutting ? 1 : 0) + (in.hasPose ? 2 : 0),
            event.taken};
    }
    static std::optional<TickEvent> event(const Row& row) {
        TickEvent event;
        for (std::size_t i = 0; i < 3; ++i) event.input.position[i] = row[i];
        for (std::size_t i = 0; i < 4; ++i) {
            if (!std::in_range<std::int32_t>(row[3 + i])) return std::nullopt;
            event.input.rotation[i] = static_cast<std::int32_t>(row[3 + i]);
        }
        if (row[7] < 0 || !std::in_range<std::int32_t>(row[7]) || !std::in_range<std::int32_t>(row[8])) return {};
        if (row[8] < 0 || row[8] > kPedalDown || row[9] < 0 || row[9] > 3 || !std::in_range<std::uint32_t>(row[10]))
            return std::nullopt;
        event.input.elapsed = static_cast<std::int32_t>(row[7]);
        event.input.pedal = static_cast<std::int32_t>(row[8]);
        event.input.cutting = (row[9] & 1) != 0;
        event.input.hasPose = (row[9] & 2) != 0;
        event.taken = static_cast<std::uint32_t>(row[10]);
        return event;
    }
};

template <>
struct Layout<CarveEvent> {
    static constexpr std::array kColumns = {Differences::Second, Differences::None};
    static Row row(const CarveEvent& event) { return {event.tick, event.published ? 1 : 0}; }
    static std::optional<CarveEvent> event(const Row& row) {
        if (!std::in_range<TickNumber>(row[0]) || row[1] < 0 || row[1] > 1) return std::nullopt;
        return CarveEvent{static_cast<TickNumber>(row[0]), row[1] == 1};
    }
};

template <>
struct Layout<ListEvent> {
    static constexpr std::array kColumns = {Differences::Second, Differences::None, Differences::None,
                                            Differences::None};
    static Row row(const ListEvent& event) { return {event.tick, event.surface, event.recycled, event.sent ? 1 : 0}; }
    static std::optional<ListEvent> event(const Row& row) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (!std::in_range<std::uint32_t>(row[i])) return std::nullopt;
        }
        if (row[3] < 0 || row[3] > 1) return std::nullopt;
        return ListEvent{static_cast<TickNumber>(row[0]), static_cast<SurfaceNumber>(row[1]),
                         static_cast<std::uint32_t>(row[2]), row[3] == 1};
    }
};

template <>
struct Layout<EditEvent> {
    static constexpr std::array kColumns = {Differences::None, Differences::None};
    static Row row(const EditEvent& event) { return {static_cast<std::int64_t>(event.edit), event.published ? 1 : 0}; }
    static std::optional<EditEvent> event(const Row& row) {
        if (row[0] < 0 || row[0] > static_cast<std::int64_t>(Edit::Redo) || row[1] < 0 || row[1] > 1) return {};
        return EditEvent{static_cast<Edit>(row[0]), row[1] == 1};
    }
};

template <>
struct Layout<ForceEvent> {
    static constexpr std::array kColumns = {Differences::None, Differences::None, Differences::None,
                                            Differences::None, Differences::None, Differences::None};
    static Row row(const ForceEvent& event) {
        const ForceOverrides& given = event.parameters.overrides;
        const auto isGiven = [](const std::optional<double>& value) { return value ? 1 : 0; };
        return {isGiven(given.stiffness) + 2 * isGiven(given.damping) + 4 * isGiven(given.friction),
                bitsOf(given.stiffness.value_or(0)),
                bitsOf(given.damping.value_or(0)),
                bitsOf(given.friction.value_or(0)),
                bitsOf(event.parameters.scale),
                bitsOf(event.parameters.maxStiffness)};
    }
    static std::optional<ForceEvent> event(const Row& row) {
        if (row[0] < 0 || row[0] > 7) return std::nullopt;
        for (std::size_t i = 1; i < 5; ++i) {
            const double value = numberOf(row[i]);
            if (!(value >= 0 && value <= kMaxForceNumber)) return std::nullopt;
        }
        if (!(numberOf(row[5]) >= 0)) return std::nullopt;  // it may be infinite
        ForceEvent event;
        if ((row[0] & 1) != 0) event.parameters.overrides.stiffness = numberOf(row[1]);
        if ((row[0] & 2) != 0) event.parameters.overrides.damping = numberOf(row[2]);
        if ((row[0] & 4) != 0) event.parameters.overrides.friction = numberOf(row[3]);
        event.parameters.scale = numberOf(row[4]);
        event.parameters.maxStiffness = numberOf(row[5]);
        return event;
    }
};

/// The numbers are the bits of doubles, so they do not change alike.
template <>
struct Layout<ExactTickEvent> {
    static constexpr std::array kColumns = {Differences::None, Differences::None, Differences::None, Differences::None,
                                            Differences::None, Differences::None, Differences::None, Differences::None,
                                            Differences::None, Differences::None, Differences::None, Differences::None};
    static constexpr std::size_t kNumbers = 10;  // doubles, then two whole numbers
    static Row row(const ExactTickEvent& event) {
        const Vec3& position = event.input.deviceInTooth.position;
        const auto& rotation = event.input.deviceInTooth.rotation.coeffs();
        Row row;
        for (const double mm : position) row.push_back(bitsOf(mm));
        for (const double part : rotation) row.push_back(bitsOf(part));
        for (const double other : {event.input.pedal, event.elapsed, event.time}) row.push_back(bitsOf(other));
        row.push_back((event.input.cutting ? 1 : 0) + (event.swept ? 2 : 0));
        row.push_back(event.taken);
        return row;
    }
    static std::optional<ExactTickEvent> event(const Row& row) {
        for (std::size_t i = 0; i < kNumbers; ++i) {
            if (!std::isfinite(numberOf(row[i]))) return std::nullopt;
        }
        ExactTickEvent event;
        Pose& pose = event.input.deviceInTooth;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = numberOf(row[static_cast<std::size_t>(axis)]);
        for (int i = 0; i < 4; ++i) pose.rotation.coeffs()[i] = numberOf(row[static_cast<std::size_t>(3 + i)]);
        event.input.pedal = numberOf(row[7]);
        event.elapsed = numberOf(row[8]);
        event.time = numberOf(row[9]);
        if (event.elapsed < 0 || row[10] < 0 || row[10] > 3 || !std::in_range<std::uint32_t>(row[11])) return {};
        event.input.cutting = (row[10] & 1) != 0;
        event.swept = (row[10] & 2) != 0;
        event.taken = static_cast<std::uint32_t>(row[11]);
        return event;
    }
};

template <>
struct Layout<FinishEvent> {
    static constexpr std::array kColumns = {Differences::None, Differences::None};
    static Row row(const FinishEvent& event) { return {event.dropsPieces ? 1 : 0, event.published ? 1 : 0}; }
    static std::optional<FinishEvent> event(const Row& row) {
        if (row[0] < 0 || row[0] > 1 || row[1] < 0 || row[1] > 1) return std::nullopt;
        return FinishEvent{row[0] == 1, row[1] == 1};
    }
};

template <class Event>
struct HashLayout {
    static constexpr std::array kColumns = {Differences::None};
    static Row row(const Event& event) { return {std::bit_cast<std::int64_t>(event.hash)}; }
    static std::optional<Event> event(const Row& row) { return Event{std::bit_cast<std::uint64_t>(row[0])}; }
};
template <>
struct Layout<TickHashEvent> : HashLayout<TickHashEvent> {};
template <>
struct Layout<CarvingHashEvent> : HashLayout<CarvingHashEvent> {};

/// The kinds in the order of their numbers in the file: never change one.
template <class... Events>
struct Kinds {
    static constexpr std::size_t kCount = sizeof...(Events);
};
using FileKinds = Kinds<TickEvent, CarveEvent, ListEvent, EditEvent, ForceEvent, TickHashEvent, CarvingHashEvent,
                        ExactTickEvent, FinishEvent>;

template <class Wanted, class First, class... Rest>
constexpr std::int64_t numberOfKind(Kinds<First, Rest...> /*kinds*/) {
    if constexpr (std::is_same_v<Wanted, First>) {
        return 0;
    } else {
        return 1 + numberOfKind<Wanted>(Kinds<Rest...>());
    }
}

template <class Event>
std::vector<IntegerColumn> emptyColumns() {
    std::vector<IntegerColumn> columns;
    for (const Differences differences : Layout<Event>::kColumns) columns.push_back({differences, {}});
    return columns;
}

template <class Event>
void putKind(ByteWriter& out, std::span<const SessionEvent> events) {
    std::vector<IntegerColumn> columns = emptyColumns<Event>();
    for (const SessionEvent& event : events) {
        const auto* one = std::get_if<Event>(&event);
        if (one == nullptr) continue;
        const Row row = Layout<Event>::row(*one);
        for (std::size_t i = 0; i < columns.size(); ++i) columns[i].values.push_back(row[i]);
    }
    putColumns(out, columns);
}

template <class... Events>
void putKinds(ByteWriter& out, std::span<const SessionEvent> events, Kinds<Events...> /*kinds*/) {
    (putKind<Events>(out, events), ...);
}

/// Fills in the events of one kind, in their order. False for numbers that no event has.
template <class Event>
bool getKind(ByteReader& in, std::span<const std::int64_t> kinds, std::vector<SessionEvent>& events) {
    const std::vector<IntegerColumn> columns = getColumns(in);
    const std::int64_t kind = numberOfKind<Event>(FileKinds());
    const auto count = static_cast<std::size_t>(std::ranges::count(kinds, kind));
    if (!in.ok() || columns.size() != Layout<Event>::kColumns.size()) return false;
    for (const IntegerColumn& column : columns) {
        if (column.values.size() != count) return false;
    }
    std::size_t next = 0;
    Row row(columns.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] != kind) continue;
        for (std::size_t column = 0; column < columns.size(); ++column) row[column] = columns[column].values[next];
        ++next;
        const std::optional<Event> event = Layout<Event>::event(row);
        if (!event) return false;
        events[i] = *event;
    }
    return true;
}

template <class... Events>
bool getKinds(ByteReader& in, std::span<const std::int64_t> kinds, std::vector<SessionEvent>& events,
              Kinds<Events...> /*kinds*/) {
    return (getKind<Events>(in, kinds, events) && ...);
}

std::int64_t kindOf(const SessionEvent& event) {
    return std::visit(
        []<class Event>(const Event&) -> std::int64_t {
            if constexpr (std::is_same_v<Event, BeginEvent>) {
                TACTOOTH_ASSERT(false);
                return -1;
            } else {
                return numberOfKind<Event>(FileKinds());
            }
        },
        event);
}

}  // namespace

std::vector<std::byte> encodeEvents(std::span<const SessionEvent> events) {
    TACTOOTH_ASSERT(events.size() <= kMaxBlockEvents);
    ByteWriter out;
    std::vector<IntegerColumn> order = {{Differences::None, {}}};
    for (const SessionEvent& event : events) order.front().values.push_back(kindOf(event));
    putColumns(out, order);
    putKinds(out, events, FileKinds());
    return out.take();
}

std::optional<std::vector<SessionEvent>> decodeEvents(std::span<const std::byte> payload) {
    ByteReader in(payload);
    const std::vector<IntegerColumn> order = getColumns(in);
    if (!in.ok() || order.size() != 1 || order.front().values.size() > kMaxBlockEvents) return std::nullopt;
    const std::vector<std::int64_t>& kinds = order.front().values;
    const auto isKnown = [](std::int64_t kind) {
        return kind >= 0 && kind < static_cast<std::int64_t>(FileKinds::kCount);
    };
    if (!std::ranges::all_of(kinds, isKnown)) return std::nullopt;
    std::vector<SessionEvent> events(kinds.size(), TickEvent());
    if (!getKinds(in, kinds, events, FileKinds()) || !in.ok() || in.left() > 0) return std::nullopt;
    return events;
}

}  // namespace tactooth
