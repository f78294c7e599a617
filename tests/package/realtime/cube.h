/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The voxels of a cube as arrays: what a program does that has its own voxelizer. */
#ifndef CUBE_H
#define CUBE_H

#include <handhold/realtime/handhold.h>
#include <math.h>
#include <string.h>

#define CUBE_HALF 0.025 /* [m] */
enum { CUBE_NODES = 36 };

/* Signed distance, < 0 inside. */
static float cube_distance(double x, double y, double z) {
  const double dx = fabs(x) - CUBE_HALF, dy = fabs(y) - CUBE_HALF, dz = fabs(z) - CUBE_HALF;
  const double ox = fmax(dx, 0), oy = fmax(dy, 0), oz = fmax(dz, 0);
  const double inside = fmin(0, fmax(dx, fmax(dy, dz)));
  return (float)(sqrt(ox * ox + oy * oy + oz * oz) + inside);
}

static int cube_field(hh_field** field, hh_error* error) {
  static const int triangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  static const unsigned cell_start[2] = {0, 12}, cell_triangles[12] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  static float distances[CUBE_NODES * CUBE_NODES * CUBE_NODES];
  static unsigned char occupied[CUBE_NODES * CUBE_NODES * CUBE_NODES];
  const double spacing = 0.002, band = 0.008, origin = -spacing * (CUBE_NODES - 1) / 2;
  double vertices[24];
  hh_field_data data;
  int i, j, k, axis;
  for (i = 0; i < 24; ++i) vertices[i] = (i / 3 >> i % 3 & 1) ? CUBE_HALF : -CUBE_HALF;
  for (k = 0; k < CUBE_NODES; ++k) {
    for (j = 0; j < CUBE_NODES; ++j) {
      for (i = 0; i < CUBE_NODES; ++i) {
        const int node = (k * CUBE_NODES + j) * CUBE_NODES + i;
        const float distance = cube_distance(origin + i * spacing, origin + j * spacing, origin + k * spacing);
        distances[node] = (float)fmax(-band, fmin(band, distance));
        occupied[node] = distance < 0;
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
    data.grid_size[axis] = CUBE_NODES;
    data.cell_origin[axis] = -1.1 * CUBE_HALF; /* one cell holds all triangles */
    data.cell_count[axis] = 1;
  }
  data.grid_spacing = spacing;
  data.band = band;
  data.distances = distances;
  data.occupied = occupied;
  data.cell_size = 2.2 * CUBE_HALF;
  data.cell_start = cell_start;
  data.cell_triangles = cell_triangles;
  data.cell_triangle_count = 12;
  return hh_field_create(&data, field, error);
}

#endif
