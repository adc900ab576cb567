// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/hid/uhid_device.h"

#include <string_view>

/// Report descriptors as recorded from real devices.
namespace burin::test {

inline Report bytesOf(std::string_view hex) {
    Report bytes;
    int high = -1;
    for (const char c : hex) {
        const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
        if (digit < 0) continue;
        if (high < 0) {
            high = digit;
        } else {
            bytes.push_back(static_cast<std::uint8_t>(high * 16 + digit));
            high = -1;
        }
    }
    return bytes;
}

/// SpaceNavigator, 217 bytes. Source: AndunHH/spacemouse, SpaceNavigator.md.
inline constexpr std::string_view navigatorDescriptor = R"(
05 01 09 08 a1 01 a1 00 85 01 16 a2 fe 26 5e 01 36 88 fa 46 78 05 55 0c 65 11 09 30 09 31 09 32
75 10 95 03 81 06 c0 a1 00 85 02 09 33 09 34 09 35 75 10 95 03 81 06 c0 a1 02 85 03 05 01 05 09
19 01 29 02 15 00 25 01 35 00 45 01 75 01 95 02 81 02 95 0e 81 03 c0 a1 02 85 04 05 08 09 4b 15
00 25 01 95 01 75 01 91 02 95 01 75 07 91 03 c0 06 00 ff 09 01 a1 02 15 80 25 7f 75 08 09 3a a1
02 85 05 09 20 95 01 b1 02 c0 a1 02 85 06 09 21 95 01 b1 02 c0 a1 02 85 07 09 22 95 01 b1 02 c0
a1 02 85 08 09 23 95 07 b1 02 c0 a1 02 85 09 09 24 95 07 b1 02 c0 a1 02 85 0a 09 25 95 07 b1 02
c0 a1 02 85 0b 09 26 95 01 b1 02 c0 a1 02 85 13 09 2e 95 01 b1 02 c0 c0 c0)";

/// SpaceMouse Wireless: axes, buttons, LED, battery; without its feature reports. Source: AndunHH/spacemouse,
/// SpaceMouseWireless.md.
inline constexpr std::string_view wirelessDescriptor = R"(
05 01 09 08 a1 01 a1 00 85 01 16 a2 fe 26 5e 01 36 88 fa 46 78 05 55 0c 65 11 09 30 09 31 09 32
09 33 09 34 09 35 75 10 95 06 81 02 c0 a1 02 85 03 05 01 05 09 19 01 29 02 15 00 25 01 35 00 45
01 75 01 95 02 81 02 95 0e 81 03 c0 a1 02 85 04 05 08 09 4b 15 00 25 01 95 01 75 01 91 02 95 01
75 07 91 03 c0 a1 02 85 17 15 00 25 64 55 00 65 00 05 06 09 20 75 08 95 01 81 02 15 00 25 01 06
00 ff 09 27 75 01 95 01 81 02 75 07 81 03 c0 c0)";

/// SpaceMouse Enterprise: axes, button bits, button numbers, LEDs; without its feature reports. Source:
/// TheHoodedFoot/SpaceLCD, issue 3.
inline constexpr std::string_view enterpriseDescriptor = R"(
05 01 09 08 a1 01 a1 00 85 01 16 a2 fe 26 5e 01 36 88 fa 46 78 05 55 0c 65 11 09 30 09 31 09 32
09 33 09 34 09 35 75 10 95 06 81 02 c0 a1 02 85 03 05 01 05 09 19 01 29 1f 15 00 25 01 35 00 45
01 75 01 95 1f 81 02 95 01 81 03 c0 a1 02 85 1c 05 01 05 09 19 00 2a ff 00 15 00 26 ff 00 35 00
46 ff 00 75 10 95 06 81 00 c0 a1 02 85 04 05 08 09 4b 09 4c 15 00 25 01 95 02 75 01 91 02 95 01
75 06 91 03 c0 c0)";

/// A gamepad: X, Y, Rx, Ry of 16 bits, Z and Rz of 8, twelve buttons (HID 1.11, appendix E, as pads lay it out).
inline constexpr std::string_view gamepadDescriptor = R"(
05 01 09 05 a1 01 16 00 80 26 ff 7f 09 30 09 31 09 33 09 34 75 10 95 04 81 02 15 00 26 ff 00 09
32 09 35 75 08 95 02 81 02 05 09 19 01 29 0c 15 00 25 01 75 01 95 0c 81 02 75 04 95 01 81 03 c0)";

/// A pen tablet, 300 by 200 mm in steps of 0.01 mm, 2048 steps of pressure, tilt in degrees (HID Usage Tables,
/// Digitizers): tip, two buttons on the barrel, in range; x, y, pressure; tilts.
inline constexpr std::string_view tabletDescriptor = R"(
05 0d 09 02 a1 01 09 20 a1 00 09 42 09 44 09 5a 09 32 15 00 25 01 75 01 95 04 81 02 95 04 81 03
05 01 09 30 15 00 27 30 75 00 00 35 00 46 2c 01 55 0f 65 11 75 20 95 01 81 02 09 31 27 20 4e 00
00 46 c8 00 81 02 05 0d 09 30 15 00 26 ff 07 35 00 45 00 55 00 65 00 75 10 81 02 09 3d 09 3e 15
c4 25 3c 35 c4 45 3c 65 14 75 08 95 02 81 02 c0 c0)";

/// A mouse with two buttons and a wheel (HID 1.11, appendix E.10, with a wheel).
inline constexpr std::string_view mouseDescriptor = R"(
05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02 95 01 75 05 81 01
05 01 09 30 09 31 09 38 15 81 25 7f 75 08 95 03 81 06 c0 c0)";

} // namespace burin::test
