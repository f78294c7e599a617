#pragma once

#include <string>
#include <vector>

namespace handhold::reports {

/// What a curve stands for; decides its colour and its dashes (page_style.cpp), so that no curve is told by colour
/// alone.
enum class Role { truth, reference, realtime, guide };

struct Series {
  std::string label{};
  Role role{Role::truth};
  std::vector<double> x{}, y{};  ///< same length; a value that is not finite breaks the line
  bool markers{false};           ///< a mark at every point
};

/// One pair of axes.
struct Panel {
  std::string y_label{};  ///< with its unit, e.g. "slip [mm]"
  std::string remark{};   ///< stands at the right end of the label's line, e.g. "largest 3.2 µm"
  double height{200};     ///< of the axes [px of the view box]
  std::vector<Series> series{};
};

/// Panels one below the other over one x axis.
struct Figure {
  std::string id{};           ///< unique in the page
  std::string title{};        ///< read out in place of the picture
  std::string description{};  ///< what is to be seen, in a sentence
  std::string x_label{};      ///< with its unit
  bool logarithmic{false};    ///< both axes; points that are not positive are left out
  std::vector<Panel> panels{};
};

/// The figure as one <svg> element for a page with the style of page_style.hpp. No data: axes with the words "no data".
[[nodiscard]] std::string svg(const Figure& figure);

/// A short piece of line in the style of a role, for legends.
[[nodiscard]] std::string svg_swatch(Role role, bool marker);

}  // namespace handhold::reports
