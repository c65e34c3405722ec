/// \file
/// \brief Lists of records in TOML files: claims, errata.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tumble::chapters {

// Which keys the records of a file have.
struct RecordForm {
  std::string name;                        // of the tables, for example "claim" for [[claim]]
  std::vector<std::string> required;       // texts that each record must have
  std::vector<std::string> optional = {};  // texts that it may have
  std::vector<std::string> flags = {};     // keys with true or false that it may have
  std::string beside = {};                 // another kind of table that the file may have
};

// One table of such a file.
struct Record {
  std::string place;  // how messages about it begin: "file:line: claim 2.1a: "
  std::map<std::string, std::string> texts;  // every key of the form; "" for one that is not there
  std::map<std::string, bool> flags;         // those that the file has
};

// Reads all records of a file.
// path: the file: [[name]] tables, those of the form's `beside`, which are passed over, and nothing else
std::vector<Record> read_records(const std::filesystem::path& path, const RecordForm& form);

// A text that is a list.
std::vector<std::string> words_of(const std::string& text);

}  // namespace tumble::chapters
