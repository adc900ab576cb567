// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Index of an entry of a property list. 0 is always air.
using PropertyIndex = std::uint8_t;
inline constexpr PropertyIndex airProperty = 0;
/// Maximum number of machinable entries in a list, grades included: the result of one cut has room for this many.
inline constexpr int maximumMachinableProperties = 32;
/// Maximum number of machinable materials that are not grades of another: a recorded sample has room for the removed
/// volume of this many. Grades are recorded as the material that they belong to (PropertyList::baseOf).
inline constexpr int maximumMachinableMaterials = 8;

/// What a cutter may do to a run.
enum class Machinability : std::uint8_t { machinable, isProtected };

/// One value of a material, with its source.
struct NamedValue {
    double value = 0.0;
    std::string unit;      ///< "J/mm^3", "g/cm^3", "1"
    std::string source;    ///< publication, table, edition
    bool estimate = false; ///< true: not published anywhere; calibrate before relying on results that depend on it
};

// Names of values that Burin itself reads. A material may have further values of any name.
inline constexpr std::string_view specificCuttingEnergy = "specific_cutting_energy"; ///< K, J/mm^3 (paper, eq. 11)
inline constexpr std::string_view radialForceRatio = "radial_force_ratio";           ///< Kr, 1 (paper, eq. 13)
// Kienzle: K(h) = kc1.1 · (h / 1 mm)^-mc / 1000 of a chip of thickness h; used in place of K if a material has both.
inline constexpr std::string_view kienzleForce = "kienzle_kc11";                  ///< kc1.1, N/mm^2
inline constexpr std::string_view kienzleExponent = "kienzle_mc";                 ///< mc, 1
inline constexpr std::string_view density = "density";                            ///< g/cm^3
inline constexpr std::string_view surfaceSpeed = "surface_speed";                 ///< carbide, m/min
inline constexpr std::string_view chipLoadPerDiameter = "chip_load_per_diameter"; ///< fz / D, 1
inline constexpr std::string_view plungeFeedRatio = "plunge_feed_ratio";          ///< plunge feed / feed, 1

/// One entry of the property list: the paper's physical domain.
struct Property {
    std::string id;                                    ///< "aluminium-6061", stable
    std::string name;                                  ///< English, shown through translation
    std::array<std::uint8_t, 3> colour{128, 128, 128}; ///< sRGB
    Machinability machinability = Machinability::machinable;
    std::string base; ///< grades (graded.h): id of the material that this is a grade of; otherwise empty
    std::map<std::string, NamedValue, std::less<>> values;

    /// The value called `valueName`, or `otherwise` if the material has none.
    double valueOr(std::string_view valueName, double otherwise) const;
};

/// The property list of a volume: air and up to 255 materials, of which at most `maximumMachinableProperties` are
/// machinable, and of these at most `maximumMachinableMaterials` are not grades.
class PropertyList {
public:
    PropertyList(); ///< contains only air

    /// Errors: argumentInvalid (an id that exists already, a full list, a grade whose base is not in the list, is a
    /// grade itself or has another machinability).
    Result<PropertyIndex> add(Property property);
    /// @param index  below `size`, not checked. The reference is valid until the next `add`.
    const Property& operator[](PropertyIndex index) const { return entries_[index]; }
    int size() const noexcept { return static_cast<int>(entries_.size()); } ///< air included
    /// Whether the entry is never cut, as a part or a fixture. False for air and for an index without an entry.
    bool isProtected(PropertyIndex index) const noexcept { return protected_[index]; }
    /// The material that an entry is a grade of; the entry itself if it is not a grade.
    PropertyIndex baseOf(PropertyIndex index) const noexcept { return base_[index]; }

private:
    std::vector<Property> entries_;
    std::array<bool, 256> protected_{};
    std::array<PropertyIndex, 256> base_{};
};

/// Reads a material that Burin is shipped with or that the user added: `<id>.json` files of one folder.
/// Errors: nameUnknown, resourceInvalid.
Result<Property> loadMaterial(std::string_view id);
/// Ids of all available materials, sorted.
std::vector<std::string> materialIds();
/// The file of the user's own library (userResourceDirectory), which `loadMaterial` searches first, for a material with
/// this id. Without `replace` an id in use is rejected, including those that Burin is shipped with, because the new
/// material would hide that one. Errors: argumentInvalid (not a valid id, or one in use), fileNotWritable.
Result<std::filesystem::path> userMaterialFile(const std::string& id, bool replace);

/// Converts a material to JSON text and back; the form of resources/materials and of the project file.
std::string toJson(const Property& property);
/// @param origin  file name for error messages. Errors: resourceInvalid.
Result<Property> propertyFromJson(std::string_view text, const std::string& origin);

} // namespace burin
