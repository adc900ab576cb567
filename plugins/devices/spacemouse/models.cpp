// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/spacemouse/models.h"

#include <algorithm>
#include <array>

namespace burin::spacemouse {
namespace {

constexpr std::uint16_t logitech = 0x046d, connexion = 0x256f;

// Numbers and names: FreeSpacenav/spacenavd (src/dev.c) and JakubAndrysek/PySpaceMouse (devices.toml).
constexpr std::array models{
    Model{logitech, 0xc603, "SpaceMouse Plus XT", 10, false},
    Model{logitech, 0xc605, "CadMan", 4, false},
    Model{logitech, 0xc606, "SpaceMouse Classic", 8, false},
    Model{logitech, 0xc621, "Spaceball 5000", 12, false},
    Model{logitech, 0xc623, "SpaceTraveler", 8, false},
    Model{logitech, 0xc625, "SpacePilot", 21, false},
    Model{logitech, 0xc626, "SpaceNavigator", 2, false},
    Model{logitech, 0xc627, "SpaceExplorer", 15, false},
    Model{logitech, 0xc628, "SpaceNavigator for Notebooks", 2, false},
    Model{logitech, 0xc629, "SpacePilot Pro", 31, false},
    Model{logitech, 0xc62b, "SpaceMouse Pro", 27, false},
    Model{logitech, 0xc640, "nuLOOQ", 5, false},
    Model{connexion, 0xc62e, "SpaceMouse Wireless", 2, true},
    Model{connexion, 0xc62f, "SpaceMouse Wireless", 2, true},
    Model{connexion, 0xc631, "SpaceMouse Pro Wireless", 27, true},
    Model{connexion, 0xc632, "SpaceMouse Pro Wireless", 27, true},
    Model{connexion, 0xc633, "SpaceMouse Enterprise", 32, false},
    Model{connexion, 0xc635, "SpaceMouse Compact", 2, false},
    Model{connexion, 0xc636, "SpaceMouse Module", 2, false},
    Model{connexion, 0xc638, "SpaceMouse Pro Wireless", 27, true},
    Model{connexion, 0xc63a, "SpaceMouse Wireless", 2, true},
    Model{connexion, 0xc652, "3Dconnexion Universal Receiver", 32, true},
};

/// Mice and keyboards of the same vendor, which show a multi-axis interface on some receivers. c641 is not listed, so
/// that its usage decides: the two sources disagree about it.
constexpr std::array<std::uint16_t, 11> others{0xc62c, 0xc650, 0xc651, 0xc654, 0xc655, 0xc656,
                                               0xc657, 0xc658, 0xc664, 0xc665, 0xc668};

} // namespace

const Model* modelOf(std::uint16_t vendor, std::uint16_t product) noexcept {
    const auto found = std::ranges::find_if(
        models, [&](const Model& model) { return model.vendor == vendor && model.product == product; });
    return found == models.end() ? nullptr : &*found;
}

bool isSpaceMouse(std::uint16_t vendor, std::uint16_t product, std::uint16_t usagePage, std::uint16_t usage) noexcept {
    if (vendor != logitech && vendor != connexion) return false;
    if (vendor == connexion && std::ranges::find(others, product) != others.end()) return false;
    if (usagePage == 0 && usage == 0) return modelOf(vendor, product) != nullptr;
    return usagePage == 0x01 && usage == 0x08;
}

} // namespace burin::spacemouse
