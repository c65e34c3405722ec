/// \file
/// \brief Title and caption of each figure, as the chapter's figures.toml has them.
#include "driver/figure_texts.hpp"

#include "driver/records.hpp"

#include <algorithm>
#include <regex>

namespace tumble::chapters {
namespace {

const RecordForm kFigureForm{"figure", {"id", "section", "title", "caption"}, {"film"}};

std::string in_one_line(const std::string& text) {
  static const std::regex line_break(R"(\s*\n\s*)");
  const std::string line = std::regex_replace(text, line_break, " ");
  const std::size_t first = line.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : line.substr(first, line.find_last_not_of(' ') + 1 - first);
}

std::string without_comments(const std::string& text) {
  static const std::regex comment(R"(\s?<!--[^>]*-->)");
  return std::regex_replace(text, comment, "");
}

}  // namespace

std::vector<FigureText> read_figure_texts(const std::filesystem::path& path) {
  std::vector<FigureText> texts;
  for (const Record& record : read_records(path, kFigureForm)) {
    const auto text = [&](const char* key) { return in_one_line(record.texts.at(key)); };
    texts.push_back({text("id"), text("section"), text("title"), text("caption"), text("film")});
  }
  return texts;
}

std::vector<Figure> with_texts(std::vector<Figure> figures, const std::vector<FigureText>& texts) {
  std::vector<Figure> described;
  std::string message;
  for (const FigureText& text : texts) {
    const auto found = std::ranges::find_if(
        figures, [&](const Figure& figure) { return figure.name == text.name; });
    if (found == figures.end()) {
      message += "\nfigures.toml describes " + text.name + ", which no source registers";
      continue;
    }
    found->section = text.section;
    found->title = text.title;
    found->caption = without_comments(text.caption);
    found->film = without_comments(text.film);
    described.push_back(std::move(*found));
    figures.erase(found);
  }
  for (const Figure& figure : figures)
    message += "\na source registers " + figure.name + ", which figures.toml does not describe";
  if (!message.empty()) throw std::invalid_argument("figures and their texts differ:" + message);
  return described;
}

}  // namespace tumble::chapters
