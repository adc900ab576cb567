// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"
#include "core/base/result.h"

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Reads a JSON object strictly: every key is requested once, with its type and range; an unrequested, missing or
/// duplicate key, a wrong type and a value out of range are faults. The first fault is kept and names the key with its
/// path from the top ("cutter.holder[1].length_mm"); reading continues with harmless values, so that a reader has to
/// check only once, in `finish`. One thread.
class JsonObject {
public:
    /// @param origin file name for messages. Errors: resourceInvalid (not JSON, not an object, a duplicate key).
    static Result<JsonObject> parse(std::string_view text, const std::string& origin);

    /// A faulty number is replaced by the lowest value of the range (or 0).
    double number(std::string_view key, NumberRange range = {});
    double numberOr(std::string_view key, double otherwise, NumberRange range = {});
    int integer(std::string_view key, int low, int high);
    bool boolean(std::string_view key);
    bool booleanOr(std::string_view key, bool otherwise);
    std::string text(std::string_view key); ///< not empty
    /// Index of the text in `choices`; 0 replaces a faulty one.
    std::size_t choice(std::string_view key, const std::vector<std::string_view>& choices);
    std::vector<double> numbers(std::string_view key, std::size_t count, NumberRange range = {});
    /// Any count that is a multiple of `group`.
    std::vector<double> numbers(std::string_view key, NumberRange range, std::size_t group);
    std::vector<std::string> texts(std::string_view key); ///< any number, none of them empty
    void object(std::string_view key, const std::function<void(JsonObject&)>& read);
    void objects(std::string_view key, const std::function<void(JsonObject&)>& read);
    /// An object whose keys are data: each of its values must be an object.
    void objectsByName(std::string_view key, const std::function<void(const std::string& name, JsonObject&)>& read);

    /// An object whose keys are data and whose values are texts, none of them empty.
    std::map<std::string, std::string> textsByName(std::string_view key);

    bool has(std::string_view key) const;
    /// Reports a fault of `key`, for rules that involve several keys.
    void fail(std::string_view key, std::string detail);

    /// The first fault, or an unknown key. For nested objects it is called by the functions that read them.
    Result<void> finish();

private:
    struct Shared;
    JsonObject(std::shared_ptr<Shared> shared, const nlohmann::json& node, std::string path);
    const nlohmann::json* find(std::string_view key);
    double checked(std::string_view key, const nlohmann::json& value, NumberRange range);
    std::string pathOf(std::string_view key) const;
    void readNested(const nlohmann::json& node, const std::string& path, const std::function<void(JsonObject&)>& read);
    void failAt(std::string path, std::string detail);

    std::shared_ptr<Shared> shared_;
    const nlohmann::json* node_;
    std::string path_;
    std::set<std::string, std::less<>> asked_;
};

} // namespace burin
