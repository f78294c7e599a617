#pragma once

#include "cases/model/printed_problem.hpp"

namespace handhold::realtime::paper {

/// The law's switches, a shape's normals and the host's options belong to the model: the middleware calls them its own.
using namespace handhold::printed;

}  // namespace handhold::realtime::paper
