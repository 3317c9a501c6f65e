#pragma once

#include <stdexcept>
#include <string>

namespace symscene {

/// Invalid input. The message is one sentence that names where (a file, an option), what was
/// expected and what was found; the three are also there by themselves.
class InputError : public std::runtime_error {
 public:
  InputError(std::string where, std::string expected, std::string found);

  const std::string& where() const { return where_; }
  const std::string& expected() const { return expected_; }
  const std::string& found() const { return found_; }

 private:
  std::string where_;
  std::string expected_;
  std::string found_;
};

/// Throws InputError unless `holds`; for the validate() of options.
void require_option(bool holds, const char* option, const char* expected, double found);

}  // namespace symscene
