// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cases/input/mesh/binary_bytes.hpp"
#include "cases/input/mesh/mesh_formats.hpp"
#include "cases/input/mesh/text_lines.hpp"
#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<Type> type_of(std::string_view name) {
  static const std::pair<std::string_view, Type> known[] = {
      {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
      {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
      {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
      {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};
  for (const auto& [word, type] : known) {
    if (word == name) return type;
  }
  return std::nullopt;
}

struct Property {
  std::string name{};
  Type type{};
  std::optional<Type> count{};  // of a list
};

struct Element {
  std::string name{};
  std::size_t count{};
  std::vector<Property> properties{};
};

// Where the values come from; both kinds throw at the first value that is missing or none.
class Values {
 public:
  virtual ~Values() = default;
  virtual void begin_element(const Element& element) = 0;
  virtual double real(Type type) = 0;
  virtual long whole(Type type) = 0;
  virtual void skip(Type type) = 0;
  virtual void end_element() = 0;
  /// Bytes that no element claims.
  [[nodiscard]] virtual std::size_t rest() const = 0;
  [[noreturn]] virtual void fail(const std::string& rule, const std::string& advice) const = 0;
};

class TextValues : public Values {
 public:
  explicit TextValues(TextLines& lines) : lines_(lines) {}
  void begin_element(const Element& element) override {
    const std::string what = "the " + (element.name == "vertex" ? std::string("vertices") : element.name + "s");
    if (!element.properties.empty()) first_ = lines_.first_word(what.c_str());
  }
  double real(Type) override { return lines_.real(take()); }
  long whole(Type) override { return lines_.whole(take()); }
  void skip(Type) override {
    if (take().empty()) fail("the line has too few values", "complete it");
  }
  void end_element() override {
    if (!take().empty()) fail("the line has more values than the header names", "correct the header or the line");
  }
  [[nodiscard]] std::size_t rest() const override {
    return lines_.rest().find_first_not_of(" \t\r\n") == std::string_view::npos ? 0 : lines_.rest().size();
  }
  [[noreturn]] void fail(const std::string& rule, const std::string& advice) const override {
    lines_.fail(rule, advice);
  }

 private:
  std::string_view take() { return first_.empty() ? lines_.word() : std::exchange(first_, {}); }

  TextLines& lines_;
  std::string_view first_;
};

class BinaryValues : public Values {
 public:
  BinaryValues(std::string_view bytes, bool swapped, const std::string& file)
      : bytes_(bytes), swapped_(swapped), file_(file) {}
  void begin_element(const Element& element) override { element_ = &element, ++number_; }
  double real(Type type) override {
    if (type == Type::float32) return take<float>();
    return type == Type::float64 ? take<double>() : static_cast<double>(whole(type));
  }
  long whole(Type type) override {
    switch (type) {
      case Type::int8:
        return take<std::int8_t>();
      case Type::uint8:
        return take<std::uint8_t>();
      case Type::int16:
        return take<std::int16_t>();
      case Type::uint16:
        return take<std::uint16_t>();
      case Type::int32:
        return take<std::int32_t>();
      case Type::uint32:
        return take<std::uint32_t>();
      default:
        fail("counts or indices that are no whole numbers", "export it again");
    }
  }
  void skip(Type type) override { (void)real(type); }
  void end_element() override {}
  [[nodiscard]] std::size_t rest() const override { return bytes_.size() - at_; }
  [[noreturn]] void fail(const std::string& rule, const std::string& advice) const override {
    throw InputError(
        fmt::format("{}: element {} ('{}'): {} ({})", file_, number_, printable(element_->name), rule, advice));
  }

 private:
  template <class T>
  T take() {
    if (bytes_.size() - at_ < sizeof(T)) fail("the file ends too early", "is it truncated?");
    at_ += sizeof(T);
    return number_at<T>(bytes_, at_ - sizeof(T), swapped_);
  }

  std::string_view bytes_;
  bool swapped_;
  const std::string& file_;
  const Element* element_ = nullptr;
  std::size_t at_ = 0, number_ = 0;
};

bool is_corners(const Property& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index");
}

class PlyParser {
 public:
  PlyParser(std::string bytes, const std::string& file)
      : bytes_(std::move(bytes)), file_(file), lines_(bytes_, file, {}) {}

  PolygonSoup run() && {
    read_header();
    const std::unique_ptr<Values> values = make_values();
    for (const Element& element : elements_) {
      for (std::size_t i = 0; i < element.count; ++i) read(element, *values);
    }
    if (const std::size_t rest = values->rest(); rest > 0)
      soup_.warnings.push_back(fmt::format("{} bytes after its last element were passed over", rest));
    return std::move(soup_);
  }

 private:
  void read_header() {
    if (!lines_.next() || lower(lines_.word()) != "ply")
      throw InputError(file_ + ": does not begin with 'ply' (is it another format?)");
    for (std::string key; key != "end_header";) {
      if (!lines_.next()) lines_.fail("no 'end_header'", "is the file truncated?");
      key = lower(lines_.word());
      if (key == "format") format_ = lower(lines_.word());
      if (key == "element") add_element();
      if (key == "property") add_property();
      const auto known = {"format", "comment", "obj_info", "element", "property", "end_header"};
      if (!key.empty() && std::find(known.begin(), known.end(), key) == known.end())
        lines_.fail(fmt::format("a PLY header has no '{}'", printable(key)), "is the file damaged?");
    }
    check_elements();
  }

  void add_element() {
    Element element;
    element.name = lower(lines_.word());
    const long count = lines_.whole(lines_.word());
    // Every element takes a byte at least; one without properties takes none, but the time to count it.
    if (count < 0 || count > static_cast<long>(bytes_.size()) - announced_)
      lines_.fail(fmt::format("announces {} elements, more than the file can hold", count), "is it truncated?");
    announced_ += count;
    element.count = static_cast<std::size_t>(count);
    elements_.push_back(std::move(element));
  }

  void add_property() {
    if (elements_.empty()) lines_.fail("a property before the first element", "is the file damaged?");
    Property property;
    std::string word = lower(lines_.word());
    if (word == "list") property.count = known_type(lower(lines_.word())), word = lower(lines_.word());
    property.type = known_type(word);
    property.name = lower(lines_.word());
    elements_.back().properties.push_back(property);
  }

  Type known_type(std::string_view name) const {
    const std::optional<Type> type = type_of(name);
    if (!type) lines_.fail(fmt::format("PLY has no type '{}'", printable(name)), "is the file damaged?");
    return *type;
  }

  void check_elements() {
    std::size_t faces = 0;
    for (const Element& element : elements_) {
      const auto has = [&element](const char* name) {
        return std::count_if(element.properties.begin(), element.properties.end(),
                             [name](const Property& p) { return p.name == name && !p.count; }) == 1;
      };
      if (element.name == "vertex") {
        vertices_ += static_cast<long>(element.count);
        if (!has("x") || !has("y") || !has("z")) lines_.fail("its vertices have no x, y and z", "export it again");
      }
      if (element.name == "face") {
        faces += element.count;
        if (std::none_of(element.properties.begin(), element.properties.end(), is_corners))
          lines_.fail("its faces have no list vertex_indices", "export it again");
      }
      if (element.name == "tristrips") lines_.fail("it holds triangle strips", "export it with faces");
    }
    if (vertices_ < 4 || faces < 4) lines_.fail("needs at least 4 vertices and 4 faces", "give a closed mesh");
  }

  std::unique_ptr<Values> make_values() {
    if (format_ == "ascii") return std::make_unique<TextValues>(lines_);
    const bool big = format_ == "binary_big_endian";
    if (!big && format_ != "binary_little_endian")
      lines_.fail(fmt::format("PLY has no format '{}'", printable(format_)), "is the file damaged?");
    return std::make_unique<BinaryValues>(lines_.rest(), big, file_);
  }

  void read(const Element& element, Values& values) {
    values.begin_element(element);
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (const Property& property : element.properties) {
      if (property.count) {
        read_list(element, property, values);
      } else if (element.name == "vertex" && property.name.size() == 1 && property.name >= "x" &&
                 property.name <= "z") {
        point[property.name[0] - 'x'] = values.real(property.type);
      } else {
        values.skip(property.type);
      }
    }
    values.end_element();
    if (element.name != "vertex") return;
    if (!point.allFinite()) values.fail("a coordinate is not finite", "correct the file");
    soup_.points.push_back(point);
  }

  void read_list(const Element& element, const Property& property, Values& values) {
    const long count = values.whole(*property.count);
    const bool corners = element.name == "face" && is_corners(property);
    if (count < 0) values.fail(fmt::format("a list of {} values", count), "is the file damaged?");
    if (corners && count == 0) values.fail("a face has no corners", "is the file damaged?");
    for (long i = 0; i < count; ++i) {
      if (!corners) {
        values.skip(property.type);
        continue;
      }
      const long index = values.whole(property.type);
      if (index < 0 || index >= vertices_)
        values.fail(fmt::format("face names vertex {}, there are {}", index, vertices_), "indices start at 0");
      if (count > 2) soup_.corners.push_back(static_cast<int>(index));
    }
    if (!corners) return;
    if (count > 2) soup_.ends.push_back(soup_.corners.size());
    soup_.dropped += count < 3;
  }

  std::string bytes_;
  const std::string& file_;
  TextLines lines_;
  std::string format_;
  std::vector<Element> elements_;
  long announced_ = 0, vertices_ = 0;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup parse_ply(std::string_view bytes, const std::string& file) {
  return PlyParser(plain_text(std::string(bytes)), file).run();
}

}  // namespace handhold
