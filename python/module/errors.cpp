#include "errors.hpp"

#include <string>

#include "symscene/core/error.hpp"

namespace symscene::python {
namespace {

namespace py = pybind11;

constexpr const char* documentation =
    "Invalid input. The message is one sentence, \"WHERE: expected EXPECTED, found FOUND\", the\n"
    "same that the command prints. The attributes where, expected and found are its parts.";

/// Lives as long as the process, as the translator that uses it.
PyObject* input_error = nullptr;

/// File names need not be UTF-8.
py::object text_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace"));
}

void raise(const InputError& error) {
  const py::object raised = py::handle(input_error)(text_of(error.what()));
  raised.attr("where") = text_of(error.where());
  raised.attr("expected") = text_of(error.expected());
  raised.attr("found") = text_of(error.found());
  PyErr_SetObject(input_error, raised.ptr());
}

}  // namespace

void bind_errors(py::module_& module) {
  input_error =
      PyErr_NewExceptionWithDoc("symscene.InputError", documentation, PyExc_ValueError, nullptr);
  if (input_error == nullptr) throw py::error_already_set();
  module.attr("InputError") = py::handle(input_error);
  module.def(
      "refuse",
      [](const std::string& where, const std::string& expected, const std::string& found) {
        throw InputError(where, expected, found);
      },
      py::arg("where"), py::arg("expected"), py::arg("found"), "Raises InputError of these parts.");
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const InputError& error) {
      raise(error);
    }
  });
}

}  // namespace symscene::python
