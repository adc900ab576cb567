// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cutting/calibration_records.h"

#include "core/base/csv.h"
#include "core/base/numbers.h"
#include "core/base/resource_folder.h"
#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace burin {

namespace {

constexpr double roundingShare = 1e-6; // by which a radial depth may exceed the diameter

// The reason why a field can't be used; empty: it can be used.
using Fault = std::string;
using Reader = Fault (*)(const std::string& text, ForceRecord& record);

Fault readNumber(const std::string& text, double low, double& value) {
    constexpr double high = 1e9;
    const std::optional<double> number = parseNumber(text);
    if (!number)
        return text.empty() ? "is missing; write a number" : "\"" + text + "\" is no number with a decimal point";
    if (!(*number >= low && *number <= high))
        return "\"" + text + "\" is out of range; " + formatShortest(low) + " to " + formatShortest(high);
    value = *number;
    return {};
}

template <double ForceRecord::*value>
Fault positive(const std::string& text, ForceRecord& record) {
    Fault fault = readNumber(text, 0.0, record.*value);
    if (fault.empty() && record.*value <= 0.0) fault = "\"" + text + "\" has to be above 0";
    return fault;
}

template <double ForceRecord::*value>
Fault notNegative(const std::string& text, ForceRecord& record) {
    return readNumber(text, 0.0, record.*value);
}

template <glm::dvec3 ForceRecord::*vector, int axis>
Fault component(const std::string& text, ForceRecord& record) {
    return readNumber(text, -1e9, (record.*vector)[axis]);
}

Fault material(const std::string& text, ForceRecord& record) {
    if (!isResourceId(text))
        return "\"" + text + "\" is no id; letters, digits, '-', '_' and '.', a letter or digit first";
    record.material = text;
    return {};
}

Fault teeth(const std::string& text, ForceRecord& record) {
    double number = 0.0;
    Fault fault = readNumber(text, 1.0, number);
    if (fault.empty() && (number != std::floor(number) || number > 1000.0))
        fault = "\"" + text + "\" has to be a whole number from 1 to 1000";
    if (fault.empty()) record.teeth = static_cast<int>(number);
    return fault;
}

Fault immersion(const std::string& text, ForceRecord& record) {
    constexpr std::array<std::string_view, 3> names{"slot", "up", "down"};
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end() && !text.empty()) return "\"" + text + "\" has to be slot, up, down or empty";
    record.immersion = static_cast<Immersion>(found - names.begin()); // unknown comes after them
    return {};
}

Fault statedRate(const std::string& text, ForceRecord& record) {
    if (text.empty()) return {};
    double rate = 0.0;
    Fault fault = readNumber(text, 0.0, rate);
    if (fault.empty()) record.statedRate = rate;
    return fault;
}

Fault cut(const std::string& text, ForceRecord& record) {
    record.cut = text;
    return {};
}

struct Column {
    std::string_view name;
    Reader read;
    bool required = true;
};
constexpr std::array columns{
    Column{"material", material},
    Column{"force_x_n", component<&ForceRecord::force, 0>},
    Column{"force_y_n", component<&ForceRecord::force, 1>},
    Column{"force_z_n", component<&ForceRecord::force, 2>},
    Column{"axis_x", component<&ForceRecord::axis, 0>},
    Column{"axis_y", component<&ForceRecord::axis, 1>},
    Column{"axis_z", component<&ForceRecord::axis, 2>},
    Column{"feed_x", component<&ForceRecord::feedDirection, 0>},
    Column{"feed_y", component<&ForceRecord::feedDirection, 1>},
    Column{"feed_z", component<&ForceRecord::feedDirection, 2>},
    Column{"spindle_speed_1_min", positive<&ForceRecord::spindleSpeed>},
    Column{"diameter_mm", positive<&ForceRecord::diameter>},
    Column{"teeth", teeth},
    Column{"axial_depth_mm", notNegative<&ForceRecord::axialDepth>},
    Column{"radial_depth_mm", notNegative<&ForceRecord::radialDepth>},
    Column{"feed_mm_min", notNegative<&ForceRecord::feed>},
    Column{"immersion", immersion, false},
    Column{"removal_rate_mm3_s", statedRate, false},
    Column{"cut", cut, false},
};
constexpr std::string_view notePrefix = "note"; // columns for remarks

/// The column of each field of a row; null: a note.
using Layout = std::vector<const Column*>;

class Reading {
public:
    Reading(std::string_view text, const std::string& origin) : rest_(text), origin_(origin) {}

    Result<std::vector<ForceRecord>> all() {
        if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
        Result<Layout> layout = heading();
        if (!layout) return layout.error();
        while (const std::optional<std::string_view> line = nextLine())
            if (const Result<void> read = row(*line, *layout); !read) return read.error();
        if (records_.empty())
            return Error{ErrorCode::resourceInvalid, origin_, "records", "there is no row below the heading"};
        for (ForceRecord& record : records_) record.force /= static_cast<double>(record.samples);
        return std::move(records_);
    }

private:
    Error fault(std::string_view column, const std::string& what) const {
        return {ErrorCode::resourceInvalid, origin_,
                "line " + std::to_string(line_) + ", column " + std::string(column), what};
    }

    /// Returns the next line that is neither empty nor a comment.
    std::optional<std::string_view> nextLine() {
        while (!rest_.empty()) {
            const std::string_view line = takeLine(rest_);
            ++line_;
            if (line.find_first_not_of(" \t") != std::string_view::npos && !line.starts_with('#')) return line;
        }
        return std::nullopt;
    }

    Result<std::vector<std::string>> fieldsOf(std::string_view line) const {
        if (!isUtf8(line)) return fault("text", "is not UTF-8; save the table as CSV UTF-8");
        std::optional<std::vector<std::string>> fields = csvFields(line);
        if (!fields) return fault("text", "a quotation mark does not end");
        return *std::move(fields);
    }

    Result<Layout> heading() {
        const std::optional<std::string_view> line = nextLine();
        if (!line) return Error{ErrorCode::fileEmpty, origin_, {}, {}};
        const Result<std::vector<std::string>> names = fieldsOf(*line);
        if (!names) return names.error();
        if (names->size() == 1 && line->find(';') != std::string_view::npos)
            return fault("heading", "has semicolons; save the table with commas and decimal points");
        Layout layout;
        for (const std::string& name : *names) {
            const auto found =
                std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
            if (found == columns.end() && !name.starts_with(notePrefix))
                return fault("\"" + name + "\"", "is not known; call columns that are for people note…");
            const Column* column = found == columns.end() ? nullptr : &*found;
            if (column != nullptr && std::find(layout.begin(), layout.end(), column) != layout.end())
                return fault(name, "is there twice");
            layout.push_back(column);
        }
        for (const Column& column : columns)
            if (column.required && std::find(layout.begin(), layout.end(), &column) == layout.end())
                return fault(column.name, "is missing; the first line has to name it");
        return layout;
    }

    Result<void> row(std::string_view line, const Layout& layout) {
        const Result<std::vector<std::string>> fields = fieldsOf(line);
        if (!fields) return fields.error();
        if (fields->size() != layout.size())
            return fault(std::to_string(std::min(fields->size(), layout.size()) + 1),
                         "the row has " + std::to_string(fields->size()) + " values, the heading " +
                             std::to_string(layout.size()) + "; write decimal points, not commas");
        ForceRecord record;
        record.line = line_;
        for (std::size_t i = 0; i < layout.size(); ++i) {
            if (layout[i] == nullptr) continue;
            if (const Fault what = layout[i]->read((*fields)[i], record); !what.empty())
                return fault(layout[i]->name, what);
        }
        if (const Result<void> checked = check(record); !checked) return checked;
        return add(std::move(record));
    }

    /// Checks the rules between columns.
    Result<void> check(ForceRecord& record) const {
        constexpr double shortest = 1e-6;
        if (glm::length(record.axis) < shortest) return fault("axis_x", "the tool axis has no length");
        if (glm::length(record.feedDirection) < shortest) return fault("feed_x", "the feed has no direction");
        record.axis = glm::normalize(record.axis);
        record.feedDirection = glm::normalize(record.feedDirection);
        if (record.radialDepth > record.diameter * (1.0 + roundingShare))
            return fault("radial_depth_mm", "is more than the diameter");
        record.radialDepth = std::min(record.radialDepth, record.diameter);
        const bool whole = record.radialDepth >= record.diameter * (1.0 - roundingShare);
        if (record.immersion == Immersion::slot && !whole)
            return fault("immersion", "a slot's radial depth is the diameter; write up or down");
        if (whole) record.immersion = Immersion::slot;
        return {};
    }

    /// Adds a new record, or one more sample of a known cut.
    Result<void> add(ForceRecord record) {
        if (!record.cut.empty()) {
            const auto [known, isNew] = cuts_.try_emplace(record.cut, records_.size());
            if (!isNew) {
                ForceRecord& first = records_[known->second];
                if (!sameConditions(first, record))
                    return fault("cut", "its conditions differ from line " + std::to_string(first.line) +
                                            " of the same cut; give it a name of its own");
                first.force += record.force;
                ++first.samples;
                return {};
            }
        }
        records_.push_back(std::move(record));
        return {};
    }

    static bool sameConditions(const ForceRecord& a, const ForceRecord& b) {
        return a.material == b.material && a.axis == b.axis && a.feedDirection == b.feedDirection &&
               a.spindleSpeed == b.spindleSpeed && a.diameter == b.diameter && a.teeth == b.teeth &&
               a.axialDepth == b.axialDepth && a.radialDepth == b.radialDepth && a.feed == b.feed &&
               a.immersion == b.immersion && a.statedRate == b.statedRate;
    }

    std::string_view rest_;
    const std::string& origin_;
    std::size_t line_ = 0;
    std::vector<ForceRecord> records_;
    std::map<std::string, std::size_t> cuts_;
};

} // namespace

double ForceRecord::toolEdgeSpeed() const noexcept {
    return pi * diameter * spindleSpeed / secondsPerMinute;
}

double ForceRecord::removalRate() const noexcept {
    return statedRate ? *statedRate : axialDepth * radialDepth * feed / secondsPerMinute;
}

double ForceRecord::feedPerTooth() const noexcept {
    return feed / (spindleSpeed * teeth);
}

double ForceRecord::meanChipThickness() const noexcept {
    const double width = 2.0 * radialDepth / diameter; // divided by the radius
    const double arc = std::acos(std::clamp(1.0 - width, -1.0, 1.0));
    return arc > 0.0 ? feedPerTooth() * width / arc : 0.0;
}

Result<std::vector<ForceRecord>> parseForceRecords(std::string_view text, const std::string& origin) {
    if (text.empty()) return Error{ErrorCode::fileEmpty, origin, {}, {}};
    return Reading(text, origin).all();
}

std::vector<std::string_view> forceRecordColumns(bool required) {
    std::vector<std::string_view> names;
    for (const Column& column : columns)
        if (column.required == required) names.push_back(column.name);
    return names;
}

} // namespace burin
