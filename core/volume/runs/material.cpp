// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/json_object.h"
#include "core/base/resource_folder.h"
#include "core/volume/runs/property_list.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace burin {

namespace {

std::array<std::uint8_t, 3> readColour(JsonObject& object) {
    const std::vector<double> channels = object.numbers("colour", 3, {0.0, 255.0});
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t i = 0; i < colour.size() && i < channels.size(); ++i) {
        if (channels[i] != std::floor(channels[i])) object.fail("colour", "has to be whole numbers");
        colour[i] = static_cast<std::uint8_t>(channels[i]);
    }
    return colour;
}

NamedValue readValue(JsonObject& object) {
    NamedValue value;
    value.value = object.number("value");
    value.unit = object.text("unit");
    value.source = object.text("source");
    value.estimate = object.booleanOr("estimate", false);
    return value;
}

} // namespace

std::string toJson(const Property& property) {
    nlohmann::ordered_json object;
    object["id"] = property.id;
    object["name"] = property.name;
    object["colour"] = property.colour;
    object["machinability"] = property.machinability == Machinability::machinable ? "machinable" : "protected";
    if (!property.base.empty()) object["base"] = property.base;
    auto& values = object["values"] = nlohmann::ordered_json::object();
    for (const auto& [name, value] : property.values)
        values[name] = {
            {"value", value.value}, {"unit", value.unit}, {"source", value.source}, {"estimate", value.estimate}};
    // A name that is not UTF-8 must not cause an exception.
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Result<Property> propertyFromJson(std::string_view text, const std::string& origin) {
    Result<JsonObject> object = JsonObject::parse(text, origin);
    if (!object) return object.error();
    Property property;
    property.id = object->text("id");
    property.name = object->text("name");
    property.colour = readColour(*object);
    constexpr std::size_t protectedChoice = 1;
    property.machinability = object->choice("machinability", {"machinable", "protected"}) == protectedChoice
                                 ? Machinability::isProtected
                                 : Machinability::machinable;
    if (object->has("base")) property.base = object->text("base");
    object->objectsByName(
        "values", [&](const std::string& name, JsonObject& value) { property.values.emplace(name, readValue(value)); });
    if (Result<void> read = object->finish(); !read) return read.error();
    return property;
}

Result<Property> loadMaterial(std::string_view id) {
    const Result<ResourceText> resource = findResource(materialResource, id);
    if (!resource) return resource.error();
    Result<Property> property = propertyFromJson(resource->text, resource->file);
    if (property && property->id != id)
        return Error{ErrorCode::resourceInvalid, resource->file, "id", "differs from the file's name"};
    return property;
}

std::vector<std::string> materialIds() {
    return resourceIds(materialResource);
}

Result<std::filesystem::path> userMaterialFile(const std::string& id, bool replace) {
    Result<std::filesystem::path> file = userResourceFile(materialResource, id);
    if (file && !replace && findResource(materialResource, id))
        return Error{ErrorCode::argumentInvalid, "material", id, "an id that no material has yet, or --replace"};
    return file;
}

} // namespace burin
