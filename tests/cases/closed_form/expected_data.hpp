// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::testing {

// Expected values of the catalogue's parameter sets, copied as figures with their id and set number from the project's
// list expected.json. They were computed by another program (event-driven DOP853, rtol 1e-12) than this one.
struct C01 {
  double th, mu_s, mu_d, D;
  bool hold;
  double a, t, v;
};
inline constexpr C01 c01[] = {{0.5, 0.5, 0.4, 0.1, false, 1.2595305608494087, 0.3984837750605791, 0.5019024926914407},
                              {0.46, 0.5, 0.4, 0.1, true, 0, 0, 0}};

struct C03 {
  double v0, mu_d, m, t, D, heat;
};
inline constexpr C03 c03[] = {{0.8, 0.4, 0.2, 0.2038735983690112, 0.0815494393476045, 0.06400000000000002}};

struct D01 {
  int n;
  double N, m, mu_s, mu_d, a, T;
  bool hold;
  double slip;
};
inline constexpr D01 d01[] = {{2, 2.5, 0.2, 0.5, 0.4, 1, 0.1, true, 0},
                              {2, 2.0, 0.2, 0.5, 0.4, 1, 0.1, false, 0.014050000000000005},
                              {3, 1.4, 0.2, 0.5, 0.5, 1, 0.1, false, 0.0015500000000000114},
                              {2, 1.962, 0.2, 0.5, 0.5, 0, 0.1, true, 0}};

struct D02 {
  double m, N0, r, mu_s, mu_d, t_s, t_open, z_open, v_open, z_after;
};
inline constexpr D02 d02[] = {
    {0.2, 4, 2, 0.5, 0.4, 1.019, 2.0, 2.2028443290000004, 5.774166000000001, 2.8293109290000005},
    {0.2, 4, 0.5, 0.5, 0.5, 4.076, 8.0, 25.175363760000007, 19.247220000000002, 27.149135760000007},
    {0.05, 1.5, 10, 0.8, 0.4, 0.11934375, 0.15, 0.003073164521484376, 0.22555335937500004, 0.07467850045898439}};

struct D13 {
  double A, w, t1, t2, vrel;
};
inline constexpr D13 d13[] = {{0.05, 18, 0.03613687716748872, 0.25627390384151527, -1.3539561652251901},
                              {0.02, 40, 0.0077894883888352025, 0.16395207996480715, -1.5404369343722344}};

struct F01 {
  double I, N, mu, a, w0;
  double t[3], angle[3];  // ring, disc, Hertz
};
inline constexpr F01 f01[] = {
    {1e-4, 2, 0.5, 0.004, 20, {0.25, 0.375, 0.4244131815783876}, {2.5, 3.75, 4.244131815783875}}};

}  // namespace handhold::testing
