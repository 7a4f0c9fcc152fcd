#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace linkwork {

/// What things that are added at once are called: a prefix for a group, or a name for each.
class Names {
 public:
  Names(std::string prefix) : prefix_(std::move(prefix)) {}
  Names(const char* prefix) : prefix_(prefix) {}
  Names(std::vector<std::string> each) : each_(std::move(each)), group_(false) {}

  bool group() const { return group_; }
  const std::string& prefix() const { return prefix_; }
  const std::vector<std::string>& each() const { return each_; }
  std::string operator[](std::size_t k) const { return group_ ? prefix_ + "[" + std::to_string(k) + "]" : each_[k]; }
  /// Of all of them, for messages.
  std::string text() const { return group_ || each_.empty() ? prefix_ : each_.front(); }
  bool are(std::size_t count) const { return group_ || each_.size() == count; }

 private:
  std::string prefix_;
  std::vector<std::string> each_;
  bool group_ = true;
};

/// Names of bodies, joints or forces: given one by one, or as a prefix for a group ("link" -> "link[0]", "link[1]",
/// ...) so that a million names take no memory.
class NameTable {
 public:
  explicit NameTable(const char* what) : what_(what) {}

  /// Throws a ModelError where the name is taken or empty.
  void add(const std::string& name);
  void add_group(const std::string& prefix, int count);
  /// All of them, or none where one is refused.
  void add(const Names& names, int count);

  int size() const { return size_; }
  std::string name(int index) const;
  /// Index of a name, or -1.
  int find(const std::string& name) const;

 private:
  struct Group {
    std::string prefix;
    int first, count;
    bool single;  ///< one name, not a prefix
  };
  void take(const std::string& name);
  void forget_from(std::size_t group, std::size_t bracketed);
  [[noreturn]] void throw_taken(const std::string& name) const;

  const char* what_;
  int size_ = 0;
  std::vector<Group> groups_;
  std::unordered_map<std::string, int> index_;  ///< name or prefix -> place in groups_
  std::vector<std::string> bracketed_;          ///< single names that end in ], which a group could repeat
};

}  // namespace linkwork
