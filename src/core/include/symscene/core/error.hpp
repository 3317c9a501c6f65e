#pragma once

#include <stdexcept>
#include <string>

namespace symscene {

/// Invalid input. The message is one sentence, "WHERE: expected EXPECTED, found FOUND", where WHERE
/// is a file or an option; the three parts can also be read separately.
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
