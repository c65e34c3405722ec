/// \file
/// \brief Lists of records in TOML files; what the driver knows of TOML is here.
#include "driver/records.hpp"

#include "driver/csv.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tumble::chapters {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& text) {
  return std::ranges::find(list, text) != list.end();
}

std::string place_of(const std::string& file, const toml::node& node) {
  return file + ':' + std::to_string(node.source().begin.line) + ": ";
}

std::string text_of(const toml::node& node) { return node.value<std::string>().value_or(""); }

Record read_record(const toml::table& table, const std::string& file, const RecordForm& form) {
  const toml::node* id = table.get("id");
  Record record;
  record.place =
      place_of(file, table) + form.name + (id != nullptr ? ' ' + text_of(*id) : "") + ": ";
  for (const std::string& key : form.required) record.texts[key] = "";
  for (const std::string& key : form.optional) record.texts[key] = "";

  for (const auto& entry : table) {
    const std::string key(entry.first.str());
    const toml::node& node = entry.second;
    if (contains(form.flags, key)) {
      if (!node.is_boolean())
        throw std::invalid_argument(record.place + key + ": give true or false");
      record.flags[key] = node.value<bool>().value_or(false);
    } else if (record.texts.count(key) == 0) {
      throw std::invalid_argument(record.place + "unknown key '" + key + '\'');
    } else if (!node.is_string() || text_of(node).empty()) {
      throw std::invalid_argument(record.place + key + ": give a text in quotes");
    } else {
      record.texts[key] = text_of(node);
    }
  }
  for (const std::string& key : form.required)
    if (record.texts[key].empty())
      throw std::invalid_argument(record.place + "the key '" + key + "' is missing");
  return record;
}

std::vector<Record> read_root(const toml::table& root, const std::string& file,
                              const RecordForm& form) {
  std::vector<Record> records;
  std::set<std::string> ids;
  for (const auto& entry : root) {
    const std::string key(entry.first.str());
    if (!form.beside.empty() && key == form.beside) continue;
    const toml::array* list = entry.second.as_array();
    if (key != form.name || list == nullptr)
      throw std::invalid_argument(place_of(file, entry.second) + "'" + key +
                                  "': there are only [[" + form.name + "]] tables here");
    for (const toml::node& node : *list) {
      const toml::table* table = node.as_table();
      if (table == nullptr)
        throw std::invalid_argument(place_of(file, node) + "give [[" + form.name + "]] tables");
      records.push_back(read_record(*table, file, form));
      if (!ids.insert(records.back().texts["id"]).second)
        throw std::invalid_argument(records.back().place + "this id stands twice");
    }
  }
  return records;
}

}  // namespace

std::vector<Record> read_records(const std::filesystem::path& path, const RecordForm& form) {
  const std::string text = read_file(path);
  try {
    return read_root(toml::parse(text, path.string()), path.string(), form);
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(path.string() + ':' + std::to_string(error.source().begin.line) +
                                ": not TOML: " + std::string(error.description()));
  }
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace tumble::chapters
