# SPDX-License-Identifier: GPL-3.0-or-later
# All engines of the house, in the order of every table. One joins with a line here and a file <name>_engine.cpp beside this
# one that defines make_<name>_engine(), _ for -.
set(engines
  reference
  rigid
  realtime
  kinematic-grasp
  pinch-state
  paper
  paper-coulomb)
set(engines_on_simbody reference rigid)
