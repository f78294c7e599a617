// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cases/model/printed_problem.hpp"

namespace handhold::realtime::paper {

// The law's switches, a surface's normals and the host's options are the model's: a problem of level L3 has them too.
using printed::AnchorUpdate;
using printed::ApartAnchor;
using printed::as_printed;
using printed::coulomb;
using printed::Gate;
using printed::HostOptions;
using printed::Integrator;
using printed::Normals;
using printed::Options;
using printed::Order;
using printed::Point;
using printed::Sign;
using printed::SlipForce;
using printed::SlipState;

}  // namespace handhold::realtime::paper
