// SPDX-License-Identifier: Apache-2.0
// Logs hands and objects of a C++ application for `handhold judge-log` (docs/judge-log.md). Unreal Engine as it stands:
//
//   HandholdLog log(stream, R"({"cube": {"shape": "cube.obj", "mass": 0.1, "friction": 0.46}})");
//   log.begin_frame(FPlatformTime::Seconds());
//   FXRMotionControllerData hand;
//   GEngine->XRSystem->GetMotionControllerData(World, EControllerHand::Right, hand);
//   if (hand.bValid) log.hand("right", hand.HandKeyPositions, hand.HandKeyRadii);
//   log.object("cube", cube->GetActorLocation(), cube->GetActorQuat());
//   log.end_frame();
#pragma once

#include <ostream>
#include <string_view>

/// Unreal's coordinates (cm, z up, left-handed) are written right-handed: y changes its sign, in a shape's own
/// coordinates as well, as Unreal's importers of meshes do it.
class HandholdLog {
 public:
  /// `objects`: what judge-log must know of each, as JSON; `drawn_hands`: the joints are those drawn, not those
  /// tracked.
  HandholdLog(std::ostream& out, std::string_view objects, bool drawn_hands = false) : out_(out) {
    out_.precision(9);
    out_ << R"({"format": "openxr", "unit": "cm", "up": "z", "drawn_hands": )" << (drawn_hands ? "true" : "false")
         << R"(, "objects": )" << objects << "}\n";
  }

  void begin_frame(double seconds) {
    out_ << R"({"t": )" << seconds;
    part_ = Part::none;
  }

  /// 26 joints in OpenXR's order: positions with members X, Y and Z [cm], and radii [cm]. Hands come before objects.
  template <class Positions, class Radii>
  void hand(std::string_view side, const Positions& positions, const Radii& radii) {
    open(Part::hands, R"("hands": {)");
    out_ << '"' << side << R"(": {"joints": [)";
    for (int i = 0; i < 26; ++i) {
      out_ << (i > 0 ? ", " : "") << R"({"position": )";
      write_position(positions[i]);
      out_ << R"(, "radius": )" << radii[i] << '}';
    }
    out_ << "]}";
  }

  /// Position with members X, Y and Z [cm], unit quaternion with X, Y, Z and W.
  template <class Position, class Quaternion>
  void object(std::string_view name, const Position& p, const Quaternion& q) {
    open(Part::objects, R"("objects": {)");
    out_ << '"' << name << R"(": {"position": )";
    write_position(p);
    out_ << R"(, "orientation": [)" << -q.X << ", " << q.Y << ", " << -q.Z << ", " << q.W << "]}";
  }

  void end_frame() { out_ << (part_ == Part::none ? "}\n" : "}}\n"); }

 private:
  enum class Part { none, hands, objects };

  void open(Part part, std::string_view head) {
    if (part_ == part) {
      out_ << ", ";
      return;
    }
    out_ << (part_ == Part::none ? ", " : "}, ") << head;
    part_ = part;
  }

  template <class Position>
  void write_position(const Position& p) {
    out_ << '[' << p.X << ", " << -p.Y << ", " << p.Z << ']';
  }

  std::ostream& out_;
  Part part_{Part::none};
};
