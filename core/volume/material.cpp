// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/file.h"
#include "core/volume/property_list.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace burin {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// Folders that hold materials; what stands in an earlier one hides what stands in a later one.
std::vector<fs::path> materialDirectories() {
    std::vector<fs::path> directories;
    const char* data = std::getenv("XDG_DATA_HOME");
    const char* home = std::getenv("HOME");
    // The XDG base directory specification: a relative path in the variable is to be ignored.
    if (data != nullptr && fs::path(data).is_absolute())
        directories.push_back(fs::path(data) / "burin" / "materials");
    else if (home != nullptr && fs::path(home).is_absolute())
        directories.push_back(fs::path(home) / ".local" / "share" / "burin" / "materials");
    directories.push_back(resourceDirectory() / "materials");
    return directories;
}

/// What stops the reading of a material; it never leaves this file.
struct Invalid {
    std::string key, reason;
};

void allowKeys(const Json& object, std::initializer_list<std::string_view> known, const std::string& prefix) {
    if (!object.is_object()) throw Invalid{prefix, "has to be an object"};
    for (const auto& [key, ignored] : object.items())
        if (std::find(known.begin(), known.end(), key) == known.end())
            throw Invalid{prefix.empty() ? key : prefix + "." + key, "is not known"};
}

const Json& require(const Json& object, const char* key, const std::string& prefix) {
    const auto found = object.find(key);
    if (found == object.end()) throw Invalid{prefix + key, "is missing"};
    return *found;
}

std::string text(const Json& object, const char* key, const std::string& prefix = {}) {
    const Json& value = require(object, key, prefix);
    if (!value.is_string()) throw Invalid{prefix + key, "has to be a text"};
    return value.get<std::string>();
}

std::array<std::uint8_t, 3> colour(const Json& object) {
    const Json& value = require(object, "colour", {});
    std::array<std::uint8_t, 3> result{};
    if (!value.is_array() || value.size() != result.size()) throw Invalid{"colour", "has to be three numbers"};
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (!value[i].is_number_integer() || value[i].get<std::int64_t>() < 0 || value[i].get<std::int64_t>() > 255)
            throw Invalid{"colour", "has to be whole numbers from 0 to 255"};
        result[i] = value[i].get<std::uint8_t>();
    }
    return result;
}

Machinability machinability(const Json& object) {
    const std::string value = text(object, "machinability");
    if (value == "machinable") return Machinability::machinable;
    if (value == "protected") return Machinability::isProtected;
    throw Invalid{"machinability", "has to be \"machinable\" or \"protected\""};
}

NamedValue namedValue(const Json& object, const std::string& name) {
    const std::string prefix = "values." + name;
    allowKeys(object, {"value", "unit", "source", "estimate"}, prefix);
    const Json& number = require(object, "value", prefix + ".");
    if (!number.is_number() || !std::isfinite(number.get<double>()))
        throw Invalid{prefix + ".value", "has to be a finite number"};
    NamedValue result{number.get<double>(), text(object, "unit", prefix + "."), text(object, "source", prefix + "."),
                      false};
    if (const auto estimate = object.find("estimate"); estimate != object.end()) {
        if (!estimate->is_boolean()) throw Invalid{prefix + ".estimate", "has to be true or false"};
        result.estimate = estimate->get<bool>();
    }
    return result;
}

Property readProperty(const Json& object) {
    allowKeys(object, {"id", "name", "colour", "machinability", "values"}, {});
    Property property;
    property.id = text(object, "id");
    if (property.id.empty()) throw Invalid{"id", "is empty"};
    property.name = text(object, "name");
    property.colour = colour(object);
    property.machinability = machinability(object);
    const Json& values = require(object, "values", {});
    if (!values.is_object()) throw Invalid{"values", "has to be an object"};
    for (const auto& [name, value] : values.items()) property.values.emplace(name, namedValue(value, name));
    return property;
}

std::string join(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all;
}

/// An id names a file of a folder, never a way out of it.
bool isFileName(std::string_view id) {
    return !id.empty() && id.front() != '.' && id.find_first_of(std::string_view("/\\\0", 3)) == std::string_view::npos;
}

} // namespace

std::string toJson(const Property& property) {
    Json object;
    object["id"] = property.id;
    object["name"] = property.name;
    object["colour"] = property.colour;
    object["machinability"] = property.machinability == Machinability::machinable ? "machinable" : "protected";
    Json& values = object["values"] = Json::object();
    for (const auto& [name, value] : property.values)
        values[name] = {
            {"value", value.value}, {"unit", value.unit}, {"source", value.source}, {"estimate", value.estimate}};
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Property> propertyFromJson(std::string_view content, const std::string& origin) {
    try {
        return readProperty(Json::parse(content));
    } catch (const Invalid& invalid) {
        return Error{ErrorCode::resourceInvalid, origin, invalid.key, invalid.reason};
    } catch (const std::exception& fault) {
        return Error{ErrorCode::resourceInvalid, origin, {}, fault.what()};
    }
}

Result<Property> loadMaterial(std::string_view id) {
    if (isFileName(id))
        for (const fs::path& directory : materialDirectories()) {
            const fs::path file = directory / (std::string(id) + ".json");
            const Result<std::string> content = readFile(file);
            if (!content && content.error().code == ErrorCode::fileNotFound) continue;
            if (!content) return content.error();
            Result<Property> property = propertyFromJson(*content, file.string());
            if (property && property->id != id)
                return Error{ErrorCode::resourceInvalid, file.string(), "id", "differs from the file's name"};
            return property;
        }
    return Error{ErrorCode::nameUnknown, "material", std::string(id), join(materialIds())};
}

std::vector<std::string> materialIds() {
    std::vector<std::string> ids;
    for (const fs::path& directory : materialDirectories()) {
        std::error_code failed;
        for (fs::directory_iterator file(directory, failed), end; !failed && file != end; file.increment(failed))
            if (file->path().extension() == ".json") ids.push_back(file->path().stem().string());
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    return ids;
}

} // namespace burin
