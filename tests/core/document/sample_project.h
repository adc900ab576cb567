// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <cstddef>
#include <filesystem>
#include <vector>

/// Contents for projects in tests: small, computed by formula, the same in every run.
namespace burin::fixture {

/// Samples `first` … `first + count - 1` of a hand that mills in circles, with the noise of a device.
std::vector<Sample> handSamples(std::size_t first, std::size_t count);
TakeInfo takeInfo(const char* name);
/// Two bodies, one without a colour, with notes and arbitrary bytes in place of a B-rep.
Model model();
/// The same, identified by the name of its first body.
Model modelNamed(const std::string& name);
/// That name in a project; "none" and the reason if there is no model.
std::string nameIn(const Project& project);
/// @param version the file version: before 5 every body was a part in a box of one material
Setup setup(int version = 13);
/// Equal in everything that a project stores of it.
bool identical(const Setup& one, const Setup& other);
std::vector<Property> materials();
Tool tool();
/// A fixture as a mesh, another as a cylinder, and a keep-out space that is off.
std::vector<Obstacle> obstacles();
AxisMode axisMode();
TravelPlacement travelPlacement();
/// One of each kind.
KeptGuides guides();
/// Two strokes of three points each, with gaps in their moments; no id yet.
/// @param version the file version: before 9 the request was not stored
GeneratedMoves generatedMoves(int version = 13);

/// A saved project with one of everything, and whether a project contains exactly that (whole_project.cpp).
bool fillProject(const std::filesystem::path& file);
/// @param version the version that wrote it: an old one stored less
bool holdsFixture(const Project& project, int version = 13);
/// The samples of its first take that `fillProject` undoes, since version 2.
inline constexpr SampleRange undoneInFixture{100, 50};
inline constexpr SampleRange offInFixture{300, 50}; ///< switched off, since version 10

/// Bitwise equal, except padding.
bool identical(const Sample& one, const Sample& other);
bool identical(const std::vector<Sample>& one, const std::vector<Sample>& other);
bool identical(const Model& one, const Model& other);
/// Compares names, points and marks; not ids and setups.
bool identical(const GeneratedMoves& one, const GeneratedMoves& other);
/// Compares guides by their kind and curves; tangents to the second-last digit.
bool identical(const KeptGuides& one, const KeptGuides& other);

} // namespace burin::fixture
