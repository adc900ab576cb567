// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/project.h"

#include <cstddef>
#include <filesystem>
#include <vector>

/// Contents for projects in tests: small, made by formula, the same in every run.
namespace burin::fixture {

/// Samples `first` … `first + count - 1` of a hand that mills in circles, with the noise of a device.
std::vector<Sample> handSamples(std::size_t first, std::size_t count);
TakeInfo takeInfo(const char* name);
/// Two bodies, one without a colour, with notes and bytes that pose as a B-rep.
Model model();
/// The same, told from others by the name of its first body.
Model modelNamed(const std::string& name);
/// That name in a project; "none" and why, where there is no model.
std::string nameIn(const Project& project);
/// @param version that knew it: before 5 every body was a part in a box of one material
Setup setup(int version = 11);
/// Equal in all that a project keeps of it.
bool identical(const Setup& one, const Setup& other);
std::vector<Property> materials();
Tool tool();
/// A fixture as a mesh, another as a cylinder, and a space to be kept clear that is off.
std::vector<Obstacle> obstacles();
AxisMode axisMode();
TravelPlacement travelPlacement();
/// One of each kind.
KeptGuides guides();
/// Two strokes of three points each, with gaps in their moments; no id yet.
/// @param version that knew it: before 9 nothing was kept of what was asked for
GeneratedMoves generatedMoves(int version = 11);

/// A saved project with one of everything, and whether a project holds just that (whole_project.cpp).
bool fillProject(const std::filesystem::path& file);
/// @param version that wrote it: an old one knew less
bool holdsFixture(const Project& project, int version = 11);
/// What `fillProject` takes back of its first take, since version 2.
inline constexpr SampleRange undoneInFixture{100, 50};
inline constexpr SampleRange offInFixture{300, 50}; ///< switched off, since version 10

/// Equal bit for bit; padding apart.
bool identical(const Sample& one, const Sample& other);
bool identical(const std::vector<Sample>& one, const std::vector<Sample>& other);
bool identical(const Model& one, const Model& other);
/// Names, points and marks; not ids and setups.
bool identical(const GeneratedMoves& one, const GeneratedMoves& other);
/// Guides by what they are and where their curves lead; tangents to the last digit but one.
bool identical(const KeptGuides& one, const KeptGuides& other);

} // namespace burin::fixture
