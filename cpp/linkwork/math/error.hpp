#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace linkwork {

/// What an error knows beside its message. Times in s; NaN where it does not apply.
struct ErrorDetails {
  std::vector<std::string> bodies;
  std::vector<std::string> joints;
  std::vector<std::string> forces;
  std::string subject;  ///< what the message begins with: "body 'crank'", say
  std::string field;    ///< which of its fields is wrong: "inertia", a parameter
  int stage = 0;        ///< of the step in which it failed, from 1 on; 0: none
  double time = std::numeric_limits<double>::quiet_NaN();
  double step = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::pair<std::string, double>> residuals;
};

/// Base of everything that linkwork throws: a class, a code, one line for people, and the data behind it.
class Error : public std::runtime_error {
 public:
  Error(const char* kind, std::string code, const std::string& message, ErrorDetails details = {})
      : std::runtime_error(message), details(std::move(details)), kind_(kind), code_(std::move(code)) {}
  const char* kind() const { return kind_; }  ///< name of the class, the same in Python
  const std::string& code() const { return code_; }

  ErrorDetails details;

 private:
  const char* kind_;
  std::string code_;
};

#define LINKWORK_ERROR(NAME)                                                      \
  class NAME : public Error {                                                     \
   public:                                                                        \
    NAME(std::string code, const std::string& message, ErrorDetails details = {}) \
        : Error(#NAME, std::move(code), message, std::move(details)) {}           \
  }

LINKWORK_ERROR(ModelError);           ///< the description of the mechanism is wrong
LINKWORK_ERROR(OptionError);          ///< a choice that does not exist or cannot be honoured
LINKWORK_ERROR(SingularSystemError);  ///< dependent constraint rows, or no unique acceleration
LINKWORK_ERROR(NotConvergedError);    ///< an iteration ended at its cap
LINKWORK_ERROR(NotFiniteError);       ///< a NaN or infinity appeared
LINKWORK_ERROR(ViolationError);       ///< constraints violated beyond the limit of the run
LINKWORK_ERROR(StepSizeError);        ///< no step is small enough for the tolerances
LINKWORK_ERROR(BusyError);            ///< what is called works already

#undef LINKWORK_ERROR

}  // namespace linkwork
