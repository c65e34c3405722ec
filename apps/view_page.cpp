/// \file
/// \brief Filling in the page of a run.
#include "view_page.hpp"

#include "tumble/base/number_text.hpp"

#include <algorithm>

namespace tumble::app {
namespace {

// Every `from` in a text becomes `to`.
std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t next = std::min(text.find(from, at), text.size());
    out.append(text, at, next - at);
    if (next < text.size()) out.append(to);
    at = next + from.size();
  }
  return out;
}

}  // namespace

std::string view_page(std::string_view title, const std::string& gltf, const Vec3& direction_w) {
  const std::string plain = replaced(replaced(title, "&", "&amp;"), "<", "&lt;");
  std::string view;
  for (int k = 0; k < 3; ++k) view += (k > 0 ? ", " : "") + shortest_text(direction_w[k]);
  std::string page = replaced(replaced(kViewPage, "@TITLE@", plain), "@VIEW@", view);
  // A name within the JSON text could end the element that it stands in. Last: a name may be @VIEW@ too.
  return replaced(page, "@RUN@", replaced(gltf, "<", "\\u003c"));
}

}  // namespace tumble::app
