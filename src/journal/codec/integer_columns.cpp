// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "journal/codec/integer_columns.h"

#include "geometry/util/assert.h"
#include "journal/codec/varint.h"

namespace tactooth {
namespace {

/// Predicts the next value of a column from those before it; only the error of the prediction is stored.
class Predictor {
public:
    explicit Predictor(Differences differences) : differences_(differences) {}

    [[nodiscard]] std::uint64_t prediction() const {
        if (differences_ == Differences::None) return 0;
        return differences_ == Differences::First ? last_ : last_ + step_;
    }
    void take(std::uint64_t value) {
        step_ = hasLast_ ? value - last_ : 0;
        last_ = value;
        hasLast_ = true;
    }

private:
    Differences differences_;
    std::uint64_t last_ = 0;
    std::uint64_t step_ = 0;
    bool hasLast_ = false;
};

void putColumn(ByteWriter& out, const IntegerColumn& column) {
    out.put(static_cast<std::uint8_t>(column.differences));
    Predictor predictor(column.differences);
    for (const std::int64_t signedValue : column.values) {
        const auto value = static_cast<std::uint64_t>(signedValue);
        putVarint(out, zigzag(static_cast<std::int64_t>(value - predictor.prediction())));
        predictor.take(value);
    }
}

IntegerColumn getColumn(ByteReader& in, std::uint64_t rows) {
    const auto differences = in.get<std::uint8_t>();
    if (differences > static_cast<std::uint8_t>(Differences::Second)) in.fail();
    IntegerColumn column{static_cast<Differences>(differences), {}};
    if (!in.ok()) return column;
    column.values.reserve(rows);
    Predictor predictor(column.differences);
    for (std::uint64_t row = 0; row < rows && in.ok(); ++row) {
        const std::uint64_t value = predictor.prediction() + static_cast<std::uint64_t>(unzigzag(getVarint(in)));
        predictor.take(value);
        column.values.push_back(static_cast<std::int64_t>(value));
    }
    TACTOOTH_ASSERT(!in.ok() || column.values.size() == rows);
    return column;
}

}  // namespace

void putColumns(ByteWriter& out, std::span<const IntegerColumn> columns) {
    const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
    TACTOOTH_ASSERT(columns.size() <= kMaxColumns);
    TACTOOTH_ASSERT(rows * columns.size() <= kMaxColumnValues);
    putVarint(out, columns.size());
    putVarint(out, rows);
    for (const IntegerColumn& column : columns) {
        TACTOOTH_ASSERT(column.values.size() == rows);
        putColumn(out, column);
    }
}

std::vector<IntegerColumn> getColumns(ByteReader& in) {
    const std::uint64_t count = getVarint(in);
    const std::uint64_t rows = getVarint(in);
    // A value takes a byte at least, so the bytes that are left bound the memory, too.
    const bool fits = count <= kMaxColumns && (count == 0 ? rows == 0 : rows <= kMaxColumnValues / count) &&
                      count * (rows + 1) <= in.left();
    if (!fits) in.fail();
    std::vector<IntegerColumn> columns;
    for (std::uint64_t i = 0; i < count && in.ok(); ++i) columns.push_back(getColumn(in, rows));
    if (!in.ok()) return {};
    TACTOOTH_ASSERT(columns.size() == count);
    return columns;
}

}  // namespace tactooth
