// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/measure/session.h"

namespace burin::benchmarks {

void tickFigures(Session& session);         ///< tick.*: what a tick costs
void pushBackFigures(Session& session);     ///< proxy.*
void peerFigures(Session& session);         ///< peer.*: the proxy against a god-object on the mesh and a point shell
void slotFigures(Session& session);         ///< slot.*
void shankFigures(Session& session);        ///< shank.*
void stockLayerFigures(Session& session);   ///< stock_layer.*: shank and holder kept away from the stock
void contactForceFigures(Session& session); ///< press.*, free.*
void stabilityFigures(Session& session);    ///< energy.*, nohand.*, noise.*
void guardFigures(Session& session);        ///< guards.*
void stopFigures(Session& session);         ///< stop.*
void deviceFigures(Session& session);       ///< hid.*
void firstCutFigures(Session& session);     ///< first_cut.*: from the request to mill, without the hand's own time

} // namespace burin::benchmarks
