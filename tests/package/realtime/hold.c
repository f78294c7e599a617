/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A cube between two fingertips: they close, lift it by 10 cm, and hold it for a second. Usage: hold_c [CUBE.hhvox] */
#include <handhold/realtime/handhold.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cube.h"

enum { INDEX_TIP = 5, THUMB_TIP = 2 };

static const double frame = 1.0 / 90;                                     /* [s] */
static const double closed = 0.2, lift = 0.4, up = 0.9, end = 1.9;        /* [s] */
static const double height = 0.1, mass = 0.1, gap = 0.005, depth = 0.003; /* [m], [kg], [m], [m] */

/* From 0 to 1 between the two times, with speed and acceleration 0 at both (minimum jerk). */
static double ease(double t, double from, double to) {
  const double s = fmin(1, fmax(0, (t - from) / (to - from)));
  return s * s * s * (10 + s * (6 * s - 15));
}

/* A fingertip on the side x = side * CUBE_HALF, along the x axis. */
static void place_tip(const hh_hand* hand, int phalanx, double side, double t, hh_pose* pose) {
  const double distance = gap - (gap + depth) * ease(t, 0, closed); /* of the skin from the face */
  pose->q[0] = sqrt(0.5);
  pose->q[2] = -side * sqrt(0.5); /* its z axis, towards the tip, into the cube */
  pose->p[0] = side * (CUBE_HALF + distance + hand->radius[phalanx] + hand->half_length[phalanx]);
  pose->p[2] = height * ease(t, lift, up);
}

static void place(const hh_hand* hand, double t, hh_hand_frame* hands) {
  int i;
  memset(hands, 0, sizeof *hands);
  hands->present = 1;
  for (i = 0; i < HH_PHALANGES; ++i) { /* those that take no part: far away */
    hands->phalanx[i].q[0] = 1;
    hands->phalanx[i].p[2] = 5;
  }
  memset(&hands->phalanx[INDEX_TIP], 0, sizeof(hh_pose));
  memset(&hands->phalanx[THUMB_TIP], 0, sizeof(hh_pose));
  place_tip(hand, INDEX_TIP, 1, t, &hands->phalanx[INDEX_TIP]);
  place_tip(hand, THUMB_TIP, -1, t, &hands->phalanx[THUMB_TIP]);
}

static int make_world(const char* file, const hh_hand* hand, hh_world** world, hh_error* error) {
  hh_field* field = NULL;
  hh_body_def cube = hh_body_def_default();
  hh_world_def def = hh_world_def_default();
  int code = file ? hh_field_load(file, &field, error) : cube_field(&field, error);
  if (code == HH_OK) code = hh_field_solid(field, mass, cube.center_of_mass, cube.inertia, error);
  cube.field = field;
  cube.mass = mass;
  cube.held_until = 0.3; /* until the fingers have it */
  def.bodies = &cube;
  def.body_count = 1;
  def.hands = hand;
  def.hand_count = 1;
  if (code == HH_OK) code = hh_world_create(&def, world, error);
  hh_field_destroy(field); /* the world keeps what it needs */
  return code;
}

int main(int argc, char** argv) {
  hh_error error;
  hh_hand hand;
  hh_hand_frame hands;
  hh_world* world = NULL;
  hh_body cube;
  hh_touch touches[64];
  hh_event events[256];
  int i, k, count = 0, code, slips = 0;
  double sag;
  hh_hand_mean(1, &hand);
  code = make_world(argc > 1 ? argv[1] : NULL, &hand, &world, &error);
  for (k = 0; code == HH_OK && k * frame <= end; ++k) { /* the first step places the hand at t = 0 */
    place(&hand, k * frame, &hands);
    code = hh_world_step(world, frame, &hands, &error);
    count = hh_world_events(world, events, 256);
    for (i = 0; i < count && i < 256; ++i) slips += events[i].kind == HH_BREAKAWAY;
  }
  if (code == HH_OK) code = hh_world_body(world, 0, &cube, &error);
  if (code != HH_OK) {
    fprintf(stderr, "hold: %s\n", error.message);
    return code;
  }
  count = hh_world_touches(world, touches, 64);
  hh_world_destroy(world);
  /* 16 samples carry the weight as springs of 100 N/m; what swung has decayed by exp(-40) in the second. */
  sag = mass * 9.81 / (16 * 100);
  printf("%s, %d samples touch, %d slipped; %.3f mm above the start, %.6f mm by theory\n", hh_version(), count, slips,
         1e3 * cube.pose.p[2], 1e3 * (height - sag));
  return count == 16 && slips == 0 && fabs(cube.pose.p[2] - (height - sag)) < 1e-6 ? 0 : 1;
}
