// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/trace/traced_session.h"

#include "core/base/json_object.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

using nlohmann::json;

constexpr std::string_view beginning = R"({"session":)";
constexpr double largestWord = 4294967295.0; // 32 bits of buttons
constexpr NumberRange atLeastNothing{0.0, std::numeric_limits<double>::infinity()};

/// Visits every value of a description with its key. @tparam Description const or not
template <class Description, class Visit>
void forEachFigure(Description& stylus, const Visit& visit) {
    visit("rate_hz", stylus.rate);
    visit("delay_s", stylus.delay);
    visit("maximum_force_n", stylus.maximumForce);
    visit("continuous_force_n", stylus.continuousForce);
    visit("maximum_torque_n_mm", stylus.maximumTorque);
    visit("maximum_stiffness_n_per_m", stylus.maximumStiffness);
    visit("maximum_damping_n_s_per_m", stylus.maximumDamping);
    visit("maximum_turning_stiffness_n_mm_per_rad", stylus.maximumTurningStiffness);
    visit("workspace_radius_mm", stylus.workspaceRadius);
    visit("position_step_mm", stylus.positionStep);
    visit("rotation_step_rad", stylus.rotationStep);
    visit("maximum_speed_mm_per_s", stylus.maximumSpeed);
    visit("handle_mass_kg", stylus.handleMass);
}

json toJson(const StylusDescription& stylus) {
    json object{{"name", stylus.name},
                {"sensed", {stylus.sensed.translations, stylus.sensed.rotations}},
                {"actuated", {stylus.actuated.translations, stylus.actuated.rotations}},
                {"buttons", stylus.buttons},
                {"carries_handle", stylus.carriesHandle},
                {"simulated", stylus.simulated}};
    forEachFigure(stylus, [&object](const char* key, const auto& figure) {
        object[key] = {{"value", figure.value}};
        if (!figure.source.empty()) object[key]["source"] = figure.source;
    });
    return object;
}

Freedoms freedoms(JsonObject& object, std::string_view key) {
    const std::vector<double> counts = object.numbers(key, 2, {0.0, 3.0});
    return {static_cast<int>(counts[0]), static_cast<int>(counts[1])};
}

StylusDescription readStylus(JsonObject& object) {
    StylusDescription stylus;
    stylus.name = object.text("name");
    stylus.sensed = freedoms(object, "sensed");
    stylus.actuated = freedoms(object, "actuated");
    stylus.buttons = object.integer("buttons", 0, 32);
    stylus.carriesHandle = object.boolean("carries_handle");
    stylus.simulated = object.boolean("simulated");
    forEachFigure(stylus, [&object](const char* key, auto& figure) {
        object.object(key, [&figure](JsonObject& inner) {
            figure.value = inner.number("value", atLeastNothing);
            if (inner.has("source")) figure.source = inner.text("source");
        });
    });
    return stylus;
}

json toJson(const WorkspaceMapping& mapping) {
    const glm::dvec3& o = mapping.origin;
    const glm::dquat& q = mapping.rotation;
    return {{"origin_mm", {o.x, o.y, o.z}}, {"rotation", {q.w, q.x, q.y, q.z}}, {"scale", mapping.scale}};
}

json toJson(const FeltCutting& felt) {
    return {{"gain", felt.gain}, {"friction", felt.friction}};
}

json toJson(const AxisMode& axis) {
    return {{"free", axis.free}, {"direction", {axis.direction.x, axis.direction.y, axis.direction.z}}};
}

/// Limits that there are.
json toJson(const GainLimits& gains) {
    json object = json::object();
    if (gains.stiffness < GainLimits::none) object["stiffness_n_per_m"] = gains.stiffness;
    if (gains.damping < GainLimits::none) object["damping_n_s_per_m"] = gains.damping;
    return object;
}

GainLimits readGains(JsonObject& object) {
    GainLimits gains;
    if (object.has("stiffness_n_per_m"))
        gains.stiffness = object.number("stiffness_n_per_m", {GainLimits::softest, 1e9});
    if (object.has("damping_n_s_per_m")) gains.damping = object.number("damping_n_s_per_m", atLeastNothing);
    return gains;
}

json toJson(const std::vector<TracedSession::Layer>& layers) {
    json list = json::array();
    for (const TracedSession::Layer& layer : layers) {
        json one{{"kind", layer.kind}, {"on", layer.on}};
        if (!layer.name.empty()) one["name"] = layer.name;
        list.push_back(std::move(one));
    }
    return list;
}

TracedSession::Layer readLayer(JsonObject& object) {
    return {object.text("kind"), object.has("name") ? object.text("name") : std::string(), object.boolean("on")};
}

AxisMode readAxis(JsonObject& object) {
    const std::vector<double> d = object.numbers("direction", 3, {-1.0, 1.0});
    const AxisMode axis{object.boolean("free"), {d[0], d[1], d[2]}};
    if (std::abs(glm::length(axis.direction) - 1.0) > 1e-6) object.fail("direction", "has to be of unit length");
    return axis;
}

WorkspaceMapping readMapping(JsonObject& object) {
    const std::vector<double> o = object.numbers("origin_mm", 3), q = object.numbers("rotation", 4);
    return {{o[0], o[1], o[2]}, glm::dquat(q[0], q[1], q[2], q[3]), object.number("scale", {1e-9, 1e9})};
}

} // namespace

std::string formatTracedSession(const TracedSession& session) {
    json inner{{"stylus", toJson(session.stylus)},       {"mapping", toJson(session.mapping)},
               {"allowance_mm", session.allowance},      {"period_s", session.period},
               {"cuts_on_button", session.cutsOnButton}, {"force_buttons", session.forceButtons},
               {"felt", toJson(session.felt)},           {"axis", toJson(session.axis)}};
    if (session.growth)
        inner["boundary_grows"] = {{"maximum_allowance_mm", session.growth->maximumAllowance},
                                   {"whole", session.growth->whole}};
    if (session.stock.distance > 0.0)
        inner["stock_layer"] = {{"distance_mm", session.stock.distance}, {"on", session.stock.on}};
    if (session.gains != GainLimits{}) inner["gain_limits"] = toJson(session.gains);
    if (!session.tool.empty()) inner["tool"] = session.tool;
    if (!session.layers.empty()) inner["layers"] = toJson(session.layers);
    return std::string(beginning) + inner.dump() + "}";
}

bool tellsTracedSession(std::string_view text) {
    return text.starts_with(beginning);
}

Result<TracedSession> readTracedSession(std::string_view text, const std::string& origin) {
    Result<JsonObject> object = JsonObject::parse(text, origin);
    if (!object) return std::move(object).error();
    TracedSession session;
    object->object("session", [&session](JsonObject& inner) {
        inner.object("stylus", [&](JsonObject& stylus) { session.stylus = readStylus(stylus); });
        inner.object("mapping", [&](JsonObject& mapping) { session.mapping = readMapping(mapping); });
        session.allowance = inner.number("allowance_mm", {0.0, 10.0}); // the same range as for `mill`
        session.period = inner.number("period_s", {1e-6, 1.0});
        session.cutsOnButton = inner.boolean("cuts_on_button");
        const double buttons = inner.number("force_buttons", {0.0, largestWord});
        if (std::floor(buttons) != buttons) inner.fail("force_buttons", "has to be a whole number");
        session.forceButtons = static_cast<std::uint32_t>(buttons);
        inner.object("felt", [&](JsonObject& felt) {
            session.felt = {felt.number("gain", atLeastNothing), felt.number("friction", atLeastNothing)};
        });
        inner.object("axis", [&](JsonObject& axis) { session.axis = readAxis(axis); });
        if (inner.has("boundary_grows"))
            inner.object("boundary_grows", [&](JsonObject& growth) {
                session.growth = {growth.number("maximum_allowance_mm", {0.0, 10.0}), growth.boolean("whole")};
            });
        if (inner.has("stock_layer"))
            inner.object("stock_layer", [&](JsonObject& stock) {
                session.stock = {stock.number("distance_mm", StockLayer::distances), stock.boolean("on")};
            });
        if (inner.has("gain_limits"))
            inner.object("gain_limits", [&](JsonObject& gains) { session.gains = readGains(gains); });
        if (inner.has("tool")) session.tool = inner.text("tool");
        if (inner.has("layers"))
            inner.objects("layers", [&](JsonObject& layer) { session.layers.push_back(readLayer(layer)); });
    });
    if (Result<void> whole = object->finish(); !whole) return std::move(whole).error();
    if (Result<void> good = checkDescription(session.stylus); !good) return std::move(good).error();
    return session;
}

} // namespace burin
