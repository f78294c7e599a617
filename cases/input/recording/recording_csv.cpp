// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/recording/recording_csv.hpp"

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;
using Buffer = fmt::memory_buffer;

constexpr std::array<const char*, 13> body_columns{
    "x_m",        "y_m",        "z_m",        "qw",           "qx",           "qy",          "qz",
    "vx_m_per_s", "vy_m_per_s", "vz_m_per_s", "wx_rad_per_s", "wy_rad_per_s", "wz_rad_per_s"};

[[noreturn]] void cannot_write(const fs::path& path, const std::error_code& why) {
  throw InputError(fmt::format("{}: cannot be written: {} (free space, or give another folder)", path.string(),
                               why ? why.message() : "input/output error"));
}

std::string escape(std::string_view text, bool is_key) {
  std::string result;
  for (const char c : clean_text(text)) {
    if (c == '\\') {
      result += "\\\\";
    } else if (c == '\n') {
      result += "\\n";
    } else if (c == '\r') {
      result += "\\r";
    } else if (c == ':' && is_key) {
      result += "\\c";
    } else {
      result += c;
    }
  }
  return result;
}

/// A field of a line, in quotes if it must be (RFC 4180).
std::string field(const std::string& given) {
  const std::string text = clean_text(given);
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return result + '"';
}

void put(Buffer& out, double value) { fmt::format_to(std::back_inserter(out), ",{}", value); }

void put(Buffer& out, const Eigen::Vector3d& v) {
  fmt::format_to(std::back_inserter(out), ",{},{},{}", v.x(), v.y(), v.z());
}

void put(Buffer& out, const SampleId& id) {
  fmt::format_to(std::back_inserter(out), ",{},{},{},{}", int(id.hand), int(id.phalanx), int(id.body), int(id.sample));
}

void put_line(Buffer& out, const std::string& key, const std::string& value) {
  fmt::format_to(std::back_inserter(out), "# {}: {}\n", key, escape(value, false));
}

void put_header(Buffer& out, const Recording& recording) {
  put_line(out, "format", "handhold recording 1");
  put_line(out, "engine", recording.engine);
  put_line(out, "scene", recording.scene);
  put_line(out, "outcome", std::string(to_string(recording.outcome)));
  put_line(out, "note", recording.note);
  for (const std::string& name : recording.body_names) put_line(out, "body", name);
  for (const auto& [key, value] : recording.provenance) put_line(out, "provenance." + escape(key, true), value);
}

void put_body(Buffer& out, const BodyState& body) {
  const Eigen::Quaterniond& q = body.X_WO.R;
  put(out, body.X_WO.p);
  fmt::format_to(std::back_inserter(out), ",{},{},{},{}", q.w(), q.x(), q.y(), q.z());
  put(out, body.V_WO.v);
  put(out, body.V_WO.w);
}

Buffer frames_text(const Recording& recording) {
  Buffer out;
  put_header(out, recording);
  fmt::format_to(std::back_inserter(out), "t_s");
  for (const std::string& name : recording.body_names) {
    for (const char* column : body_columns) {
      fmt::format_to(std::back_inserter(out), ",{}", field(name + "." + column));
    }
  }
  fmt::format_to(std::back_inserter(out), ",kinetic_J,potential_J,elastic_J,dissipated_J,hand_work_J\n");
  for (const Frame& frame : recording.frames) {
    fmt::format_to(std::back_inserter(out), "{}", frame.t);
    for (const BodyState& body : frame.bodies) put_body(out, body);
    const Energy& e = frame.energy;
    for (const double joule : {e.kinetic, e.potential, e.elastic, e.dissipated, e.hand_work}) put(out, joule);
    out.push_back('\n');
  }
  return out;
}

Buffer contacts_text(const Recording& recording) {
  Buffer out;
  put_header(out, recording);
  fmt::format_to(
      std::back_inserter(out),
      "frame,t_s,hand,phalanx,body,sample,mode,depth_m,px_m,py_m,pz_m,Cx_m,Cy_m,Cz_m,nx,ny,nz,fx_N,fy_N,fz_N\n");
  for (std::size_t i = 0; i < recording.frames.size(); ++i) {
    for (const ContactState& contact : recording.frames[i].contacts) {
      fmt::format_to(std::back_inserter(out), "{},{}", i, recording.frames[i].t);
      put(out, contact.id);
      fmt::format_to(std::back_inserter(out), ",{},{}", to_string(contact.mode), contact.depth);
      for (const Eigen::Vector3d& v : {contact.p_W, contact.C_W, contact.n_W, contact.f_W}) put(out, v);
      out.push_back('\n');
    }
  }
  return out;
}

Buffer events_text(const Recording& recording) {
  Buffer out;
  put_header(out, recording);
  fmt::format_to(std::back_inserter(out), "t_s,window_s,kind,hand,phalanx,body,sample,{}\n",
                 fmt::join(body_columns, ","));
  for (const Event& event : recording.events) {
    fmt::format_to(std::back_inserter(out), "{},{},{}", event.t, event.window, to_string(event.kind));
    put(out, event.id);
    put_body(out, event.body);
    out.push_back('\n');
  }
  return out;
}

Buffer frame_times_text(const Recording& recording) {
  Buffer out;
  put_header(out, recording);
  fmt::format_to(std::back_inserter(out), "advance,cpu_time_s\n");
  for (std::size_t i = 0; i < recording.frame_time.size(); ++i) {
    fmt::format_to(std::back_inserter(out), "{},{}\n", i, recording.frame_time[i]);
  }
  return out;
}

Buffer ambiguities_text(const Recording& recording) {
  Buffer out;
  put_header(out, recording);
  fmt::format_to(std::back_inserter(out), "t_s,hand,phalanx,body,sample,what\n");
  for (const Ambiguity& ambiguity : recording.ambiguities) {
    fmt::format_to(std::back_inserter(out), "{}", ambiguity.t);
    put(out, ambiguity.id);
    fmt::format_to(std::back_inserter(out), ",{}\n", field(ambiguity.what));
  }
  return out;
}

void check_sizes(const Recording& recording) {
  for (const Frame& frame : recording.frames) {
    if (frame.bodies.size() == recording.body_names.size()) continue;
    throw InputError(fmt::format("recording: {} bodies at t = {} s for {} names: must be equal (name every body)",
                                 frame.bodies.size(), frame.t, recording.body_names.size()));
  }
}

/// The files beside their final names; those that were not renamed are removed.
class Parts {
 public:
  explicit Parts(fs::path folder) : folder_(std::move(folder)) {}
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() {
    std::error_code ignored;
    for (const std::string& name : names_) fs::remove(part(name), ignored);
  }

  void write(const std::string& name, const Buffer& text) {
    names_.push_back(name);
    errno = 0;
    std::ofstream file(part(name), std::ios::binary | std::ios::trunc);
    file.write(text.data(), std::streamsize(text.size()));
    file.close();  // flushes: a full disk shows here at the latest
    if (!file) cannot_write(part(name), {errno, std::generic_category()});
  }

  void rename() {
    for (const std::string& name : names_) {
      std::error_code failed;
      fs::rename(part(name), folder_ / name, failed);
      if (failed) cannot_write(folder_ / name, failed);
    }
    names_.clear();
  }

 private:
  [[nodiscard]] fs::path part(const std::string& name) const { return folder_ / (name + ".part"); }

  fs::path folder_;
  std::vector<std::string> names_;
};

}  // namespace

void write_recording(const Recording& recording, const std::filesystem::path& folder) {
  check_sizes(recording);
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) cannot_write(folder, failed);
  Parts parts(folder);
  parts.write("frames.csv", frames_text(recording));
  parts.write("contacts.csv", contacts_text(recording));
  parts.write("events.csv", events_text(recording));
  parts.write("frame_times.csv", frame_times_text(recording));
  parts.write("ambiguities.csv", ambiguities_text(recording));
  parts.rename();
}

}  // namespace handhold
