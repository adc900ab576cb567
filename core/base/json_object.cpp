// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/json_object.h"

#include "core/base/clean_text.h"
#include "core/base/json_number.h"
#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace burin {

using nlohmann::json;

namespace {

/// Finds where a text stops being JSON, and duplicate keys, which are faults here: nlohmann::json silently keeps the
/// last one. Its parser could call a function for each key too, but then searches a whole list after each object in it.
class TextCheck final : public json::json_sax_t {
public:
    const std::string& doubledKey() const noexcept { return first_; } ///< empty if there is none
    /// The number of bytes read when the text was found not to be JSON; 0 if it is.
    std::size_t brokenAfter() const noexcept { return brokenAfter_; }

    bool start_object(std::size_t) override {
        open_.emplace_back();
        return true;
    }
    bool end_object() override {
        open_.pop_back();
        return true;
    }
    bool key(string_t& name) override {
        if (!open_.back().insert(name).second && first_.empty()) first_ = name;
        return true;
    }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t read, const std::string&, const json::exception&) override {
        brokenAfter_ = read;
        return false;
    }

private:
    std::vector<std::set<std::string>> open_;
    std::string first_;
    std::size_t brokenAfter_ = 0;
};

/// "line 3, column 5" of the last of the bytes read.
std::string placeIn(std::string_view text, std::size_t read) {
    const std::string_view before = text.substr(0, std::min(text.size(), read - std::min<std::size_t>(read, 1)));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1; // npos + 1 is 0
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

std::string rangeText(NumberRange range) {
    if (std::isinf(range.low) && std::isinf(range.high)) return "a number";
    if (std::isinf(range.high)) return "a number of at least " + formatShortest(range.low);
    if (std::isinf(range.low)) return "a number of at most " + formatShortest(range.high);
    return "a number from " + formatShortest(range.low) + " to " + formatShortest(range.high);
}

double standIn(NumberRange range) {
    return std::isfinite(range.low) ? range.low : 0.0;
}

} // namespace

struct JsonObject::Shared {
    json document;
    std::string origin;
    std::optional<Error> fault;
};

Result<JsonObject> JsonObject::parse(std::string_view text, const std::string& origin) {
    auto shared = std::make_shared<Shared>();
    shared->origin = origin;
    shared->document = json::parse(text, nullptr, /*allow_exceptions=*/false);
    TextCheck check;
    json::sax_parse(text, &check);
    if (shared->document.is_discarded())
        return Error{ErrorCode::resourceInvalid, origin, placeIn(text, check.brokenAfter()), "is not JSON"};
    if (!shared->document.is_object()) return Error{ErrorCode::resourceInvalid, origin, {}, "is not a JSON object"};
    if (!check.doubledKey().empty())
        return Error{ErrorCode::resourceInvalid, origin, check.doubledKey(), "stands twice"};
    const json& top = shared->document;
    return JsonObject(std::move(shared), top, {});
}

JsonObject::JsonObject(std::shared_ptr<Shared> shared, const json& node, std::string path)
    : shared_(std::move(shared)), node_(&node), path_(std::move(path)) {}

std::string JsonObject::pathOf(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

void JsonObject::failAt(std::string path, std::string detail) {
    if (!shared_->fault)
        shared_->fault = Error{ErrorCode::resourceInvalid, shared_->origin, std::move(path), std::move(detail)};
}

void JsonObject::fail(std::string_view key, std::string detail) {
    failAt(pathOf(key), std::move(detail));
}

bool JsonObject::has(std::string_view key) const {
    return node_->contains(key);
}

const json* JsonObject::find(std::string_view key) {
    asked_.emplace(key);
    const auto found = node_->find(key);
    if (found != node_->end()) return &*found;
    fail(key, "is missing");
    return nullptr;
}

double JsonObject::checked(std::string_view key, const json& value, NumberRange range) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (std::isfinite(number) && number >= range.low && number <= range.high) return number;
    fail(key, "has to be " + rangeText(range));
    return standIn(range);
}

double JsonObject::number(std::string_view key, NumberRange range) {
    const json* value = find(key);
    return value != nullptr ? checked(key, *value, range) : standIn(range);
}

double JsonObject::numberOr(std::string_view key, double otherwise, NumberRange range) {
    return has(key) ? number(key, range) : otherwise;
}

int JsonObject::integer(std::string_view key, int low, int high) {
    const json* value = find(key);
    if (value == nullptr) return low;
    if (const std::optional<std::int64_t> number = wholeNumber(*value, low, high)) return static_cast<int>(*number);
    fail(key, "has to be a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return low;
}

bool JsonObject::boolean(std::string_view key) {
    const json* value = find(key);
    if (value == nullptr) return false;
    if (value->is_boolean()) return value->get<bool>();
    fail(key, "has to be true or false");
    return false;
}

bool JsonObject::booleanOr(std::string_view key, bool otherwise) {
    return has(key) ? boolean(key) : otherwise;
}

std::string JsonObject::text(std::string_view key) {
    const json* value = find(key);
    if (value == nullptr) return {};
    if (value->is_string() && !value->get_ref<const std::string&>().empty())
        return cleanLine(value->get_ref<const std::string&>());
    fail(key, "has to be a text that is not empty");
    return {};
}

std::size_t JsonObject::choice(std::string_view key, const std::vector<std::string_view>& choices) {
    const json* value = find(key);
    if (value == nullptr) return 0;
    if (value->is_string()) {
        const auto found = std::ranges::find(choices, std::string_view(value->get_ref<const std::string&>()));
        if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    }
    std::string allowed;
    for (const std::string_view one : choices) allowed += (allowed.empty() ? "" : ", ") + std::string(one);
    fail(key, "has to be one of: " + allowed);
    return 0;
}

std::vector<double> JsonObject::numbers(std::string_view key, std::size_t count, NumberRange range) {
    std::vector<double> result(count, standIn(range));
    const json* value = find(key);
    if (value == nullptr) return result;
    if (!value->is_array() || value->size() != count) {
        fail(key, "has to be a list of " + std::to_string(count) + " numbers");
        return result;
    }
    for (std::size_t i = 0; i < count; ++i)
        result[i] = checked(std::string(key) + "[" + std::to_string(i) + "]", (*value)[i], range);
    return result;
}

std::vector<double> JsonObject::numbers(std::string_view key, NumberRange range, std::size_t group) {
    std::vector<double> result;
    const json* value = find(key);
    if (value == nullptr) return result;
    if (!value->is_array() || value->size() % group != 0) {
        fail(key, "has to be a list of numbers" +
                      (group > 1 ? ", " + std::to_string(group) + " by " + std::to_string(group) : std::string()));
        return result;
    }
    result.reserve(value->size());
    for (std::size_t i = 0; i < value->size(); ++i)
        result.push_back(checked(std::string(key) + "[" + std::to_string(i) + "]", (*value)[i], range));
    return result;
}

std::vector<std::string> JsonObject::texts(std::string_view key) {
    std::vector<std::string> result;
    const json* value = find(key);
    if (value == nullptr) return result;
    if (!value->is_array()) {
        fail(key, "has to be a list of texts");
        return result;
    }
    for (std::size_t i = 0; i < value->size(); ++i) {
        const json& one = (*value)[i];
        if (one.is_string() && !one.get_ref<const std::string&>().empty())
            result.push_back(one.get<std::string>());
        else
            fail(std::string(key) + "[" + std::to_string(i) + "]", "has to be a text that is not empty");
    }
    return result;
}

void JsonObject::readNested(const json& node, const std::string& path, const std::function<void(JsonObject&)>& read) {
    if (!node.is_object()) {
        failAt(path, "has to be an object");
        return;
    }
    JsonObject nested(shared_, node, path);
    read(nested);
    (void)nested.finish(); // the shared state keeps a fault
}

void JsonObject::object(std::string_view key, const std::function<void(JsonObject&)>& read) {
    if (const json* value = find(key)) readNested(*value, pathOf(key), read);
}

void JsonObject::objects(std::string_view key, const std::function<void(JsonObject&)>& read) {
    const json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_array()) {
        fail(key, "has to be a list");
        return;
    }
    for (std::size_t i = 0; i < value->size(); ++i)
        readNested((*value)[i], pathOf(key) + "[" + std::to_string(i) + "]", read);
}

void JsonObject::objectsByName(std::string_view key,
                               const std::function<void(const std::string& name, JsonObject&)>& read) {
    const json* value = find(key);
    if (value == nullptr) return;
    if (!value->is_object()) {
        fail(key, "has to be an object");
        return;
    }
    for (const auto& item : value->items()) {
        const std::string& name = item.key();
        readNested(item.value(), pathOf(key) + "." + name, [&](JsonObject& nested) { read(name, nested); });
    }
}

std::map<std::string, std::string> JsonObject::textsByName(std::string_view key) {
    std::map<std::string, std::string> texts;
    const json* value = find(key);
    if (value == nullptr) return texts;
    if (!value->is_object()) {
        fail(key, "has to be an object");
        return texts;
    }
    for (const auto& item : value->items()) {
        if (item.value().is_string() && !item.value().get_ref<const std::string&>().empty())
            texts[item.key()] = item.value().get<std::string>();
        else
            fail(std::string(key) + "." + item.key(), "has to be a text that is not empty");
    }
    return texts;
}

Result<void> JsonObject::finish() {
    for (const auto& [key, value] : node_->items())
        if (!asked_.contains(key)) fail(key, "is not known");
    if (shared_->fault) return *shared_->fault;
    return {};
}

} // namespace burin
