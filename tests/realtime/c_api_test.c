/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program in C that uses the C interface alone: a cube of its own voxels, pushed by one fingertip. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "realtime/handhold.h"

static int failures = 0;

#define CHECK(condition)                                              \
  do {                                                                \
    if (!(condition)) {                                               \
      fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                                     \
    }                                                                 \
  } while (0)

#define NEAR(value, truth, tolerance) CHECK(fabs((value) - (truth)) <= (tolerance))

enum { NODES = 32 };
static const double half = 0.03; /* of the cube [m] */
static const double spacing = 0.0025;

static double min3(double a, double b, double c) { return fmin(a, fmin(b, c)); }

/* Signed distance to the cube: exact inside and next to a face; enough for a finger on a face. */
static double distance_to_cube(double x, double y, double z) {
  const double dx = fabs(x) - half, dy = fabs(y) - half, dz = fabs(z) - half;
  const double ox = fmax(dx, 0), oy = fmax(dy, 0), oz = fmax(dz, 0);
  const double inside = -min3(-dx, -dy, -dz);
  return inside < 0 ? inside : sqrt(ox * ox + oy * oy + oz * oz);
}

static hh_field* make_cube(hh_error* error) {
  static double vertices[24];
  static const int triangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  static float distances[NODES * NODES * NODES];
  static unsigned char occupied[NODES * NODES * NODES];
  static const unsigned start[2] = {0, 12};
  static unsigned all[12];
  const double origin = -spacing * (NODES - 1) / 2;
  hh_field_data data;
  hh_field* field = NULL;
  int i, j, k, axis;
  for (i = 0; i < 8; ++i) {
    for (axis = 0; axis < 3; ++axis) vertices[3 * i + axis] = (i >> axis & 1) ? half : -half;
  }
  for (i = 0; i < 12; ++i) all[i] = (unsigned)i;
  for (k = 0; k < NODES; ++k) {
    for (j = 0; j < NODES; ++j) {
      for (i = 0; i < NODES; ++i) {
        const double d = distance_to_cube(origin + i * spacing, origin + j * spacing, origin + k * spacing);
        const int at = (k * NODES + j) * NODES + i;
        distances[at] = (float)fmax(-0.0075, fmin(0.0075, d));
        occupied[at] = d < 0;
      }
    }
  }
  memset(&data, 0, sizeof data);
  data.vertices = vertices;
  data.vertex_count = 8;
  data.triangles = triangles;
  data.triangle_count = 12;
  for (axis = 0; axis < 3; ++axis) {
    data.grid_origin[axis] = origin;
    data.grid_size[axis] = NODES;
    data.cell_origin[axis] = -0.035;
    data.cell_count[axis] = 1;
  }
  data.grid_spacing = spacing;
  data.band = 0.0075;
  data.distances = distances;
  data.occupied = occupied;
  data.cell_size = 0.07;
  data.cell_start = start;
  data.cell_triangles = all;
  data.cell_triangle_count = 12;
  CHECK(hh_field_create(&data, &field, error) == HH_OK);
  data.grid_spacing = -1;
  {
    hh_field* wrong = NULL;
    CHECK(hh_field_create(&data, &wrong, error) == HH_WRONG_INPUT);
    CHECK(wrong == NULL && error->code == HH_WRONG_INPUT && strlen(error->message) > 10);
    CHECK(strchr(error->message, '\n') == NULL);
  }
  return field;
}

/* All phalanges far away but the index fingertip, whose capsule stands on the face z = half, `depth` deep. */
static void place(hh_hand_frame* frame, const hh_hand* hand, double x, double depth) {
  int i;
  memset(frame, 0, sizeof *frame);
  frame->present = 1;
  for (i = 0; i < HH_PHALANGES; ++i) {
    frame->phalanx[i].q[0] = 1;
    frame->phalanx[i].p[2] = 5;
  }
  frame->phalanx[5].p[0] = x;
  frame->phalanx[5].p[2] = half - depth + hand->radius[5] + hand->half_length[5];
}

static void test_push(hh_contact* contact, const hh_hand* hand, hh_error* error) {
  hh_hand_frame frame;
  hh_body body;
  hh_wrench wrench, moved;
  hh_sample samples[64];
  double by_pose[36], by_velocity[36];
  int i, count;
  memset(&body, 0, sizeof body);
  body.pose.q[0] = 1;
  place(&frame, hand, 0, -0.05);
  CHECK(hh_contact_step(contact, 1.0 / 90, &frame, &body, &wrench, error) == HH_OK);
  CHECK(hh_contact_samples(contact, samples, 64) == 0);
  CHECK(wrench.force[2] == 0);
  place(&frame, hand, 0, 0); /* touches: the patch is made here */
  CHECK(hh_contact_step(contact, 1.0 / 90, &frame, &body, &wrench, error) == HH_OK);
  place(&frame, hand, 0, 0.002);
  CHECK(hh_contact_step(contact, 1.0 / 90, &frame, &body, &wrench, error) == HH_OK);
  /* Eight samples of 100 N/m, 2 mm deep; the seed is exact to the 1e-6 of the capsule's length that nearest() searches.
   */
  NEAR(wrench.force[2], -1.6, 1e-6);
  NEAR(wrench.force[0], 0, 1e-6);
  count = hh_contact_samples(contact, samples, 64);
  CHECK(count == 8);
  for (i = 0; i < count && i < 64; ++i) {
    CHECK(samples[i].phalanx == 5 && samples[i].mode == HH_STICK && samples[i].normal[2] == 1);
    NEAR(samples[i].force[2], -0.2, 1e-6);
  }
  /* The slopes against a difference of wrenches: the law is linear while it sticks. */
  CHECK(hh_contact_slopes(contact, &body, by_pose, by_velocity, error) == HH_OK);
  body.pose.p[2] = 1e-4;
  CHECK(hh_contact_wrench_at(contact, &body, &moved, error) == HH_OK);
  NEAR(moved.force[2] - wrench.force[2], 1e-4 * by_pose[6 * 2 + 2], 1e-12);
  NEAR(by_pose[6 * 2 + 2], -800, 1e-9);
  NEAR(by_velocity[0], 0, 0);
  body.pose.p[2] = 0;
  place(&frame, hand, 0.0005, 0.002); /* drags along: 0.5 mm of 1 mm that 0.5 N allows */
  CHECK(hh_contact_step(contact, 1.0 / 90, &frame, &body, &wrench, error) == HH_OK);
  NEAR(wrench.force[0], 0.4, 1e-6);
  frame.present = 0;
  CHECK(hh_contact_step(contact, 1.0 / 90, &frame, &body, &wrench, error) == HH_OK);
  CHECK(hh_contact_samples(contact, samples, 64) == 0);
  body.pose.q[0] = 2;
  CHECK(hh_contact_step(contact, 1.0 / 90, &frame, &body, &wrench, error) == HH_WRONG_INPUT);
}

/* What a world refuses, with a sentence, and how it is while nothing touches. */
static void test_world(const hh_field* field, const hh_hand* hand, hh_error* error) {
  hh_world_def def = hh_world_def_default(), zero;
  hh_body_def cube = hh_body_def_default(), wrong;
  hh_hand_frame frame;
  hh_world* world = NULL;
  hh_body state;
  hh_energy energy;
  int k;
  cube.field = field;
  cube.mass = 0.2;
  CHECK(hh_field_solid(field, cube.mass, cube.center_of_mass, cube.inertia, error) == HH_OK);
  NEAR(cube.inertia[0], 0.2 * 4 * half * half / 6, 1e-15); /* m a^2 / 6 */
  NEAR(cube.inertia[1], 0, 1e-18);
  cube.start.angular_velocity[2] = 1;
  def.bodies = &cube;
  def.body_count = 1;
  def.hands = hand;
  def.hand_count = 1;
  memset(&zero, 0, sizeof zero);
  CHECK(hh_world_create(&zero, &world, error) == HH_WRONG_INPUT && world == NULL);
  CHECK(strstr(error->message, "hh_world_def_default") != NULL);
  CHECK(hh_world_create(NULL, &world, error) == HH_WRONG_INPUT);
#define REFUSED(member, value)                                                              \
  wrong = cube;                                                                             \
  wrong.member = value;                                                                     \
  def.bodies = &wrong;                                                                      \
  CHECK(hh_world_create(&def, &world, error) == HH_WRONG_INPUT && world == NULL);           \
  CHECK(strstr(error->message, "body 0") == error->message && strchr(error->message, '(')); \
  def.bodies = &cube
  REFUSED(cookie, 0);
  REFUSED(field, NULL);
  REFUSED(mobility, 3);
  REFUSED(mass, -1);
  REFUSED(mu_dynamic, 2);
  REFUSED(start.pose.q[0], 2);
  REFUSED(touches_bodies, 1); /* its field has no samples */
  def.substeps = 0;
  CHECK(hh_world_create(&def, &world, error) == HH_WRONG_INPUT);
  def.substeps = 1;
  def.body_count = 0;
  CHECK(hh_world_create(&def, &world, error) == HH_WRONG_INPUT);
  def.body_count = 1;
  CHECK(hh_world_create(&def, &world, error) == HH_OK);
  if (!world) return;
  place(&frame, hand, 0, -1);
  CHECK(hh_world_step(world, 0.01, NULL, error) == HH_WRONG_INPUT);
  CHECK(hh_world_step(world, NAN, &frame, error) == HH_WRONG_INPUT);
  frame.phalanx[3].q[0] = 2;
  CHECK(hh_world_step(world, 0.01, &frame, error) == HH_WRONG_INPUT);
  frame.phalanx[3].q[0] = 1;
  for (k = 0; k <= 10; ++k) CHECK(hh_world_step(world, 0.01, &frame, error) == HH_OK);
  NEAR(hh_world_time(world), 0.1, 1e-12);
  CHECK(hh_world_body(world, 1, &state, error) == HH_WRONG_INPUT);
  CHECK(hh_world_body(world, 0, &state, error) == HH_OK);
  NEAR(state.velocity[2], -0.981, 1e-12);
  NEAR(state.pose.p[2], -9.81 * 0.01 * 0.01 * 55, 1e-12); /* implicit Euler: g h^2 (1 + 2 + ... + 10) */
  NEAR(2 * atan2(state.pose.q[3], state.pose.q[0]), 0.1, 1e-12);
  CHECK(hh_world_touches(world, NULL, 0) == 0 && hh_world_events(world, NULL, 0) == 0);
  CHECK(hh_world_touches(NULL, NULL, 0) == -1 && hh_world_events(NULL, NULL, 0) == -1);
  CHECK(hh_world_energy(world, &energy, error) == HH_OK);
  NEAR(energy.kinetic, 0.5 * 0.2 * 0.981 * 0.981 + 0.5 * cube.inertia[0], 1e-12);
  CHECK(hh_world_unconverged(world) == 0 && hh_world_unconverged(NULL) == -1);
  hh_world_destroy(world);
  hh_world_destroy(NULL);
}

static void test_files(hh_error* error) {
  hh_field* field = NULL;
  CHECK(hh_field_load("there/is/none.hhvox", &field, error) == HH_WRONG_INPUT && field == NULL);
  CHECK(strstr(error->message, "none.hhvox: ") != NULL);
  CHECK(hh_field_load(NULL, &field, error) == HH_WRONG_INPUT);
  CHECK(hh_field_from_bytes("HHVOX", 5, &field, error) == HH_WRONG_INPUT && field == NULL);
  CHECK(hh_field_from_bytes(NULL, 5, &field, error) == HH_WRONG_INPUT);
}

int main(void) {
  hh_error error;
  hh_options options;
  hh_hand hand;
  hh_object object = {{0, 0, 0}, 0.5, 0.4};
  hh_contact* contact = NULL;
  hh_field* field;
  double stiffness = 0;
  memset(&error, 0, sizeof error);
  CHECK(strcmp(hh_version(), HANDHOLD_VERSION) == 0);
  field = make_cube(&error);
  hh_hand_mean(1, &hand);
  CHECK(hh_options_init(HH_PAPER, &options, &error) == HH_OK);
  CHECK(hh_options_init(7, &options, &error) == HH_WRONG_INPUT);
  CHECK(hh_contact_create(field, &object, &hand, 1, &options, &contact, &error) == HH_OK);
  test_world(field, &hand, &error);
  test_files(&error);
  hh_field_destroy(field); /* the contact keeps what it needs */
  if (contact) test_push(contact, &hand, &error);
  options.stiffness = -1;
  CHECK(hh_contact_set_options(contact, &options, &error) == HH_WRONG_INPUT);
  CHECK(strstr(error.message, "stiffness") != NULL);
  CHECK(hh_options_init(HH_COULOMB, &options, &error) == HH_OK);
  CHECK(hh_contact_set_options(contact, &options, &error) == HH_OK);
  if (contact) test_push(contact, &hand, NULL); /* the same forces while it sticks; errors need no place to go */
  hh_contact_destroy(contact);
  CHECK(hh_contact_create(NULL, &object, &hand, 1, &options, &contact, &error) == HH_WRONG_INPUT);
  CHECK(contact == NULL);
  /* s m g / (mu n d) = 3 * 0.2 * 9.81 / (0.5 * 16 * 0.003) */
  CHECK(hh_auto_stiffness(0.2, 0, 0.5, 16, 0.003, 3, &stiffness, &error) == HH_OK);
  NEAR(stiffness, 245.25, 1e-10);
  hh_contact_destroy(NULL);
  if (failures == 0) puts("ok");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
